#include "analysis/psychometric/bootstrap_intervals.h"

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/goodness.h"
#include "analysis/psychometric/sigmoid_shape.h"
#include "analysis/statistics/distributions.h"
#include "stimuli/support/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double z_95 = 1.959963984540054;

/// What intervals are made for, of one fit: unit threshold, ln scale, lapse, unit place of the level of a
/// share right.
using Values = std::array<double, 4>;

Values values_of(const FitProblem& problem, const Maximum& at, std::optional<double> correct) {
  const auto bounded = [&](double t) {
    return t <= problem.lower[0] + 1e-9 ? -infinity : t >= problem.upper[0] - 1e-9 ? infinity : t;
  };
  Values values = {bounded(at.theta[0]), at.theta[1], at.theta[2], 0};
  if (std::exp(at.theta[1]) < 0.02 * problem.median_gap) values[1] = -infinity;
  if (correct)
    values[3] = bounded(place_of(problem, at.theta, {.of = SoughtLevel::Of::response, .share = *correct})
                            .value_or(problem.sign * problem.upper[0]));
  return values;
}

/// The least and the largest values that are as likely: the same but for a step, whose threshold may lie
/// anywhere between two levels.
struct Ends {
  Values low, high;
};

Ends ends_of(const FitProblem& problem, const Maximum& at, std::optional<double> correct) {
  const Values values = values_of(problem, at, correct);
  Ends ends{values, values};
  if (std::isfinite(values[1])) return ends;
  const std::optional<StepFit> step = likeliest_step(problem);
  if (!step) return ends;
  for (const std::size_t place : {std::size_t{0}, std::size_t{3}}) {
    if (!std::isfinite(values[place])) continue;
    ends.low[place] = std::min(values[place], step->low_t);
    ends.high[place] = std::max(values[place], step->high_t);
  }
  return ends;
}

/// Sums for the acceleration: leaving out one right and one wrong answer of every level, as often as there
/// are.
struct Jackknife {
  std::vector<std::pair<double, Values>> left_out;  ///< (how many such answers, values without one)
};

Jackknife leave_one_answer_out(const PsychometricFit& fit, std::optional<double> correct) {
  Jackknife jackknife;
  for (std::size_t i = 0; i < fit.levels.size(); ++i)
    for (bool right : {true, false}) {
      FitProblem problem = fit.search.problem;
      UnitCounts& level = problem.levels[i];
      const double answers = right ? level.k : level.n - level.k;
      if (answers <= 0 || level.n <= 1) continue;
      level.n -= 1;
      if (right) level.k -= 1;
      problem.overdispersed = false;
      jackknife.left_out.emplace_back(answers, values_of(problem, refit(problem, fit.search.best), correct));
    }
  return jackknife;
}

double acceleration(const Jackknife& jackknife, std::size_t index) {
  double weights = 0, mean = 0;
  for (const auto& [weight, values] : jackknife.left_out) {
    if (!std::isfinite(values[index])) return 0;
    weights += weight;
    mean += weight * values[index];
  }
  if (weights <= 0) return 0;
  mean /= weights;
  double squares = 0, cubes = 0;
  for (const auto& [weight, values] : jackknife.left_out) {
    const double d = mean - values[index];
    squares += weight * d * d;
    cubes += weight * d * d * d;
  }
  return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

/// The order statistic nearest to the share (type 1), so that infinities stay what they are.
double order_statistic(const std::vector<double>& sorted, double share) {
  const auto n = static_cast<double>(sorted.size());
  return sorted[static_cast<std::size_t>(std::clamp(std::floor(share * n), 0.0, n - 1))];
}

Interval bca(std::vector<double> replicates, double estimate, double a) {
  std::sort(replicates.begin(), replicates.end());
  const auto n = static_cast<double>(replicates.size());
  const auto lower = std::lower_bound(replicates.begin(), replicates.end(), estimate);
  const auto upper = std::upper_bound(replicates.begin(), replicates.end(), estimate);
  const double below =
      static_cast<double>(lower - replicates.begin()) + 0.5 * static_cast<double>(upper - lower);
  const double z0 = normal_quantile(std::clamp(below / n, 0.5 / n, 1 - 0.5 / n));
  const auto share = [&](double z) {
    const double shifted = z0 + z;
    return normal_below(z0 + shifted / std::max(1e-3, 1 - a * shifted));
  };
  return {.low = order_statistic(replicates, share(-z_95)), .high = order_statistic(replicates, share(z_95))};
}

}  // namespace

BootstrapIntervals bootstrap_intervals(const PsychometricFit& fit, const BootstrapRequest& request) {
  BootstrapIntervals intervals{.threshold = {},
                               .width = {.low = 0},
                               .lapse = {},
                               .level_of_correct = {},
                               .replicates = request.replicates};
  if (request.correct) intervals.level_of_correct = Interval{};
  if (fit.levels.size() < 2 || request.replicates < 1) return intervals;
  std::array<std::vector<double>, 4> lows, highs;
  for (int i = 0; i < request.replicates; ++i) {
    const FitProblem problem = simulated_problem(fit, request.seed, static_cast<std::uint64_t>(i));
    const Maximum refitted = refit(problem, fit.search.best);
    const Ends ends = ends_of(problem, refitted, request.correct);
    for (std::size_t j = 0; j < ends.low.size(); ++j) {
      lows[j].push_back(ends.low[j]);
      highs[j].push_back(ends.high[j]);
    }
    const Values values = values_of(problem, refitted, request.correct);
    intervals.without_threshold += std::isfinite(values[0]) ? 0 : 1;
    intervals.steps += std::isfinite(values[1]) ? 0 : 1;
  }
  const FitProblem& problem = fit.search.problem;
  const Ends estimate = ends_of(problem, fit.search.best, request.correct);
  const Jackknife jackknife = leave_one_answer_out(fit, request.correct);
  const auto interval = [&](std::size_t j) {
    const double a = acceleration(jackknife, j);
    return Interval{.low = bca(lows[j], estimate.low[j], a).low,
                    .high = bca(highs[j], estimate.high[j], a).high};
  };
  const auto to_levels = [&](const Interval& unit) {
    const auto level = [&](double t) {
      return std::isfinite(t) ? level_of(fit.options.axis, problem.to_axis(t)) : t;
    };
    return Interval{.low = level(unit.low), .high = level(unit.high)};
  };
  intervals.threshold = to_levels(interval(0));
  const double unit_width = scales_in_width(fit.options.sigmoid) * problem.range;
  const Interval log_scale = interval(1);
  intervals.width = {.low = std::exp(log_scale.low) * unit_width,
                     .high = std::exp(log_scale.high) * unit_width};
  intervals.lapse = interval(2);
  if (request.correct) intervals.level_of_correct = to_levels(interval(3));
  return intervals;
}

}  // namespace seamline::analysis
