#include "analysis/psychometric/likelihood/psychometric_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "analysis/psychometric/likelihood/profile.h"
#include "study/placement/sigmoid_shape.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

double flat_log_likelihood(const FitProblem& problem) {
  UnitCounts all;
  for (const UnitCounts& level : problem.levels) {
    all.k += level.k;
    all.n += level.n;
  }
  const double p =
      std::clamp(all.k / all.n, problem.lower[parameter::guess], 1 - problem.lower[parameter::lapse]);
  return binomial_term(all.k, all.n, p, 1 - p).value + best_without_stimulus(problem);
}

/// A direction that was not given is the likelier one.
Search search_direction(const std::vector<LevelCounts>& counts, const FitOptions& options,
                        PsychometricFit& fit) {
  const auto search_in = [&](study::Direction direction) {
    return search_levels(make_problem(counts, options, direction));
  };
  if (options.direction) {
    fit.direction = *options.direction;
    fit.direction_known = true;
    return search_in(fit.direction);
  }
  Search rising = search_in(study::Direction::increasing), falling = search_in(study::Direction::decreasing);
  const double advantage = rising.best.value - falling.best.value;
  fit.direction_known = std::abs(advantage) > chi_squared_95 / 2;
  fit.direction = advantage >= 0 ? study::Direction::increasing : study::Direction::decreasing;
  return advantage >= 0 ? std::move(rising) : std::move(falling);
}

/// Of the levels as they are, and not of bins.
double log_likelihood_of(const PsychometricFit& fit) {
  const FitProblem& problem = fit.search.problem;
  if (fit.eta > 0 || problem.levels.size() == fit.levels.size())
    return log_likelihood(problem, fit.search.best.theta, fit.eta);
  const UnitCounts& none = problem.no_stimulus;
  const ResponseProbability blind = probability_at(problem, fit.search.best.theta, none.t);
  double sum = none.n > 0 ? binomial_term(none.k, none.n, blind.right, blind.wrong).value : 0;
  for (const LevelCounts& level : fit.levels) {
    const ResponseProbability p = probability_at(problem, fit.search.best.theta,
                                                 problem.to_unit(axis_value(problem.axis, level.level)));
    sum +=
        binomial_term(static_cast<double>(level.correct), static_cast<double>(level.trials), p.right, p.wrong)
            .value;
  }
  return sum;
}

/// Right answers without a stimulus are guesses.
void require_possible_without_stimulus(const PsychometricFit& fit) {
  const LevelCounts& none = fit.no_stimulus;
  if (none.trials == 0 || std::isfinite(best_without_stimulus(fit.search.problem))) return;
  throw input_error(
      {.field = "level 0",
       .wanted = fmt::format("a {} rate that is not 0, as {} of {} answers without a stimulus are right "
                             "or yes ({} free, {} free)",
                             fit.search.problem.sign > 0 ? "guess" : "lapse", none.correct, none.trials,
                             request_name("guess"), request_name("lapse")),
       .found = "a fixed rate of 0"});
}

int free_parameters(const FitProblem& problem) {
  return 2 + (problem.upper[parameter::lapse] > problem.lower[parameter::lapse] ? 1 : 0) +
         (!problem.equal_rates && problem.upper[parameter::guess] > problem.lower[parameter::guess] ? 1 : 0) +
         (problem.overdispersed ? 1 : 0);
}

}  // namespace

PsychometricFit fit_psychometric(const std::vector<LevelCounts>& counts, const FitOptions& options) {
  require_valid(options);
  require_valid(counts, options.axis);
  PsychometricFit fit;
  fit.options = options;
  if (options.equal_rates) fit.options.guess = options.lapse;
  fit.levels = pooled_by_level(counts);
  fit.no_stimulus = take_no_stimulus(fit.levels, options.axis);
  fit.levels_without_trials = static_cast<int>(
      std::count_if(counts.begin(), counts.end(), [](const LevelCounts& row) { return row.trials == 0; }));
  if (fit.levels.empty()) return fit;

  fit.search = search_direction(counts, options, fit);
  require_possible_without_stimulus(fit);
  const FitProblem& problem = fit.search.problem;
  fit.is_step = fit.search.is_step;
  const Theta& theta = fit.is_step ? fit.search.step->middle : fit.search.best.theta;
  fit.function = {.sigmoid = options.sigmoid,
                  .axis = options.axis,
                  .direction = fit.direction,
                  .threshold = level_of(options.axis, problem.to_axis(theta[parameter::threshold])),
                  .scale = std::exp(theta[parameter::log_scale]) * problem.range,
                  .guess = theta[parameter::guess],
                  .lapse = theta[parameter::lapse]};
  fit.width = fit.function.scale * study::scales_in_width(options.sigmoid);
  fit.eta = fit.search.best.eta;
  fit.log_likelihood = log_likelihood_of(fit);
  fit.flat_log_likelihood = flat_log_likelihood(problem);
  fit.free_parameters = free_parameters(problem);
  fit.converged = fit.search.best.converged;
  return fit;
}

double fitted_probability(const PsychometricFit& fit, double level) {
  const FitProblem& problem = fit.search.problem;
  const double a = axis_value(fit.options.axis, level);
  return probability_at(problem, fit.search.best.theta, std::isfinite(a) ? problem.to_unit(a) : no_stimulus_t)
      .right;
}

}  // namespace seamline::analysis
