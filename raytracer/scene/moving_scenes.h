#pragma once
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "raytracer/scene/truth_scene.h"

namespace seamline::renderer {

/// What scenes share that differ only in where their objects stand, and in what moment of an animation.
[[nodiscard]] std::string unmoved_meaning(SceneDefinition scene);

/// Scenes that differ in where their objects stand share everything else: background, light, and the meshes
/// of objects that stand where they stood. What it loads equals `load_truth_scene`, bit for bit. Where the
/// camera or the background moves, nothing is shared.
class MovingScenes {
 public:
  MovingScenes(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}
  [[nodiscard]] TruthScene load(const SceneDefinition& definition);

 private:
  using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

  [[nodiscard]] Meshes placed(std::size_t object, const SceneDefinition& definition, TruthScene& scene);

  int width_px_, height_px_;
  std::map<std::string, TruthScene> loaded_;          ///< by what does not move
  std::deque<std::string> newest_;                    ///< of `loaded_`, the newest last
  std::map<std::filesystem::path, SceneFile> files_;  ///< of objects that moved and are not animated
  /// By object, pose, and what does not move: the depth of a later frame may show an earlier one.
  std::map<std::string, std::vector<std::weak_ptr<const SurfaceMesh>>> placed_;
};

}  // namespace seamline::renderer
