#include "analysis/psychometric/intervals/goodness.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/likelihood/count_terms.h"
#include "analysis/statistics/distributions.h"
#include "study/placement/sigmoid_shape.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr std::uint64_t simulation_domain = 0x70737963686f6d65ULL;
constexpr double large_spread = 30;     ///< SD of a count from which its deviance is chi-squared enough
constexpr double least_weight = 1e-17;  ///< of the likeliest count

double saturated(const UnitCounts& level) {
  const double p = level.k / level.n;
  return binomial_term(level.k, level.n, p, 1 - p).value;
}

double deviance_of(const FitProblem& problem, double log_likelihood) {
  double sum = 0;
  for (const UnitCounts& level : problem.levels) sum += saturated(level);
  return std::max(0.0, 2 * (sum - log_likelihood));
}

UnitCounts unit_counts(const FitProblem& problem, const LevelCounts& level) {
  return {.t = problem.to_unit(axis_value(problem.axis, level.level)),
          .k = static_cast<double>(level.correct),
          .n = static_cast<double>(level.trials)};
}

/// Its part of the deviance.
double deviance_part(const UnitCounts& level, const ResponseProbability& p) {
  return 2 * (saturated(level) - binomial_term(level.k, level.n, p.right, p.wrong).value);
}

/// Mean and variance of a level's part of the deviance under a binomial law, and its covariance with the
/// count.
struct DevianceMoments {
  double mean = 0, variance = 0, covariance = 0;
};

DevianceMoments deviance_moments(double n, const ResponseProbability& p) {
  if (p.right <= 0 || p.wrong <= 0) return {};
  const double spread = std::sqrt(n * p.right * p.wrong);
  if (spread > large_spread) return {.mean = 1, .variance = 2};  // chi-squared
  const double mode = std::min(n, std::floor((n + 1) * p.right));
  double weights = 0, mean = 0, square = 0, count = 0, product = 0;
  const auto add = [&](double k, double weight) {
    const double part = deviance_part({.t = 0, .k = k, .n = n}, p);
    weights += weight;
    mean += weight * part;
    square += weight * part * part;
    count += weight * k;
    product += weight * part * k;
  };
  const double odds = p.right / p.wrong;
  double weight = 1;
  for (double k = mode; k <= n && weight > least_weight; weight *= odds * (n - k) / (k + 1), ++k)
    add(k, weight);
  weight = mode / ((n - mode + 1) * odds);
  for (double k = mode - 1; k >= 0 && weight > least_weight; weight *= k / ((n - k + 1) * odds), --k)
    add(k, weight);
  mean /= weights;
  count /= weights;
  return {.mean = mean,
          .variance = square / weights - mean * mean,
          .covariance = product / weights - mean * count};
}

/// With very many levels the deviance is normal. Its variance is less by what a fit takes out of it
/// (McCullagh 1986): Var = sum v_i - c' I^-1 c, with c the covariance of deviance and score and I Fisher's
/// information; its mean is less by about one for each parameter.
double normal_deviance_p(const PsychometricFit& fit, double deviance) {
  const FitProblem& problem = fit.search.problem;
  const Theta& theta = fit.search.best.theta;
  const double g = theta[parameter::guess], l = theta[parameter::lapse], A = 1 - g - l;
  const double dz_dm = -problem.sign * std::exp(-theta[parameter::log_scale]);
  double mean = -fit.free_parameters, variance = 0;
  Eigen::Vector4d shared = Eigen::Vector4d::Zero();
  for (const LevelCounts& counts : fit.levels) {
    const UnitCounts level = unit_counts(problem, counts);
    const ResponseProbability p = probability_at(problem, theta, level.t);
    const DevianceMoments moments = deviance_moments(level.n, p);
    mean += moments.mean;
    variance += moments.variance;
    if (moments.covariance == 0) continue;
    const double z = -dz_dm * (level.t - theta[parameter::threshold]);
    const study::SigmoidPoint F = study::sigmoid_point(problem.sigmoid, z);
    const Eigen::Vector4d slope{A * F.density * dz_dm, -A * F.density * z, -F.below, F.above};
    shared += moments.covariance / (p.right * p.wrong) * slope;
  }
  Eigen::Matrix4d information = objective_at(problem, theta, 0).expected;
  for (int i = 0; i < 4; ++i) {
    if (theta[i] > problem.lower[i] && theta[i] < problem.upper[i]) continue;
    information.row(i).setZero();  // at its bound: known
    information.col(i).setZero();
    information(i, i) = 1;
    shared[i] = 0;
  }
  variance -= shared.dot(information.ldlt().solve(shared));
  return variance > 0 ? normal_below(-(deviance - mean) / std::sqrt(variance)) : nan;
}

}  // namespace

Goodness goodness_of_fit(const PsychometricFit& fit) {
  Goodness goodness;
  if (fit.levels.empty()) return goodness;
  const FitProblem& problem = fit.search.problem;
  const Theta& theta = fit.search.best.theta;
  double deviance = 0;
  goodness.degrees_of_freedom = static_cast<int>(fit.levels.size()) - fit.free_parameters;
  goodness.aic = 2 * fit.free_parameters - 2 * fit.log_likelihood;
  goodness.residuals.reserve(fit.levels.size());
  for (const LevelCounts& counts : fit.levels) {
    const UnitCounts level = unit_counts(problem, counts);
    const ResponseProbability p = probability_at(problem, theta, level.t);
    const double part = deviance_part(level, p), size = std::sqrt(std::max(0.0, part));
    deviance += part;
    goodness.residuals.push_back({.counts = counts,
                                  .fitted = p.right,
                                  .deviance_residual = level.k / level.n < p.right ? -size : size});
  }
  goodness.deviance = std::max(0.0, deviance);
  return goodness;
}

FitProblem simulated_problem(const PsychometricFit& fit, std::uint64_t seed, std::uint64_t replicate) {
  return simulated_problem(fit, fit.search.best.theta, seed, replicate);
}

FitProblem simulated_problem(const PsychometricFit& fit, const Theta& theta, std::uint64_t seed,
                             std::uint64_t replicate) {
  FitProblem problem = fit.search.problem;
  Random random(seed ^ simulation_domain, replicate);
  for (UnitCounts& level : problem.levels) {
    const double p = probability_at(problem, theta, level.t).right;
    level.k = static_cast<double>(sample_binomial(static_cast<std::int64_t>(level.n), p, random));
  }
  problem.rows = problem.levels;
  problem.overdispersed = false;
  return problem;
}

double deviance_p(const PsychometricFit& fit, int replicates, std::uint64_t seed) {
  if (fit.levels.size() < 2 || fit.options.overdispersed) return nan;
  const double observed = goodness_of_fit(fit).deviance;
  if (fit.levels.size() > most_simulated_levels) return normal_deviance_p(fit, observed);
  int at_least = 0;
  for (int i = 0; i < replicates; ++i) {
    const FitProblem problem = simulated_problem(fit, seed, static_cast<std::uint64_t>(i));
    const Maximum again = refit(problem, fit.search.best);
    if (deviance_of(problem, log_likelihood(problem, again.theta, 0)) >= observed - 1e-9) ++at_least;
  }
  return (1.0 + at_least) / (1.0 + replicates);
}

}  // namespace seamline::analysis
