#pragma once
#include <filesystem>

#include "stimuli/study_file/study_file.h"

namespace seamline::test {

/// A picture that renders in seconds and still shows every effect.
inline constexpr int picture_width_px = 192, picture_height_px = 108;

inline StudyDefinition paper_study() {
  return read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "depth_resolution.toml");
}

}  // namespace seamline::test
