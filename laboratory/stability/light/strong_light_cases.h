#pragma once
#include "laboratory/stability/common/stability_case.h"
#include "renderer/estimators/estimator.h"

namespace seamline::stability {

/// Every number of a scene at the largest that is accepted: pixels that are no number, of pictures and their
/// estimated errors.
[[nodiscard]] Finding try_strongest_light(Estimator estimator, int threads);

/// Files with lights and emissions that no sum can hold, or that are negative: how many are read.
[[nodiscard]] Finding try_impossible_lights();

}  // namespace seamline::stability
