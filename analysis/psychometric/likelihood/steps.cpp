// The limit of scale 0. With counts K of N on a side its likeliest guess or lapse is K/N or 1 - K/N within
// its bounds, so every step is one line of arithmetic.
#include "analysis/psychometric/likelihood/steps.h"

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "study/placement/sigmoid_shape.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double gaps_in_step_scale = 0.005;   ///< 100 scales on either side of the middle of a gap
constexpr double largest_scale_on_ridge = 10;  ///< ranges of the levels
constexpr double as_likely = 0.01;             ///< log units: far less than what any interval allows
constexpr double ridge_depth = 2;              ///< log units, as deep as a 95 % interval goes
constexpr std::size_t ridge_parts = 16;
constexpr double scale_stride = 1.5;
constexpr int halvings = 8;            ///< of the ratio of two scales
constexpr std::size_t neighbours = 8;  ///< levels on either side that notice a scale first

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
  if (problem.equal_rates)
    found.guess = found.lapse =
        share_within({.k = guessing.k + seeing.n - seeing.k, .n = guessing.n + seeing.n},
                     problem.lower[parameter::lapse], problem.upper[parameter::lapse]);
  found.value = term(guessing, found.guess) + term(seeing, 1 - found.lapse);
  return found;
}

/// Every step, in the order of levels: before the first, through it, between it and the second, ...
template <class Consider>
void for_each_candidate(const FitProblem& problem, const Consider& consider) {
  Side before{.k = problem.no_stimulus.k, .n = problem.no_stimulus.n}, all = before;
  for (const UnitCounts& level : problem.levels) all = {all.k + level.k, all.n + level.n};
  const bool rising = problem.sign > 0;
  const auto at = [&](const Side& low, const Side& high, std::size_t first, const UnitCounts* middle) {
    Candidate found = candidate(problem, rising ? low : high, rising ? high : low);
    if (middle != nullptr) {
      const double p = middle->k / middle->n;
      if (p <= found.guess || p >= 1 - found.lapse) return;
      found.value += term({middle->k, middle->n}, p);
    }
    found.first = first;
    found.through = middle != nullptr;
    consider(found);
  };
  for (std::size_t i = 0; i <= problem.levels.size(); ++i) {
    const Side after{all.k - before.k, all.n - before.n};
    at(before, after, i, nullptr);
    if (i == problem.levels.size()) break;
    const UnitCounts& level = problem.levels[i];
    at(before, {after.k - level.k, after.n - level.n}, i, &level);
    before = {before.k + level.k, before.n + level.n};
  }
}

/// The function of a scale on the step's ridge.
Theta on_ridge(const FitProblem& problem, const Candidate& step, double place, double scale) {
  double m = place;
  if (step.through) {
    const UnitCounts& level = problem.levels[step.first];
    const double F = (level.k / level.n - step.guess) / (1 - step.guess - step.lapse);
    m = level.t - problem.sign * scale * study::sigmoid_quantile(problem.sigmoid, F);
  }
  return {std::clamp(m, problem.lower[0], problem.upper[0]), std::log(scale), step.lapse, step.guess};
}

/// ln L of the levels around the step.
double near_likelihood(const FitProblem& problem, const Candidate& step, const Theta& theta) {
  const std::size_t first = step.first > neighbours ? step.first - neighbours : 0;
  const std::size_t end = std::min(problem.levels.size(), step.first + neighbours + 1);
  double sum = 0;
  for (std::size_t i = first; i < end; ++i) {
    const UnitCounts& level = problem.levels[i];
    const ResponseProbability p = probability_at(problem, theta, level.t);
    sum += binomial_term(level.k, level.n, p.right, p.wrong).value;
  }
  return sum;
}

/// The scale on the ridge up to which the levels around lose at most `allowed`, from `steep` on. Much broader
/// functions through the level may be likely again; they are no part of the ridge.
double largest_scale(const FitProblem& problem, const Candidate& step, double place, double steep,
                     double allowed) {
  const auto value = [&](double scale) {
    return near_likelihood(problem, step, on_ridge(problem, step, place, scale));
  };
  const double needed = value(steep) - allowed;
  double inside = steep, outside = steep * scale_stride;
  while (outside < largest_scale_on_ridge && value(outside) >= needed) {
    inside = outside;
    outside *= scale_stride;
  }
  for (int i = 0; i < halvings; ++i) {
    const double tried = std::sqrt(inside * outside);
    (value(tried) >= needed ? inside : outside) = tried;
  }
  return inside;
}

/// Fills `ridge_scales` by sums over scales from 0 to where the neighbours lose `ridge_depth`.
void weigh_ridge(const FitProblem& problem, const Candidate& step, double place, double steep, StepFit& fit) {
  const double top = near_likelihood(problem, step, on_ridge(problem, step, place, steep));
  const double widest = largest_scale(problem, step, place, steep, ridge_depth);
  std::array<double, ridge_parts + 1> below{};
  for (std::size_t i = 0; i < ridge_parts; ++i) {
    const double scale = widest * (static_cast<double>(i) + 0.5) / ridge_parts;
    const double loss = top - near_likelihood(problem, step, on_ridge(problem, step, place, scale));
    below[i + 1] = below[i] + std::exp(-std::max(0.0, loss));
  }
  std::size_t part = 0;
  const std::size_t last = fit.ridge_scales.size() - 1;
  for (std::size_t i = 1; i <= last; ++i) {
    const double wanted = below.back() * static_cast<double>(i) / static_cast<double>(last);
    while (part + 1 < ridge_parts && below[part + 1] < wanted) ++part;
    const double share = (wanted - below[part]) / (below[part + 1] - below[part]);
    fit.ridge_scales[i] = widest * (static_cast<double>(part) + std::min(share, 1.0)) / ridge_parts;
  }
}

StepFit described(const FitProblem& problem, const Candidate& step) {
  StepFit fit;
  const auto& levels = problem.levels;
  const std::size_t above = step.first + (step.through ? 1 : 0);
  const double margin = problem.median_gap / 2;
  const double low = step.first > 0 ? levels[step.first - 1].t : levels.front().t - 2 * margin;
  const double high = above < levels.size() ? levels[above].t : levels.back().t + 2 * margin;
  const double place = step.through ? levels[step.first].t : low + (high - low) / 2;
  const double steep = gaps_in_step_scale * (step.through ? std::min(high - place, place - low) : high - low);
  fit.through_level = step.through;
  fit.maximum = {.theta = on_ridge(problem, step, place, steep), .value = step.value};
  fit.middle = fit.maximum.theta;
  if (step.through) {
    const double least_steep = largest_scale(problem, step, place, steep, as_likely);
    const double end = on_ridge(problem, step, place, least_steep)[parameter::threshold];
    fit.low_t = std::min(place, end);
    fit.high_t = std::max(place, end);
    fit.largest_log_scale = std::log(least_steep);
    fit.level_t = place;
    fit.level_z =
        study::sigmoid_quantile(problem.sigmoid, (levels[step.first].k / levels[step.first].n - step.guess) /
                                                     (1 - step.guess - step.lapse));
    weigh_ridge(problem, step, place, steep, fit);
    fit.middle = on_ridge(problem, step, place, least_steep / 2);
  } else {
    if (step.first > 0) fit.low_t = low;
    if (above < levels.size()) fit.high_t = high;
    fit.largest_log_scale = std::log(largest_scale(problem, step, place, steep, as_likely));
  }
  return fit;
}

/// Whether a candidate's value is the objective's.
bool is_exact(const FitProblem& problem) {
  return !problem.priors.lapse && !problem.priors.threshold && !problem.overdispersed;
}

/// With priors or beta-binomial rows the likeliest rates are no longer counts over counts.
void settle(const FitProblem& problem, StepFit& fit) {
  if (!is_exact(problem)) {
    const Held held{.fixed = {true, true, false, false}, .level = {}};
    fit.maximum = maximise(problem, held, fit.maximum.theta, 0);
    fit.middle.tail<2>() = fit.maximum.theta.tail<2>();
  } else {
    fit.maximum.value = log_likelihood(problem, fit.maximum.theta, 0);
  }
  fit.maximum.converged = true;
}

}  // namespace

Theta on_ridge(const FitProblem& problem, const StepFit& step, double share) {
  const double last = step.ridge_scales.size() - 1;
  const auto knot = static_cast<std::size_t>(std::min(share * last, last - 1));
  const double part = share * last - static_cast<double>(knot);
  const double scale = std::lerp(step.ridge_scales[knot], step.ridge_scales[knot + 1], part);
  Theta theta = step.maximum.theta;
  if (std::log(scale) <= theta[parameter::log_scale]) return theta;
  theta[parameter::log_scale] = std::log(scale);
  theta[parameter::threshold] =
      std::clamp(step.level_t - problem.sign * scale * step.level_z, problem.lower[0], problem.upper[0]);
  return theta;
}

std::optional<StepFit> likeliest_step(const FitProblem& problem, double needed) {
  if (problem.priors.log2_width) return std::nullopt;
  Candidate best;
  for_each_candidate(problem, [&](const Candidate& found) {
    if (found.value > best.value + 1e-12) best = found;
  });
  if (!std::isfinite(best.value)) return std::nullopt;
  if (is_exact(problem) && best.value < needed - 1e-9) return std::nullopt;
  StepFit fit = described(problem, best);
  settle(problem, fit);
  if (fit.maximum.value < needed) return std::nullopt;
  return fit;
}

std::vector<StepFit> likely_steps(const FitProblem& problem, double needed, std::size_t most) {
  std::vector<StepFit> fits;
  if (problem.priors.log2_width) return fits;
  std::vector<Candidate> candidates;
  for_each_candidate(problem, [&](const Candidate& found) {
    if (std::isfinite(found.value) && (!is_exact(problem) || found.value >= needed - 1e-9))
      candidates.push_back(found);
  });
  const std::size_t kept = std::min(candidates.size(), most);
  std::partial_sort(candidates.begin(), candidates.begin() + kept, candidates.end(),
                    [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
  for (std::size_t i = 0; i < kept; ++i) {
    StepFit fit = described(problem, candidates[i]);
    settle(problem, fit);
    if (fit.maximum.value >= needed - 1e-6) fits.push_back(fit);
  }
  return fits;
}

}  // namespace seamline::analysis
