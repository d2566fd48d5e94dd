#include "raytracer/scene/moving_scenes.h"

#include <fmt/core.h>

#include <cstddef>
#include <optional>

#include "raytracer/scene/scene_moment.h"

namespace seamline::renderer {
namespace {

/// Scenes whose camera or background moves are of no use to each other.
constexpr std::size_t most_kept = 8;

bool stands_as(const ObjectDefinition& a, const ObjectDefinition& b) {
  return a.position_m == b.position_m && a.rotation_deg == b.rotation_deg && a.file == b.file;
}

}  // namespace

std::string unmoved_meaning(SceneDefinition scene) {
  for (ObjectDefinition& object : scene.objects) {
    object.position_m = object.rotation_deg = Eigen::Vector3d::Zero();
    object.file = split_moment(object.file).file;
  }
  return canonical_text(scene);
}

TruthScene MovingScenes::load(const SceneDefinition& definition) {
  const std::string meaning = unmoved_meaning(definition);
  const auto [found, added] = loaded_.try_emplace(meaning);
  if (added) {
    found->second = load_truth_scene(definition, width_px_, height_px_);
    newest_.push_back(meaning);
    TruthScene scene = found->second;
    if (newest_.size() > most_kept) {
      loaded_.erase(newest_.front());
      newest_.pop_front();
    }
    return scene;
  }
  TruthScene scene = found->second;
  for (std::size_t i = 0; i < definition.objects.size() && i < scene.objects.size(); ++i)
    if (!stands_as(definition.objects[i], scene.definition.objects[i]))
      scene.objects[i] = placed(i, definition, scene);
  scene.definition = definition;
  return scene;
}

/// An object's meshes where it stands now. Those that somebody still holds are taken again.
MovingScenes::Meshes MovingScenes::placed(std::size_t object, const SceneDefinition& definition,
                                          TruthScene& scene) {
  const ObjectDefinition& now = definition.objects[object];
  SceneDefinition alone = definition;
  alone.objects = {now};
  auto& known = placed_[fmt::format("{} {}", object, canonical_text(alone))];
  Meshes meshes;
  for (const auto& one : known)
    if (auto mesh = one.lock()) meshes.push_back(std::move(mesh));
  if (!meshes.empty() && meshes.size() == known.size()) return meshes;
  std::optional<SceneFile> animated;
  const SceneFile* file = nullptr;
  if (split_moment(now.file).moment) {
    file = &animated.emplace(read_object_file(now, definition));
  } else {
    auto [kept, is_new] = files_.try_emplace(now.path);
    if (is_new) kept->second = read_object_file(now, definition);
    file = &kept->second;
  }
  meshes = place_meshes(*file, standing_placement(now, *file, scene, scene.rests), scene.camera_position_m,
                        definition.albedo, static_cast<int>(object) + 1);
  known.assign(meshes.begin(), meshes.end());
  return meshes;
}

}  // namespace seamline::renderer
