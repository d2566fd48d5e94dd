#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "physics/rigid_world.h"

#define SKIP_WITHOUT_BULLET() \
  if (!renderer::has_physics()) GTEST_SKIP() << "Seamline was built without Bullet (libbullet-dev)"

namespace seamline::test {

/// A square floor of so many cells, tilted about Z; `height` adds to y at (x, z).
template <class Height>
renderer::Ground floor_of(int cells, double side_m, double tilt_rad, const Height& height) {
  renderer::Ground ground;
  const double cell_m = side_m / cells;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const double x = i * cell_m - 0.5 * side_m, z = j * cell_m - 0.5 * side_m;
      ground.vertices_m.emplace_back(x, x * std::tan(tilt_rad) + height(x, z), z);
    }
  const auto corner = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      ground.triangles.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
      ground.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
    }
  return ground;
}

inline renderer::Ground flat_floor(int cells, double side_m = 2) {
  return floor_of(cells, side_m, 0, [](double, double) { return 0.0; });
}

inline std::vector<Eigen::Vector3d> box_corners(const Eigen::Vector3d& half_m) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1 ? 1 : -1) * half_m.x(), (i & 2 ? 1 : -1) * half_m.y(),
                         (i & 4 ? 1 : -1) * half_m.z());
  return corners;
}

inline renderer::HullShape box_hull(const Eigen::Vector3d& half_m) {
  return {box_corners(half_m)};
}

inline Eigen::Isometry3d pose_at(const Eigen::Vector3d& place_m, double about_z_rad = 0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place_m;
  pose.rotate(Eigen::AngleAxisd(about_z_rad, Eigen::Vector3d::UnitZ()));
  return pose;
}

inline void run(renderer::RigidWorld& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step();
}

}  // namespace seamline::test
