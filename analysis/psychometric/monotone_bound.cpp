#include "analysis/psychometric/monotone_bound.h"

#include <algorithm>

#include "analysis/psychometric/count_terms.h"
#include "stimuli/support/numbers.h"

namespace seamline::analysis {

namespace {

/// What a level has at most with a probability from `low` to `high`.
double most(const UnitCounts& counts, double low, double high) {
  const double p = std::clamp(counts.k / counts.n, low, std::max(low, high));
  return binomial_term(counts.k, counts.n, p, 1 - p).value;
}

}  // namespace

double MonotoneBound::above(const SoughtLevel& level, double low, double high) const {
  if (problem_.overdispersed) return infinity;
  const double least_guess = problem_.lower[parameter::guess], most_guess = problem_.upper[parameter::guess];
  const double least_lapse = problem_.lower[parameter::lapse], most_lapse = problem_.upper[parameter::lapse];
  double worst_at_level = level.share, best_at_level = level.share;
  if (level.of == SoughtLevel::Of::sigmoid) {
    worst_at_level = least_guess + (1 - least_guess - most_lapse) * level.share;
    best_at_level = most_guess + (1 - most_guess - least_lapse) * level.share;
  }
  double sum = 0;  // priors only lower it: each is at most 0
  for (const UnitCounts& counts : problem_.levels) {
    const bool below = counts.t <= low, beyond = counts.t >= high;
    const bool is_hard = problem_.sign > 0 ? below : beyond, is_easy = problem_.sign > 0 ? beyond : below;
    sum += most(counts, is_easy ? worst_at_level : least_guess, is_hard ? best_at_level : 1 - least_lapse);
  }
  return sum;
}

}  // namespace seamline::analysis
