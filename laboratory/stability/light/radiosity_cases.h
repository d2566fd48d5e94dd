#pragma once
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// A closed sphere that emits 1 everywhere.
struct ClosedSphere {
  float albedo = 0.5F;
  int bounces = 4;
  bool object_inside = false;  ///< a ball of the same matter hangs in it, as the virtual object
};

/// Every path must bring the sum of albedo^k for k = 0 to bounces + 1, through `radiance_with_and_without`
/// (path estimator), in both worlds. The error is the largest relative one of any path.
[[nodiscard]] Finding try_closed_sphere(const ClosedSphere& sphere);
/// The same through `PathBatch` (fast estimator).
[[nodiscard]] Finding try_closed_sphere_fast(const ClosedSphere& sphere);

}  // namespace seamline::stability
