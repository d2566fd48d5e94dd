#pragma once
#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

namespace seamline::renderer {

/// A solid between triangles, wound outwards.
struct Solid {
  std::vector<Eigen::Vector3d> corners_m;
  std::vector<std::array<int, 3>> triangles;
};

/// Volume, its first and second moments; of even density.
struct VolumeMoments {
  double volume_m3 = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
};
[[nodiscard]] VolumeMoments moments_of(const Solid& solid);

/// The planes of a convex solid's triangles: normal, outwards, and distance from the origin along it.
/// Triangles that are lines have none.
[[nodiscard]] std::vector<std::pair<Eigen::Vector3d, double>> faces_of(const Solid& solid);

}  // namespace seamline::renderer
