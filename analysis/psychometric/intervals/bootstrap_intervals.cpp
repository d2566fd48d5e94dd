#include "analysis/psychometric/intervals/bootstrap_intervals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/psychometric/intervals/goodness.h"
#include "analysis/statistics/distributions.h"
#include "analysis/statistics/interval.h"
#include "study/placement/sigmoid_shape.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double z_95 = 1.959963984540054;
constexpr std::size_t most_left_out = 512;
constexpr int places_of_estimate = 32;

/// What intervals are made for, of one fit: unit threshold, ln scale, lapse, unit place of the level of a
/// share right.
using Values = std::array<double, 4>;

Values values_of(const FitProblem& problem, const Theta& theta, std::optional<double> correct) {
  const auto bounded = [&](double t) {
    return t <= problem.lower[0] + 1e-9 ? -infinity : t >= problem.upper[0] - 1e-9 ? infinity : t;
  };
  Values values = {bounded(theta[0]), theta[1], theta[2], 0};
  if (correct)
    values[3] = bounded(place_of(problem, theta, {.of = SoughtLevel::Of::response, .share = *correct})
                            .value_or(problem.sign * problem.upper[0]));
  return values;
}

/// The values of a fit at a share (0 to 1) of all that it stands for. A step stands for every threshold
/// between its two levels, or on its level's ridge; beyond the tested levels it may lie anywhere: infinite.
Values values_at(const FitProblem& problem, const Refit& fit, double share, std::optional<double> correct) {
  if (!fit.step) return values_of(problem, fit.maximum.theta, correct);
  const StepFit& step = *fit.step;
  if (step.through_level) {
    Values values = values_of(problem, on_ridge(problem, step, share), correct);
    values[1] = -infinity;
    return values;
  }
  Values values = values_of(problem, fit.maximum.theta, correct);
  values[0] = !std::isfinite(step.low_t)    ? -infinity
              : !std::isfinite(step.high_t) ? infinity
                                            : step.low_t + share * (step.high_t - step.low_t);
  values[1] = -infinity;
  if (std::isfinite(values[3])) values[3] = values[0];
  return values;
}

/// Sums for the acceleration: leaving out one right and one wrong answer of every level, as often as there
/// are.
struct Jackknife {
  std::vector<std::pair<double, Values>> left_out;  ///< (how many such answers, middle values without one)
};

Jackknife leave_one_answer_out(const PsychometricFit& fit, std::optional<double> correct) {
  Jackknife jackknife;
  const std::size_t levels = fit.search.problem.levels.size();
  const std::size_t stride = 1 + (levels - 1) / most_left_out;  // of very many levels some stand for all
  for (std::size_t i = 0; i < levels; i += stride)
    for (bool right : {true, false}) {
      FitProblem problem = fit.search.problem;
      UnitCounts& level = problem.levels[i];
      const double answers = right ? level.k : level.n - level.k;
      if (answers <= 0 || level.n <= 1) continue;
      level.n -= 1;
      if (right) level.k -= 1;
      problem.overdispersed = false;
      const Refit without = refit_with_step(problem, fit.search.best);
      jackknife.left_out.emplace_back(answers, values_at(problem, without, 0.5, correct));
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
  const double n = sorted.size();
  return sorted[static_cast<std::size_t>(std::clamp(std::floor(share * n), 0.0, n - 1))];
}

/// `estimates`: all values that the data make as likely, evenly. The share of replicates below the estimate
/// is the mean over these.
Interval bca(std::vector<double> replicates, const std::vector<double>& estimates, double a) {
  require_ordered(replicates);
  std::sort(replicates.begin(), replicates.end());
  const double n = replicates.size();
  double below = 0;
  for (double estimate : estimates) {
    const auto lower = std::lower_bound(replicates.begin(), replicates.end(), estimate);
    const auto upper = std::upper_bound(replicates.begin(), replicates.end(), estimate);
    below += (static_cast<double>(lower - replicates.begin()) + 0.5 * static_cast<double>(upper - lower)) /
             (n * static_cast<double>(estimates.size()));
  }
  const double z0 = normal_quantile(std::clamp(below, 0.5 / n, 1 - 0.5 / n));
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
  Refit found{.maximum = fit.search.best, .step = {}};
  if (fit.is_step) found.step = fit.search.step;
  // A step stands for all its values: each replicate takes another share of them, by the golden ratio's
  // multiples, which fill 0 to 1 as evenly as numbers can. So does the function that is simulated.
  std::array<std::vector<double>, 4> replicates, estimates;
  std::vector<double> largest_log_scales;
  const auto golden = [](double i) {
    return (i + 0.5) * std::numbers::phi - std::floor((i + 0.5) * std::numbers::phi);
  };
  for (int i = 0; i < request.replicates; ++i) {
    const Theta planted = fit.is_step && fit.search.step->through_level
                              ? on_ridge(fit.search.problem, *fit.search.step, golden(i + 7919))
                              : fit.search.best.theta;
    const FitProblem problem = simulated_problem(fit, planted, request.seed, static_cast<std::uint64_t>(i));
    const Refit refitted = refit_with_step(problem, {.theta = planted, .eta = 0});
    const Values values = values_at(problem, refitted, golden(i), request.correct);
    for (std::size_t j = 0; j < replicates.size(); ++j) replicates[j].push_back(values[j]);
    largest_log_scales.push_back(refitted.step ? refitted.step->largest_log_scale : values[1]);
    intervals.without_threshold += std::isfinite(values[0]) ? 0 : 1;
    intervals.steps += refitted.step ? 1 : 0;
  }
  const FitProblem& problem = fit.search.problem;
  for (int i = 0; i < places_of_estimate; ++i) {
    const Values values = values_at(problem, found, (i + 0.5) / places_of_estimate, request.correct);
    for (std::size_t j = 0; j < estimates.size(); ++j) estimates[j].push_back(values[j]);
  }
  const Jackknife jackknife = leave_one_answer_out(fit, request.correct);
  const auto interval = [&](std::size_t j) {
    Interval ci = bca(replicates[j], estimates[j], acceleration(jackknife, j));
    // It holds the estimate, and of a step between two levels everything between them.
    const bool is_gap = found.step && !found.step->through_level && (j == 0 || j == 3);
    const Values middle =
        values_of(problem, found.step ? found.step->middle : found.maximum.theta, request.correct);
    ci.low = std::min({ci.low, middle[j], is_gap ? std::min(middle[j], found.step->low_t) : middle[j]});
    ci.high = std::max({ci.high, middle[j], is_gap ? std::max(middle[j], found.step->high_t) : middle[j]});
    return ci;
  };
  const auto to_levels = [&](const Interval& unit) {
    const auto level = [&](double t) {
      return std::isfinite(t) ? level_of(fit.options.axis, problem.to_axis(t)) : t;
    };
    return Interval{.low = level(unit.low), .high = level(unit.high)};
  };
  intervals.threshold = to_levels(interval(0));
  const double unit_width = study::scales_in_width(fit.options.sigmoid) * problem.range;
  // Of a step's scales 0 counts at the low end and the largest at the high end.
  const double largest = found.step ? found.step->largest_log_scale : found.maximum.theta[1];
  const Interval log_scale{
      .low = interval(1).low,
      .high = std::max(largest, bca(largest_log_scales, {largest}, acceleration(jackknife, 1)).high)};
  intervals.width = {.low = std::exp(log_scale.low) * unit_width,
                     .high = std::exp(log_scale.high) * unit_width};
  intervals.lapse = interval(2);
  if (request.correct) intervals.level_of_correct = to_levels(interval(3));
  return intervals;
}

}  // namespace seamline::analysis
