#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {

/// How a known camera or data set writes depth.
struct DepthUnit {
  const char* name;
  double metres_per_step;       ///< of 1
  std::vector<double> nothing;  ///< values that stand for no depth, beside 0
  const char* sentence;         ///< of whom, for a page and a manual
};

/// All of them, in the order in which they are listed.
[[nodiscard]] std::span<const DepthUnit> depth_units();

/// One by its name. Throws InputError naming `field` and the names that there are.
[[nodiscard]] const DepthUnit& depth_unit(const std::string& name, const std::string& field);

}  // namespace seamline::sensors
