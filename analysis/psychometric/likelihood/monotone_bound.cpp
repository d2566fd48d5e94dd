#include "analysis/psychometric/likelihood/monotone_bound.h"

#include <algorithm>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// The likeliest probabilities that do not fall from count to count, by pooling adjacent violators, held
/// within [low, high]: ln L.
double likeliest_rising(const std::vector<UnitCounts>& counts, double low, double high) {
  std::vector<UnitCounts> blocks;
  for (const UnitCounts& level : counts) {
    blocks.push_back(level);
    while (blocks.size() > 1) {
      const UnitCounts& last = blocks.back();
      UnitCounts& before = blocks[blocks.size() - 2];
      if (before.k * last.n <= last.k * before.n) break;
      before.k += last.k;
      before.n += last.n;
      blocks.pop_back();
    }
  }
  double sum = 0;
  for (const UnitCounts& block : blocks) {
    const double p = std::clamp(block.k / block.n, low, std::max(low, high));
    sum += binomial_term(block.k, block.n, p, 1 - p).value;
  }
  return sum;
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
  // In the order in which the task gets easier: harder than the level sought, about it, easier.
  std::vector<UnitCounts> hard, about, easy;
  const auto sort = [&](const UnitCounts& counts) {
    const bool below = counts.t <= low, beyond = counts.t >= high;
    if (below == beyond)
      about.push_back(counts);
    else
      (below == (problem_.sign > 0) ? hard : easy).push_back(counts);
  };
  if (problem_.sign > 0)
    std::for_each(problem_.levels.begin(), problem_.levels.end(), sort);
  else
    std::for_each(problem_.levels.rbegin(), problem_.levels.rend(), sort);
  return best_without_stimulus(problem_) + likeliest_rising(hard, least_guess, best_at_level) +
         likeliest_rising(about, least_guess, 1 - least_lapse) +
         likeliest_rising(easy, worst_at_level, 1 - least_lapse);  // priors only lower it: each is at most 0
}

}  // namespace seamline::analysis
