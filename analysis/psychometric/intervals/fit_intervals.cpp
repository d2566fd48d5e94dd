#include "analysis/psychometric/intervals/fit_intervals.h"

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "study/placement/sigmoid_shape.h"

namespace seamline::analysis {

namespace {

double to_level(const PsychometricFit& fit, double unit) {
  return std::isfinite(unit) ? level_of(fit.options.axis, fit.search.problem.to_axis(unit)) : unit;
}

/// A constant probability is the limit of functions whose threshold and scale both go to infinity, to the
/// side on which they come near it: where one is within the cut the interval is open there, however far out
/// the search looked.
void open_to_constants(const PsychometricFit& fit, double share, double cut, Interval& unit) {
  const FitProblem& problem = fit.search.problem;
  if (problem.priors.threshold || problem.priors.log2_width) return;
  double k = 0, n = 0;
  for (const UnitCounts& level : problem.levels) {
    k += level.k;
    n += level.n;
  }
  const double least_guess = problem.lower[parameter::guess], most_guess = problem.upper[parameter::guess];
  const double least_lapse = problem.lower[parameter::lapse], most_lapse = problem.upper[parameter::lapse];
  const auto is_within = [&](double low, double high) {
    const double p = std::clamp(k / n, low, std::max(low, high));
    return binomial_term(k, n, p, 1 - p).value + best_without_stimulus(problem) >=
           fit.search.best.value - cut / 2;
  };
  // Everywhere easier than the level sought, or everywhere harder.
  const bool easy = is_within(least_guess + (1 - least_guess - most_lapse) * share, 1 - least_lapse);
  const bool hard = is_within(least_guess, most_guess + (1 - most_guess - least_lapse) * share);
  if (problem.sign > 0 ? easy : hard) unit.low = -infinity;
  if (problem.sign > 0 ? hard : easy) unit.high = infinity;
}

LevelEstimate level_estimate(const PsychometricFit& fit, const SoughtLevel& sought, double cut) {
  if (fit.levels.size() < 2) return {};
  const Theta& estimate = fit.is_step ? fit.search.step->middle : fit.search.best.theta;
  const std::optional<double> place = place_of(fit.search.problem, estimate, sought);
  if (!place) return {};
  Interval unit = Profile(fit.search).place(sought, cut);
  if (sought.of == SoughtLevel::Of::sigmoid) open_to_constants(fit, sought.share, cut, unit);
  return {.estimate = to_level(fit, *place),
          .ci95 = {.low = to_level(fit, std::min(unit.low, *place)),
                   .high = to_level(fit, std::max(unit.high, *place))}};
}

Interval rate_interval(const PsychometricFit& fit, int parameter, const Rate& rate, double cut) {
  if (fit.levels.empty() || !rate.is_free()) return {.low = rate.low, .high = rate.high};
  return Profile(fit.search).rate(parameter, cut);
}

}  // namespace

Interval threshold_interval(const PsychometricFit& fit, double cut) {
  return level_estimate(fit, {}, cut).ci95;
}

Interval width_interval(const PsychometricFit& fit, double cut) {
  if (fit.levels.size() < 2) return {.low = 0};
  const Profile profile(fit.search);
  const double unit_width = study::scales_in_width(fit.options.sigmoid) * fit.search.problem.range;
  const Interval log_scale = profile.log_scale(cut);
  const bool step_allowed =
      fit.search.step && fit.search.step->maximum.value >= fit.search.best.value - cut / 2;
  return {.low = step_allowed ? 0 : std::exp(log_scale.low) * unit_width,
          .high = std::exp(log_scale.high) * unit_width};
}

Interval lapse_interval(const PsychometricFit& fit, double cut) {
  return rate_interval(fit, parameter::lapse, fit.options.lapse, cut);
}

Interval guess_interval(const PsychometricFit& fit, double cut) {
  return rate_interval(fit, fit.options.equal_rates ? parameter::lapse : parameter::guess, fit.options.guess,
                       cut);
}

LevelEstimate level_of_correct(const PsychometricFit& fit, double correct, double cut) {
  return level_estimate(fit, {.of = SoughtLevel::Of::response, .share = correct}, cut);
}

LevelEstimate level_of_share(const PsychometricFit& fit, double share, double cut) {
  return level_estimate(fit, {.of = SoughtLevel::Of::sigmoid, .share = share}, cut);
}

}  // namespace seamline::analysis
