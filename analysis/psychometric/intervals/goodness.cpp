#include "analysis/psychometric/intervals/goodness.h"

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/likelihood/count_terms.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr std::uint64_t simulation_domain = 0x70737963686f6d65ULL;

double saturated(const UnitCounts& level) {
  const double p = level.k / level.n;
  return binomial_term(level.k, level.n, p, 1 - p).value;
}

UnitCounts unit_counts(const FitProblem& problem, const LevelCounts& level) {
  const double a = axis_value(problem.axis, level.level);
  return {.t = std::isfinite(a) ? problem.to_unit(a) : no_stimulus_t,
          .k = static_cast<double>(level.correct),
          .n = static_cast<double>(level.trials)};
}

/// Its part of the deviance.
double deviance_part(const UnitCounts& level, const ResponseProbability& p) {
  return 2 * (saturated(level) - binomial_term(level.k, level.n, p.right, p.wrong).value);
}

/// Places of the first level of every group, and of the end. They depend on the numbers of trials alone, so
/// that data simulated from a fit have the groups of the data.
std::vector<std::size_t> group_begins(const std::vector<UnitCounts>& levels) {
  double all = 0;
  for (const UnitCounts& level : levels) all += level.n;
  const double enough =
      levels.size() > most_groups ? std::max(trials_of_group, all / most_groups) : trials_of_group;
  std::vector<std::size_t> begins = {0};
  double trials = 0, left = all;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    trials += levels[i].n;
    left -= levels[i].n;
    if (trials < enough || left < enough) continue;  // a rest too small for a group joins the last one
    begins.push_back(i + 1);
    trials = 0;
  }
  begins.push_back(levels.size());
  return begins;
}

LevelGroup group_without_stimulus(const UnitCounts& none, const ResponseProbability& p) {
  const double size = std::sqrt(std::max(0.0, deviance_part(none, p)));
  return {.low = 0,
          .high = 0,
          .correct = none.k,
          .trials = none.n,
          .expected = none.n * p.right,
          .deviance_residual = none.k < none.n * p.right ? -size : size};
}

/// The groups of `problem` beside what a function expects of them.
std::vector<LevelGroup> groups_of(const FitProblem& problem, const Theta& theta) {
  std::vector<LevelGroup> groups;
  if (const UnitCounts& none = problem.no_stimulus; none.n > 0)
    groups.push_back(group_without_stimulus(none, probability_at(problem, theta, none.t)));
  const std::vector<std::size_t> begins = group_begins(problem.levels);
  for (std::size_t g = 0; g + 1 < begins.size(); ++g) {
    UnitCounts sum;
    ResponseProbability expected;
    for (std::size_t i = begins[g]; i < begins[g + 1]; ++i) {
      const UnitCounts& level = problem.levels[i];
      const ResponseProbability p = probability_at(problem, theta, level.t);
      sum.k += level.k;
      sum.n += level.n;
      expected.right += level.n * p.right;
      expected.wrong += level.n * p.wrong;
    }
    const double part =
        deviance_part(sum, {.right = expected.right / sum.n, .wrong = expected.wrong / sum.n});
    const double size = std::sqrt(std::max(0.0, part));
    const auto level_at = [&](std::size_t i) {
      return level_of(problem.axis, problem.to_axis(problem.levels[i].t));
    };
    groups.push_back({.low = level_at(begins[g]),
                      .high = level_at(begins[g + 1] - 1),
                      .correct = sum.k,
                      .trials = sum.n,
                      .expected = expected.right,
                      .deviance_residual = sum.k < expected.right ? -size : size});
  }
  return groups;
}

double deviance_of(const std::vector<LevelGroup>& groups) {
  double sum = 0;
  for (const LevelGroup& group : groups) sum += group.deviance_residual * group.deviance_residual;
  return sum;
}

}  // namespace

Goodness goodness_of_fit(const PsychometricFit& fit) {
  Goodness goodness;
  if (fit.levels.empty()) return goodness;
  const FitProblem& problem = fit.search.problem;
  const Theta& theta = fit.search.best.theta;
  goodness.groups = groups_of(problem, theta);
  goodness.deviance = deviance_of(goodness.groups);
  goodness.degrees_of_freedom = static_cast<int>(goodness.groups.size()) - fit.free_parameters;
  goodness.aic = 2 * fit.free_parameters - 2 * fit.log_likelihood;
  goodness.residuals.reserve(fit.levels.size());
  std::vector<LevelCounts> all = fit.levels;
  if (fit.no_stimulus.trials > 0) all.insert(all.begin(), fit.no_stimulus);
  for (const LevelCounts& counts : all) {
    const UnitCounts level = unit_counts(problem, counts);
    const ResponseProbability p = probability_at(problem, theta, level.t);
    const double part = deviance_part(level, p), size = std::sqrt(std::max(0.0, part));
    goodness.residuals.push_back({.counts = counts,
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
  const auto draw = [&](UnitCounts& level) {
    const double p = probability_at(problem, theta, level.t).right;
    level.k = static_cast<double>(sample_binomial(static_cast<std::int64_t>(level.n), p, random));
  };
  std::for_each(problem.levels.begin(), problem.levels.end(), draw);
  problem.rows = problem.levels;
  if (problem.no_stimulus.n > 0) {
    draw(problem.no_stimulus);
    problem.rows.push_back(problem.no_stimulus);
  }
  problem.overdispersed = false;
  return problem;
}

double deviance_p(const PsychometricFit& fit, int replicates, std::uint64_t seed) {
  if (fit.levels.empty() || fit.options.overdispersed) return nan;
  const Goodness goodness = goodness_of_fit(fit);
  if (goodness.degrees_of_freedom <= 0) return nan;
  int at_least = 0;
  for (int i = 0; i < replicates; ++i) {
    const FitProblem problem = simulated_problem(fit, seed, static_cast<std::uint64_t>(i));
    const Maximum again = refit(problem, fit.search.best);
    if (deviance_of(groups_of(problem, again.theta)) >= goodness.deviance - 1e-9) ++at_least;
  }
  return (1.0 + at_least) / (1.0 + replicates);
}

}  // namespace seamline::analysis
