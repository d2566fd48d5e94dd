#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

#include "stimuli/study_file/study_file.h"

namespace seamline::test {

/// A picture that renders in seconds and still shows every effect.
inline constexpr int picture_width_px = 192, picture_height_px = 108;
inline constexpr int threads = 2;

inline StudyDefinition paper_study() {
  return read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "depth_resolution.toml");
}

inline SceneDefinition scene_named(const std::string& name, const StudyDefinition& study = paper_study()) {
  for (const SceneDefinition& scene : study.scenes)
    if (scene.name == name) return scene;
  throw std::runtime_error("no scene " + name);
}

}  // namespace seamline::test
