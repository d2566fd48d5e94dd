#include "raytracer/scene/moving_scenes.h"

#include <cstddef>

namespace seamline::renderer {
namespace {

/// What scenes share that differ only in where their objects stand.
std::string unmoved_meaning(SceneDefinition scene) {
  for (ObjectDefinition& object : scene.objects)
    object.position_m = object.rotation_deg = Eigen::Vector3d::Zero();
  return canonical_text(scene);
}

bool stands_as(const ObjectDefinition& a, const ObjectDefinition& b) {
  return a.position_m == b.position_m && a.rotation_deg == b.rotation_deg;
}

}  // namespace

TruthScene MovingScenes::load(const SceneDefinition& definition) {
  const auto [found, added] = loaded_.try_emplace(unmoved_meaning(definition));
  if (added) {
    found->second = load_truth_scene(definition, width_px_, height_px_);
    return found->second;
  }
  TruthScene scene = found->second;
  for (std::size_t i = 0; i < definition.objects.size() && i < scene.objects.size(); ++i) {
    const ObjectDefinition& object = definition.objects[i];
    if (stands_as(object, scene.definition.objects[i])) continue;
    auto [file, is_new] = files_.try_emplace(object.path);
    if (is_new) {
      file->second = read_scene_file(object.path, definition.materials);
      for (FileMesh& mesh : file->second.meshes) set_layer(definition, mesh);
    }
    scene.objects[i] =
        place_meshes(file->second, standing_placement(object, file->second, scene, scene.rests),
                     scene.camera_position_m, definition.albedo, static_cast<int>(i) + 1);
  }
  scene.definition = definition;
  return scene;
}

}  // namespace seamline::renderer
