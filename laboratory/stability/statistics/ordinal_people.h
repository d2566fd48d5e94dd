#pragma once
#include <cstdint>

#include "analysis/ordinal/likelihood/ordinal_data.h"
#include "laboratory/stability/common/namespaces.h"

namespace seamline::stability {

/// People who score three objects at seven widths by a cumulative logit model with a slope of -1.1 an octave;
/// predictors "octaves" (-3 to 3), "object2", "object3".
[[nodiscard]] OrdinalData simulated_ordinal_scores(int people, std::uint64_t seed);

}  // namespace seamline::stability
