#pragma once
#include <memory>

#include "laboratory/stability/common/shapes.h"
#include "renderer/estimators/path/path_truth_pass.h"

/// Small shapes and scenes whose light is known by hand.
namespace seamline::test {
using namespace renderer;
using namespace stability;

inline std::shared_ptr<const SurfaceMesh> part_of(std::vector<Eigen::Vector3f> positions,
                                                  std::vector<Triangle> triangles, float albedo,
                                                  const std::string& name, int object_index = 0) {
  auto part = std::make_shared<SurfaceMesh>(*shape_of(std::move(positions), std::move(triangles),
                                                      {.albedo = albedo, .object_index = object_index}));
  part->name = name;
  return part;
}

/// A sphere of `around` x `around / 2` facets.
inline std::shared_ptr<const SurfaceMesh> sphere(const Eigen::Vector3f& centre, float radius, int around,
                                                 float albedo, int object_index = 0, float emission = 0.0F) {
  return ball_shape(centre, radius, around,
                    {.albedo = albedo, .emission = emission, .object_index = object_index});
}

/// An axis-aligned box, seen from inside or outside.
inline std::shared_ptr<const SurfaceMesh> box(const Eigen::Vector3f& least, const Eigen::Vector3f& most,
                                              float albedo, int object_index = 0) {
  return box_shape(least, most, {.albedo = albedo, .object_index = object_index});
}

/// A square of the plane y = height, centred below `centre`.
inline std::shared_ptr<const SurfaceMesh> floor(float height, float half_size, float albedo = 0.5F,
                                                float centre_z = -4.0F) {
  return part_of({{-half_size, height, centre_z - half_size},
                  {half_size, height, centre_z - half_size},
                  {half_size, height, centre_z + half_size},
                  {-half_size, height, centre_z + half_size}},
                 {{0, 2, 1}, {0, 3, 2}}, albedo, "floor");
}

/// A scene with a camera at the origin that looks along -Z, and up to three objects.
struct SceneParts {
  std::vector<std::shared_ptr<const SurfaceMesh>> background;
  std::vector<std::vector<std::shared_ptr<const SurfaceMesh>>> objects =
      std::vector<std::vector<std::shared_ptr<const SurfaceMesh>>>(3);
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
