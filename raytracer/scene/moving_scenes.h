#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "raytracer/scene/truth_scene.h"

namespace seamline::renderer {

/// Scenes that differ in where their objects stand share everything else: background, light, and the meshes
/// of objects that stand where they stood. What it loads equals `load_truth_scene`, bit for bit.
class MovingScenes {
 public:
  MovingScenes(int width_px, int height_px) : width_px_(width_px), height_px_(height_px) {}
  [[nodiscard]] TruthScene load(const SceneDefinition& definition);

 private:
  int width_px_, height_px_;
  std::map<std::string, TruthScene> loaded_;          ///< by what does not move
  std::map<std::filesystem::path, SceneFile> files_;  ///< of objects that moved
};

}  // namespace seamline::renderer
