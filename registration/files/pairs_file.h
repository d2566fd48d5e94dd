#pragma once
#include <filesystem>
#include <vector>

#include "registration/calibration/calibrate.h"

namespace seamline::registration {

/// Pairs from a CSV file with the columns u, v (pixels of the photograph, the centre of the first pixel being
/// (0.5, 0.5)), x, y, z (metres, in the depth camera's frame) and confidence (any scale, more is better).
struct PairsFile {
  std::vector<PointPair> pairs;  ///< those with a confidence of at least `least_confidence`
  std::int64_t left_out = 0;
};

/// Throws InputError naming file, line and column, wanted and found: for what is no number, or no place.
[[nodiscard]] PairsFile read_pairs(const std::filesystem::path& path, double least_confidence);

}  // namespace seamline::registration
