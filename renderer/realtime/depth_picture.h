#pragma once
#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

/// From where depth is drawn: along parallel lines, as a sun does, or from a point, as lamps and cameras do.
/// Depth is planar, along `forward`; image positions grow to the right and down.
struct DrawView {
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  ///< rows: right, down, forward; orthonormal
  bool from_point = false;
  Eigen::Vector3f eye_m = Eigen::Vector3f::Zero();  ///< where from, if from a point
  /// The part of the picture plane that is drawn: metres, or tangents of angles from a point.
  Eigen::Array2f corner = Eigen::Array2f::Constant(-1), size = Eigen::Array2f::Constant(2);
};

/// One depth a pixel, of pixel centres; infinity where there is nothing.
struct DepthPicture {
  int width_px = 0, height_px = 0;
  std::vector<float> depth_m;  ///< row by row

  [[nodiscard]] float at(int x, int y) const {
    return depth_m[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                   static_cast<std::size_t>(x)];
  }
};

/// A point as a view sees it.
struct ViewedPoint {
  float x_px, y_px;
  float depth_m;  ///< from a point not above 0: behind it, and the position says nothing
};
[[nodiscard]] ViewedPoint view_point(const DrawView& view, const DepthPicture& picture,
                                     const Eigen::Vector3f& point_m);

/// The largest whole number not above `value`, and the smallest not below it. `std::floor` is a call of a
/// function on processors of 2003, for which Debian builds; here it was a tenth of a frame.
[[nodiscard]] inline int whole_below(float value) {
  const int cut = static_cast<int>(value);
  return cut - (static_cast<float>(cut) > value ? 1 : 0);
}
[[nodiscard]] inline int whole_above(float value) {
  const int cut = static_cast<int>(value);
  return cut + (static_cast<float>(cut) < value ? 1 : 0);
}

/// Depth of the pixel that a position lies in; infinity outside the picture.
[[nodiscard]] inline float depth_at(const DepthPicture& picture, float x_px, float y_px) {
  if (!(x_px >= 0.0F && y_px >= 0.0F && x_px < static_cast<float>(picture.width_px) &&
        y_px < static_cast<float>(picture.height_px)))
    return std::numeric_limits<float>::infinity();
  return picture.at(static_cast<int>(x_px), static_cast<int>(y_px));
}

/// Triangles to draw.
struct TriangleSpan {
  std::span<const Eigen::Vector3f> positions_m;
  std::span<const Triangle> triangles;
};

/// Draws the nearest depth of triangles into a picture that has its size: both sides of all, at every pixel
/// centre that a triangle covers, edges included, so that meshes have no holes. What lies nearer to a point
/// of view than 1 mm is cut off. The picture is cut into bands for threads; the same bytes for any number of
/// them. (Rays of Embree give the same picture in more time where the mesh changes each frame:
/// documentation/how-to/realtime.md.)
void draw_depth(const DrawView& view, std::span<const TriangleSpan> meshes, int threads,
                DepthPicture& picture);

/// An empty picture of a size.
[[nodiscard]] DepthPicture empty_picture(int width_px, int height_px);

/// Axes of a view that looks along a unit direction.
[[nodiscard]] Eigen::Matrix3f axes_along(const Eigen::Vector3f& forward);

}  // namespace seamline::renderer
