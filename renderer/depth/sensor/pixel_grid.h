#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "renderer/depth/lattice/grid_vertex.h"
#include "sensors/frame/depth_frame.h"

namespace seamline::renderer {

/// A depth frame and where its camera is taken to be in the world.
struct PlacedFrame {
  sensors::DepthFrame frame;
  Eigen::Isometry3d world_from_frame = Eigen::Isometry3d::Identity();
};

/// The points of a frame's pixels in the world, as a mesh stores them, row by row; infinite in holes.
struct PixelGrid {
  sensors::PinholeCamera camera;
  Eigen::Vector3d eye_m = Eigen::Vector3d::Zero();  ///< from which the frame was seen
  std::vector<Eigen::Vector3f> points_m;

  [[nodiscard]] std::size_t index(const GridVertex& v) const {
    return static_cast<std::size_t>(v.row) * static_cast<std::size_t>(camera.width_px) +
           static_cast<std::size_t>(v.column);
  }
  [[nodiscard]] bool valid(const GridVertex& v) const { return std::isfinite(points_m[index(v)].x()); }
  /// From the eye.
  [[nodiscard]] Eigen::Vector3d seen_m(const GridVertex& v) const {
    return points_m[index(v)].cast<double>() - eye_m;
  }
};

[[nodiscard]] PixelGrid pixel_grid(const PlacedFrame& placed, int threads);

/// Whether the distances of three corners differ by more than the ratio: something else is behind.
[[nodiscard]] bool is_jump(double a_m, double b_m, double c_m, double ratio);

}  // namespace seamline::renderer
