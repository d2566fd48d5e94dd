#pragma once
#include <string>

#include "sensors/repair/repair.h"

namespace seamline::sensors {

/// What commands call a repair: "nearest", "median" (of 5 x 5 pixels), "joint_bilateral", "planes"; anything
/// else is none.
[[nodiscard]] inline RepairMethod named_repair(const std::string& name) {
  if (name == "nearest") return NearestRepair{};
  if (name == "median") return MedianRepair{.radius_px = 2, .fills = true};
  if (name == "joint_bilateral") return JointBilateralRepair{};
  if (name == "planes") return PlaneRepair{};
  return NoRepair{};
}

}  // namespace seamline::sensors
