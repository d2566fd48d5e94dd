#pragma once
#include <cstdint>

#include "support/arithmetic/random.h"

namespace seamline::analysis {

/// A binomial count by inversion, from the mode outwards: exact, one uniform number a draw, time proportional
/// to the standard deviation (a million trials cost about as much as a thousand coin flips).
[[nodiscard]] std::int64_t sample_binomial(std::int64_t trials, double probability, Random& random);

}  // namespace seamline::analysis
