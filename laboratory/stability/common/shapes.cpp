#include "laboratory/stability/common/shapes.h"

#include <cmath>
#include <numbers>

namespace seamline::stability {

PartPointer shape_of(std::vector<Eigen::Vector3f> positions_m, std::vector<Triangle> triangles,
                     const Matter& matter) {
  auto part = std::make_shared<SurfaceMesh>();
  part->name = "shape";
  part->positions_m = std::move(positions_m);
  part->triangles = std::move(triangles);
  part->albedo = Rgb::Constant(matter.albedo);
  part->emission = Rgb::Constant(matter.emission);
  part->object_index = matter.object_index;
  return part;
}

PartPointer ball_shape(const Eigen::Vector3f& centre_m, float radius_m, int around, const Matter& matter) {
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Triangle> triangles;
  const int rows = around / 2;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < around; ++column) {
      const double polar = std::numbers::pi * row / rows, azimuth = 2 * std::numbers::pi * column / around;
      const Eigen::Vector3d unit(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                 std::sin(polar) * std::sin(azimuth));
      positions_m.push_back(centre_m + radius_m * unit.cast<float>());
    }
  const auto at = [&](int row, int column) {
    return static_cast<std::uint32_t>(row * around + column % around);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < around; ++column) {
      if (row > 0) triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column)});
      if (row + 1 < rows)
        triangles.push_back({at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)});
    }
  return shape_of(std::move(positions_m), std::move(triangles), matter);
}

PartPointer box_shape(const Eigen::Vector3f& least_m, const Eigen::Vector3f& most_m, const Matter& matter) {
  std::vector<Eigen::Vector3f> corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.emplace_back((i & 1U) != 0 ? most_m.x() : least_m.x(), (i & 2U) != 0 ? most_m.y() : least_m.y(),
                         (i & 4U) != 0 ? most_m.z() : least_m.z());
  return shape_of(std::move(corners),
                  {{0, 1, 3},
                   {0, 3, 2},
                   {4, 6, 7},
                   {4, 7, 5},
                   {0, 4, 5},
                   {0, 5, 1},
                   {2, 3, 7},
                   {2, 7, 6},
                   {0, 2, 6},
                   {0, 6, 4},
                   {1, 5, 7},
                   {1, 7, 3}},
                  matter);
}

PartPointer plane_shape(const PlaneSquare& square, const Matter& matter) {
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Triangle> triangles;
  const int n = square.cells;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      positions_m.push_back((square.centre_m + square.half_size_m * ((2.0 * i / n - 1) * square.u +
                                                                     (2.0 * j / n - 1) * square.v))
                                .cast<float>());
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return shape_of(std::move(positions_m), std::move(triangles), matter);
}

TruthScene truth_scene_of(const SmallScene& small) {
  TruthScene scene;
  scene.definition.name = "stability";
  scene.definition.albedo = 0.5;
  scene.background = small.background;
  scene.objects[0] = small.object;
  scene.camera.width_px = small.width_px;
  scene.camera.height_px = small.height_px;
  scene.light = small.light;
  return scene;
}

Light sun_and_sky(const Eigen::Vector3f& to_sun, float irradiance_w_m2, float sky_radiance, int bounces) {
  Light light;
  light.suns.push_back({to_sun.normalized(), Rgb::Constant(irradiance_w_m2), 0.0F});
  light.environment_radiance = Rgb::Constant(sky_radiance);
  light.bounces = bounces;
  return light;
}

}  // namespace seamline::stability
