#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sensors/skeleton/cyclic_descent.h"

namespace seamline::sensors {

/// Where joints were, moment after moment.
struct RecordedMotion {
  std::vector<std::string> joints;       ///< in the order in which the file names them first
  std::vector<double> times_s;           ///< since the first moment, rising
  std::vector<MeasuredJoints> places_m;  ///< of each moment, by joint
};

/// Reads a table (.csv) with the columns `time_s`, `joint`, `x_m`, `y_m`, `z_m`: a row for each joint that
/// was seen in a moment, moments one after another. Throws InputError naming file and line for a time before
/// the last one or not told from it in the 32 bits of a glTF file, a joint twice in a moment, and a place
/// that is none; and for a file without rows.
[[nodiscard]] RecordedMotion read_recorded_motion(const std::filesystem::path& path);

}  // namespace seamline::sensors
