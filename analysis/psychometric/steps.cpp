// The limit of scale 0. With counts K of N on a side its likeliest guess or lapse is K/N or 1 - K/N within
// its bounds, so every step is one line of arithmetic.
#include <algorithm>
#include <cmath>

#include "analysis/psychometric/count_terms.h"
#include "analysis/psychometric/search.h"
#include "analysis/psychometric/sigmoid_shape.h"
#include "stimuli/support/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double gaps_in_step_scale = 0.005;  ///< 100 scales on either side of the middle of a gap

struct Side {
  double k = 0, n = 0;
};

double share_within(const Side& side, double low, double high) {
  return side.n > 0 ? std::clamp(side.k / side.n, low, high) : low;
}

double term(const Side& side, double p) {
  return side.n > 0 ? binomial_term(side.k, side.n, p, 1 - p).value : 0;
}

/// A step with `first` levels on one side, and the next one in the middle if `through` it.
struct Candidate {
  std::size_t first = 0;
  bool through = false;
  double value = -infinity;
  double guess = 0, lapse = 0;
};

Candidate candidate(const FitProblem& problem, Side guessing, Side seeing) {
  Candidate found;
  found.guess = share_within(guessing, problem.lower[parameter::guess], problem.upper[parameter::guess]);
  found.lapse =
      1 - share_within(seeing, 1 - problem.upper[parameter::lapse], 1 - problem.lower[parameter::lapse]);
  if (seeing.n == 0) found.lapse = problem.lower[parameter::lapse];
  found.value = term(guessing, found.guess) + term(seeing, 1 - found.lapse);
  return found;
}

Candidate best_candidate(const FitProblem& problem) {
  Side all, before;
  for (const UnitCounts& level : problem.levels) all = {all.k + level.k, all.n + level.n};
  Candidate best;
  const auto consider = [&](const Side& low, const Side& high, std::size_t first, const UnitCounts* middle) {
    const bool rising = problem.sign > 0;
    Candidate found = candidate(problem, rising ? low : high, rising ? high : low);
    if (middle != nullptr) {
      const double p = middle->k / middle->n;
      if (p <= found.guess || p >= 1 - found.lapse) return;
      found.value += term({middle->k, middle->n}, p);
    }
    found.first = first;
    found.through = middle != nullptr;
    if (found.value > best.value + 1e-12) best = found;
  };
  for (std::size_t i = 0; i <= problem.levels.size(); ++i) {
    const Side after{all.k - before.k, all.n - before.n};
    consider(before, after, i, nullptr);
    if (i == problem.levels.size()) break;
    const UnitCounts& level = problem.levels[i];
    consider(before, {after.k - level.k, after.n - level.n}, i, &level);
    before = {before.k + level.k, before.n + level.n};
  }
  return best;
}

StepFit described(const FitProblem& problem, const Candidate& step) {
  StepFit fit;
  const auto& levels = problem.levels;
  const std::size_t above = step.first + (step.through ? 1 : 0);
  if (step.first > 0) fit.low_t = levels[step.first - 1].t;
  if (above < levels.size()) fit.high_t = levels[above].t;
  fit.through_level = step.through;
  const double margin = problem.median_gap / 2;
  const double low = step.first > 0 ? fit.low_t : levels.front().t - 2 * margin;
  const double high = above < levels.size() ? fit.high_t : levels.back().t + 2 * margin;
  Theta& theta = fit.maximum.theta;
  double scale = gaps_in_step_scale * (high - low), place = low + (high - low) / 2;
  if (step.through) {
    const UnitCounts& level = levels[step.first];
    scale = gaps_in_step_scale * std::min(high - level.t, level.t - low);
    const double F = (level.k / level.n - step.guess) / (1 - step.guess - step.lapse);
    place = level.t - problem.sign * scale * sigmoid_quantile(problem.sigmoid, F);
  }
  theta = {place, std::log(scale), step.lapse, step.guess};
  theta[parameter::threshold] = std::clamp(place, problem.lower[0], problem.upper[0]);
  return fit;
}

}  // namespace

std::optional<StepFit> likeliest_step(const FitProblem& problem) {
  if (problem.priors.log2_width) return std::nullopt;
  const Candidate step = best_candidate(problem);
  if (!std::isfinite(step.value)) return std::nullopt;
  StepFit fit = described(problem, step);
  if (problem.priors.lapse || problem.priors.threshold || problem.overdispersed) {
    const Held held{.fixed = {true, true, false, false}, .level = {}};
    fit.maximum = maximise(problem, held, fit.maximum.theta, 0);
  } else {
    fit.maximum.value = log_likelihood(problem, fit.maximum.theta, 0);
  }
  fit.maximum.converged = true;
  return fit;
}

}  // namespace seamline::analysis
