#pragma once
#include <cmath>
#include <memory>
#include <numbers>

#include "renderer/truth_pass.h"

/// Small shapes and scenes whose light is known by hand.
namespace seamline::test {

inline std::shared_ptr<const Part> part_of(std::vector<Eigen::Vector3f> positions,
                                           std::vector<Triangle> triangles, float albedo,
                                           const std::string& name, int object_index = 0) {
  auto part = std::make_shared<Part>();
  part->name = name;
  part->positions_m = std::move(positions);
  part->triangles = std::move(triangles);
  part->albedo = Rgb::Constant(albedo);
  part->object_index = object_index;
  return part;
}

/// A sphere of `around` x `around / 2` facets.
inline std::shared_ptr<const Part> sphere(const Eigen::Vector3f& centre, float radius, int around,
                                          float albedo, int object_index = 0, float emission = 0.0F) {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Triangle> triangles;
  const int rows = around / 2;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < around; ++column) {
      const double polar = std::numbers::pi * row / rows, azimuth = 2 * std::numbers::pi * column / around;
      const Eigen::Vector3d unit(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                 std::sin(polar) * std::sin(azimuth));
      positions.push_back(centre + radius * unit.cast<float>());
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
  auto part = std::make_shared<Part>(
      *part_of(std::move(positions), std::move(triangles), albedo, "sphere", object_index));
  part->emission = Rgb::Constant(emission);
  return part;
}

/// An axis-aligned box, seen from inside or outside.
inline std::shared_ptr<const Part> box(const Eigen::Vector3f& least, const Eigen::Vector3f& most,
                                       float albedo, int object_index = 0, const std::string& name = "box") {
  std::vector<Eigen::Vector3f> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1) ? most.x() : least.x(), (i & 2) ? most.y() : least.y(),
                         (i & 4) ? most.z() : least.z());
  return part_of(corners,
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
                 albedo, name, object_index);
}

/// A square of the plane y = height, centred below `centre`.
inline std::shared_ptr<const Part> floor(float height, float half_size, float albedo = 0.5F,
                                         float centre_z = -4.0F) {
  return part_of({{-half_size, height, centre_z - half_size},
                  {half_size, height, centre_z - half_size},
                  {half_size, height, centre_z + half_size},
                  {-half_size, height, centre_z + half_size}},
                 {{0, 2, 1}, {0, 3, 2}}, albedo, "floor");
}

/// A scene with a camera at the origin that looks along -Z, and up to three objects.
struct SceneParts {
  std::vector<std::shared_ptr<const Part>> background;
  std::array<std::vector<std::shared_ptr<const Part>>, 3> objects;
};

inline TruthScene scene_of(SceneParts parts, Light light, int width_px = 64, int height_px = 36) {
  TruthScene scene;
  scene.definition.name = "test";
  scene.definition.albedo = 0.5;
  scene.background = std::move(parts.background);
  scene.objects = std::move(parts.objects);
  scene.camera.width_px = width_px;
  scene.camera.height_px = height_px;
  scene.light = std::move(light);
  return scene;
}

}  // namespace seamline::test
