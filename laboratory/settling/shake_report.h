#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "laboratory/settling/shake.h"

namespace seamline::renderer {

/// The shake at another number of steps a second, on exact depth.
struct StepShake {
  int steps_per_s = 240;
  double jump_mm = 0;  ///< root mean square from one frame to the next
};

/// Writes `poses.csv` (of the object's file, frame by frame), `shake.csv` (a line for each depth and number
/// of steps), `data_dictionary.csv` and the figure `shake.svg`.
void write_falls(const std::filesystem::path& folder, const std::vector<Fall>& falls,
                 const std::vector<StepShake>& by_steps, const FallRequest& request,
                 const std::string& heading);

/// One line a depth, for the terminal.
[[nodiscard]] std::string fall_sentence(const Fall& fall);

}  // namespace seamline::renderer
