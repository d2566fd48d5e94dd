#pragma once
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raytracer/common/sampler.h"
#include "raytracer/tracing/geometry.h"
#include "raytracer/tracing/ray.h"

namespace seamline::renderer {

/// Unit direction through an image position in pixels; zero where a lens lets none through.
using ImageDirections = std::function<Eigen::Vector3f(float x, float y)>;

/// One of several eyes that look through one window.
struct CameraEye {
  Eigen::Vector3f place_m = Eigen::Vector3f::Zero();  ///< from the camera's own place
  /// Tangent by which its frustum leans to the right, so that all eyes' frusta meet in the window.
  float lean = 0;
  float right_m = 0;  ///< of panoramas: how far to the right of the axis it stands, facing each direction
};

/// Eyes whose pictures stand side by side in a camera's picture, those of panoramas one above the other
/// (raytracer/scene/eyes.h).
struct CameraEyes {
  std::vector<CameraEye> eyes;  ///< from the left to the right
  int width_px = 0;             ///< of one eye's picture
  float squeeze = 1;            ///< how many times as wide as high a pixel is
  int panorama_rows = 0;        ///< of one eye's panorama; 0: no panoramas
};

/// A pinhole camera at the origin of the renderer's frame (everything is recentred on it), axes of the world.
struct Camera {
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  ///< columns: right, up, back
  float tan_half_horizontal = 0.577F;                  ///< tangent of half the horizontal field of view
  int width_px = 960;
  int height_px = 540;
  /// Of a camera that is no plain pinhole (a lens, a panorama); null: a pinhole. The axes are still whither
  /// it looks.
  std::shared_ptr<const ImageDirections> directions = {};
  /// Of a camera whose picture holds those of several eyes, `width_px` being that of all of them; null: one
  /// eye at the origin.
  std::shared_ptr<const CameraEyes> eyes = {};

  /// Unit direction through image position (x, y) in pixels, (0, 0) being the upper left corner of the
  /// picture. Of a camera of one eye at the origin.
  [[nodiscard]] Eigen::Vector3f direction(float x, float y) const {
    if (directions) return (*directions)(x, y);
    const float scale = 2.0F * tan_half_horizontal / static_cast<float>(width_px);
    const Eigen::Vector3f local((x - 0.5F * static_cast<float>(width_px)) * scale,
                                (0.5F * static_cast<float>(height_px) - y) * scale, -1.0F);
    return (axes * local).normalized();
  }
  /// Unit direction through a place within pixel (x, y), 0 to 1 to the right and down.
  [[nodiscard]] Eigen::Vector3f direction_within(int x, int y, float right, float down) const {
    if (!eyes) return direction(static_cast<float>(x) + right, static_cast<float>(y) + down);
    if (eyes->panorama_rows > 0)
      return direction(static_cast<float>(x) + right, static_cast<float>(y % eyes->panorama_rows) + down);
    const int eye = x / eyes->width_px;
    const float scale = 2.0F * tan_half_horizontal / static_cast<float>(eyes->width_px);
    const float column = static_cast<float>(x - eye * eyes->width_px) + right;
    const float row = static_cast<float>(y) + down;
    const Eigen::Vector3f local((column - 0.5F * static_cast<float>(eyes->width_px)) * scale +
                                    eyes->eyes[static_cast<std::size_t>(eye)].lean,
                                (0.5F * static_cast<float>(height_px) - row) * (scale / eyes->squeeze),
                                -1.0F);
    return (axes * local).normalized();
  }
  /// Unit direction through the centre of a pixel.
  [[nodiscard]] Eigen::Vector3f centre_direction(int x, int y) const {
    return direction_within(x, y, 0.5F, 0.5F);
  }
  /// Where the eye is that sees a pixel.
  [[nodiscard]] Eigen::Vector3f place_m(int x, int y) const {
    if (!eyes) return Eigen::Vector3f::Zero();
    if (eyes->panorama_rows > 0) {
      const Eigen::Vector3f ahead = centre_direction(x, y);
      return eyes->eyes[static_cast<std::size_t>(y / eyes->panorama_rows)].right_m *
             Eigen::Vector3f(-ahead.z(), 0, ahead.x()).normalized();
    }
    return eyes->eyes[static_cast<std::size_t>(x / eyes->width_px)].place_m;
  }
};

/// The camera ray of one sample of a pixel.
[[nodiscard]] inline Ray camera_ray(const Camera& camera, int x, int y, const Sampler& sampler) {
  const Eigen::Array2f jitter = sampler.point(dimension::pixel);
  return {camera.place_m(x, y), camera.direction_within(x, y, jitter[0], jitter[1])};
}

/// Where that ray passes the picture: 0 to 1 across and down.
[[nodiscard]] inline Eigen::Array2f camera_place(const Camera& camera, int x, int y, const Sampler& sampler) {
  const Eigen::Array2f at =
      Eigen::Array2f(static_cast<float>(x), static_cast<float>(y)) + sampler.point(dimension::pixel);
  return at / Eigen::Array2f(static_cast<float>(camera.width_px), static_cast<float>(camera.height_px));
}

/// The camera ray through the centre of a pixel.
[[nodiscard]] inline Ray centre_ray(const Camera& camera, int x, int y) {
  return {camera.place_m(x, y), camera.centre_direction(x, y)};
}

/// The nearest surfaces along camera rays. Those of one eye at the origin need no search in the local scene,
/// which was captured from there (`nearest_from_centre`); those of other eyes do.
inline void nearest_seen(const Camera& camera, const Geometry& geometry, std::span<const Ray> rays,
                         std::span<std::optional<SurfacePoint>> hits, RayCounts* counts = nullptr) {
  if (camera.eyes)
    geometry.nearest(rays, hits, Coherence::together, counts);
  else
    geometry.nearest_from_centre(rays, hits, counts);
}

}  // namespace seamline::renderer
