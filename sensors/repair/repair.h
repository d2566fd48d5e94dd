#pragma once
#include <variant>

#include "sensors/repair/joint_bilateral.h"
#include "sensors/repair/median.h"
#include "sensors/repair/nearest.h"
#include "sensors/repair/planes.h"

namespace seamline::sensors {

struct NoRepair {
  auto operator<=>(const NoRepair&) const = default;
};
struct NearestRepair {
  auto operator<=>(const NearestRepair&) const = default;
};

/// What is done to measured depth before it is used.
using RepairMethod = std::variant<NoRepair, NearestRepair, MedianRepair, JointBilateralRepair, PlaneRepair>;

/// Does it. `photograph` is what the joint bilateral filter is guided by, in the depth's own pixels; the
/// other methods do not look at it. Throws InputError where it is wanted and null, and as the methods do.
[[nodiscard]] Repaired repair(const DepthFrame& measured, const RepairMethod& method,
                              const Image* photograph = nullptr, int threads = 0);

}  // namespace seamline::sensors
