#include "analysis/psychometric/likelihood/fit_problem.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "study/placement/sigmoid_shape.h"
#include "support/running/interrupt.h"
#include "support/text/csv.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

constexpr double gaps_in_smallest_scale = 1e-3;
constexpr double smallest_rate_with_prior = 1e-9;  ///< where a beta prior with a > 1 is 0

Priors unit_priors(const Priors& priors, const FitProblem& problem) {
  Priors unit = priors;
  if (unit.threshold)
    unit.threshold = NormalPrior{.mean = problem.to_unit(axis_value(problem.axis, priors.threshold->mean)),
                                 .sd = priors.threshold->sd / problem.range};
  if (unit.log2_width)  // of the natural logarithm of the unit scale
    unit.log2_width = NormalPrior{.mean = priors.log2_width->mean * std::numbers::ln2 -
                                          std::log(study::scales_in_width(problem.sigmoid) * problem.range),
                                  .sd = priors.log2_width->sd * std::numbers::ln2};
  return unit;
}

/// -((x - mean) / sd)^2 / 2 and its derivatives.
void add_normal(Objective& objective, const std::optional<NormalPrior>& prior, double x, int index) {
  if (!prior) return;
  const double z = (x - prior->mean) / prior->sd;
  const double precision = 1 / (prior->sd * prior->sd);
  objective.value -= 0.5 * z * z;
  objective.gradient[index] -= z / prior->sd;
  objective.observed(index, index) += precision;
  objective.expected(index, index) += precision;
}

void add_priors(Objective& objective, const Priors& priors, const Theta& theta) {
  add_normal(objective, priors.threshold, theta[parameter::threshold], parameter::threshold);
  add_normal(objective, priors.log2_width, theta[parameter::log_scale], parameter::log_scale);
  if (!priors.lapse) return;
  const double l = theta[parameter::lapse];
  const double a = priors.lapse->a - 1, b = priors.lapse->b - 1;
  objective.value += (a > 0 ? a * std::log(l) : 0) + b * std::log1p(-l);
  objective.gradient[parameter::lapse] += (a > 0 ? a / l : 0) - b / (1 - l);
  const double curvature = (a > 0 ? a / (l * l) : 0) + b / ((1 - l) * (1 - l));
  objective.observed(parameter::lapse, parameter::lapse) += curvature;
  objective.expected(parameter::lapse, parameter::lapse) += curvature;
}

CountTerm term_of(const UnitCounts& counts, const ResponseProbability& p, double eta) {
  return eta > 0 ? beta_binomial_term(counts.k, counts.n, p.right, p.wrong, eta)
                 : binomial_term(counts.k, counts.n, p.right, p.wrong);
}

/// Adds a level's part: psi = g + A F(z) with A = 1 - g - l, z = sign (t - m) / s.
void add_level(Objective& objective, const FitProblem& problem, const Theta& theta, const UnitCounts& counts,
               double eta) {
  const double g = theta[parameter::guess], l = theta[parameter::lapse], A = 1 - g - l;
  const double dz_dm = -problem.sign * std::exp(-theta[parameter::log_scale]);
  const double z = -dz_dm * (counts.t - theta[parameter::threshold]);
  const study::SigmoidPoint F = study::sigmoid_point(problem.sigmoid, z);
  const CountTerm term = term_of(counts, {.right = g + A * F.below, .wrong = l + A * F.above}, eta);
  objective.value += term.value;
  if (!std::isfinite(term.value)) return;

  const double f = F.density, df = F.density_slope;
  const Eigen::Vector4d gradient{A * f * dz_dm, -A * f * z, -F.below, F.above};
  objective.gradient += term.score * gradient;
  const Eigen::Matrix4d outer = gradient * gradient.transpose();
  objective.expected += term.expected * outer;
  Eigen::Matrix4d second = Eigen::Matrix4d::Zero();  // of psi
  second(0, 0) = A * df * dz_dm * dz_dm;
  second(0, 1) = second(1, 0) = -A * dz_dm * (df * z + f);
  second(1, 1) = A * z * (df * z + f);
  second(0, 2) = second(2, 0) = second(0, 3) = second(3, 0) = -f * dz_dm;
  second(1, 2) = second(2, 1) = second(1, 3) = second(3, 1) = f * z;
  objective.observed += term.observed * outer - term.score * second;
}

/// Calls `add` for all counts: rows of a beta-binomial, or levels and what has no stimulus.
template <class Add>
void for_each_counts(const FitProblem& problem, double eta, const Add& add) {
  const std::vector<UnitCounts>& counted = eta > 0 ? problem.rows : problem.levels;
  std::for_each(counted.begin(), counted.end(), add);
  if (eta <= 0 && problem.no_stimulus.n > 0) add(problem.no_stimulus);
}

}  // namespace

void set_gaps(FitProblem& problem) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < problem.levels.size(); ++i)
    gaps.push_back(problem.levels[i].t - problem.levels[i - 1].t);
  if (gaps.empty()) return;
  std::sort(gaps.begin(), gaps.end());
  problem.smallest_gap = gaps.front();
  problem.median_gap = gaps[gaps.size() / 2];
  problem.lower[parameter::log_scale] = std::log(gaps_in_smallest_scale * problem.smallest_gap);
}

FitProblem make_problem(const std::vector<LevelCounts>& counts, const FitOptions& options,
                        study::Direction direction) {
  FitProblem problem{.sigmoid = options.sigmoid,
                     .axis = options.axis,
                     .sign = direction == study::Direction::increasing ? 1.0 : -1.0,
                     .levels = {},
                     .rows = {},
                     .lower = {},
                     .upper = {},
                     .priors = {},
                     .overdispersed = options.overdispersed,
                     .equal_rates = options.equal_rates};
  std::vector<LevelCounts> pooled = pooled_by_level(counts);
  const LevelCounts none = take_no_stimulus(pooled, options.axis);
  assert(!pooled.empty());
  const double first = axis_value(options.axis, pooled.front().level),
               last = axis_value(options.axis, pooled.back().level);
  problem.centre = first + (last - first) / 2;
  if (last > first) problem.range = last - first;
  const auto unit = [&](const LevelCounts& row) {
    const double a = axis_value(options.axis, row.level);
    return UnitCounts{.t = std::isfinite(a) ? problem.to_unit(a) : no_stimulus_t,
                      .k = static_cast<double>(row.correct),
                      .n = static_cast<double>(row.trials)};
  };
  for (const LevelCounts& level : pooled) problem.levels.push_back(unit(level));
  if (none.trials > 0) problem.no_stimulus = unit(none);
  for (const LevelCounts& row : counts)
    if (row.trials > 0) problem.rows.push_back(unit(row));
  problem.priors = unit_priors(options.priors, problem);
  const bool lapse_off_zero = options.lapse.is_free() && problem.priors.lapse && problem.priors.lapse->a > 1;
  problem.lower = {-0.5 - ranges_beyond, std::log(gaps_in_smallest_scale * problem.smallest_gap),
                   std::max(options.lapse.low, lapse_off_zero ? smallest_rate_with_prior : 0),
                   options.guess.low};
  set_gaps(problem);
  problem.upper = {0.5 + ranges_beyond, std::log(largest_scale), options.lapse.high, options.guess.high};
  problem.lower = with_tied_rates(problem, problem.lower);
  problem.upper = with_tied_rates(problem, problem.upper);
  return problem;
}

ResponseProbability probability_at(const FitProblem& problem, const Theta& theta, double t) {
  const double z = problem.sign * (t - theta[parameter::threshold]) * std::exp(-theta[parameter::log_scale]);
  const study::SigmoidPoint F = study::sigmoid_point(problem.sigmoid, z);
  const double g = theta[parameter::guess], l = theta[parameter::lapse];
  return {.right = g + (1 - g - l) * F.below, .wrong = l + (1 - g - l) * F.above};
}

double best_without_stimulus(const FitProblem& problem) {
  const UnitCounts& none = problem.no_stimulus;
  if (none.n <= 0) return 0;
  const int rate = problem.sign > 0 ? parameter::guess : parameter::lapse;
  const double share = problem.sign > 0 ? none.k / none.n : 1 - none.k / none.n;
  const double p = std::clamp(share, problem.lower[rate], problem.upper[rate]);
  return problem.sign > 0 ? binomial_term(none.k, none.n, p, 1 - p).value
                          : binomial_term(none.k, none.n, 1 - p, p).value;
}

double log_likelihood(const FitProblem& problem, const Theta& theta, double eta) {
  stop_if_interrupted();  // every search, profile and replicate comes by here or in objective_at
  double sum = 0;
  for_each_counts(problem, eta, [&](const UnitCounts& counts) {
    sum += term_of(counts, probability_at(problem, theta, counts.t), eta).value;
  });
  return sum;
}

double objective_value(const FitProblem& problem, const Theta& theta, double eta) {
  Objective prior{.value = 0,
                  .gradient = Eigen::Vector4d::Zero(),
                  .observed = Eigen::Matrix4d::Zero(),
                  .expected = Eigen::Matrix4d::Zero()};
  add_priors(prior, problem.priors, theta);
  return log_likelihood(problem, theta, eta) + prior.value;
}

Objective objective_at(const FitProblem& problem, const Theta& theta, double eta) {
  stop_if_interrupted();
  Objective objective{.value = 0,
                      .gradient = Eigen::Vector4d::Zero(),
                      .observed = Eigen::Matrix4d::Zero(),
                      .expected = Eigen::Matrix4d::Zero()};
  for_each_counts(problem, eta,
                  [&](const UnitCounts& counts) { add_level(objective, problem, theta, counts, eta); });
  add_priors(objective, problem.priors, theta);
  return objective;
}

void require_valid(const FitOptions& options) {
  const auto in_range = [](const Rate& rate) {
    return rate.low >= 0 && rate.low <= rate.high && rate.high < 1;
  };
  if (!in_range(options.guess))
    throw input_error({.field = "guess", .wanted = "from 0 to 1", .found = number_text(options.guess.high)});
  if (!in_range(options.lapse))
    throw input_error({.field = "lapse", .wanted = "from 0 to 1", .found = number_text(options.lapse.high)});
  if (options.guess.high + options.lapse.high >= 1)
    throw input_error({.field = "lapse",
                       .wanted = "guess + lapse under 1 at their bounds",
                       .found = number_text(options.guess.high + options.lapse.high)});
  const auto require_sd = [](const char* field, const std::optional<NormalPrior>& prior) {
    if (prior && !(std::isfinite(prior->mean) && std::isfinite(prior->sd) && prior->sd > 0))
      throw input_error({.field = field,
                         .wanted = "a finite mean and a positive SD",
                         .found = number_text(prior->mean) + "," + number_text(prior->sd)});
  };
  require_sd("prior of the threshold", options.priors.threshold);
  require_sd("prior of the width", options.priors.log2_width);
  if (options.priors.threshold && options.axis == study::Axis::log2 && options.priors.threshold->mean <= 0)
    throw input_error({.field = "prior of the threshold",
                       .wanted = "a positive level on a log2 axis",
                       .found = number_text(options.priors.threshold->mean)});
  if (options.priors.lapse && !(options.priors.lapse->a >= 1 && options.priors.lapse->b >= 1))
    throw input_error(
        {.field = "prior of the lapse rate",
         .wanted = "a beta distribution with a, b >= 1",
         .found = number_text(options.priors.lapse->a) + "," + number_text(options.priors.lapse->b)});
}

}  // namespace seamline::analysis
