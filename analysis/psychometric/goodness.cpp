#include "analysis/psychometric/goodness.h"

#include <cmath>

#include "analysis/psychometric/binomial_sampler.h"
#include "analysis/psychometric/count_terms.h"
#include "stimuli/support/numbers.h"

namespace seamline::analysis {

namespace {

constexpr std::uint64_t simulation_domain = 0x70737963686f6d65ULL;

double saturated(const UnitCounts& level) {
  const double p = level.k / level.n;
  return binomial_term(level.k, level.n, p, 1 - p).value;
}

double deviance_of(const FitProblem& problem, double log_likelihood) {
  double sum = 0;
  for (const UnitCounts& level : problem.levels) sum += saturated(level);
  return std::max(0.0, 2 * (sum - log_likelihood));
}

}  // namespace

Goodness goodness_of_fit(const PsychometricFit& fit) {
  Goodness goodness;
  if (fit.levels.empty()) return goodness;
  const FitProblem& problem = fit.search.problem;
  const Theta& theta = fit.search.best.theta;
  goodness.deviance = deviance_of(problem, log_likelihood(problem, theta, 0));
  goodness.degrees_of_freedom = static_cast<int>(fit.levels.size()) - fit.free_parameters;
  goodness.aic = 2 * fit.free_parameters - 2 * fit.log_likelihood;
  for (std::size_t i = 0; i < fit.levels.size(); ++i) {
    const UnitCounts& level = problem.levels[i];
    const ResponseProbability p = probability_at(problem, theta, level.t);
    const double part = 2 * (saturated(level) - binomial_term(level.k, level.n, p.right, p.wrong).value);
    const double size = std::sqrt(std::max(0.0, part));
    goodness.residuals.push_back({.counts = fit.levels[i],
                                  .fitted = p.right,
                                  .deviance_residual = level.k / level.n < p.right ? -size : size});
  }
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
  int at_least = 0;
  for (int i = 0; i < replicates; ++i) {
    const FitProblem problem = simulated_problem(fit, seed, static_cast<std::uint64_t>(i));
    const Maximum again = refit(problem, fit.search.best);
    if (deviance_of(problem, log_likelihood(problem, again.theta, 0)) >= observed - 1e-9) ++at_least;
  }
  return (1.0 + at_least) / (1.0 + replicates);
}

}  // namespace seamline::analysis
