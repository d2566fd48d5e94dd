#include "analysis/psychometric/fit_intervals.h"

#include <cmath>

#include "analysis/psychometric/sigmoid_shape.h"

namespace seamline::analysis {

namespace {

double to_level(const PsychometricFit& fit, double unit) {
  return std::isfinite(unit) ? level_of(fit.options.axis, fit.search.problem.to_axis(unit)) : unit;
}

LevelEstimate level_estimate(const PsychometricFit& fit, const SoughtLevel& sought, double cut) {
  if (fit.levels.size() < 2) return {};
  const std::optional<double> place = place_of(fit.search.problem, fit.search.best.theta, sought);
  if (!place) return {};
  const Interval unit = Profile(fit.search).place(sought, cut);
  return {.estimate = to_level(fit, *place),
          .ci95 = {.low = to_level(fit, unit.low), .high = to_level(fit, unit.high)}};
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
  const double unit_width = scales_in_width(fit.options.sigmoid) * fit.search.problem.range;
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
  return rate_interval(fit, parameter::guess, fit.options.guess, cut);
}

LevelEstimate level_of_correct(const PsychometricFit& fit, double correct, double cut) {
  return level_estimate(fit, {.of = SoughtLevel::Of::response, .share = correct}, cut);
}

LevelEstimate level_of_share(const PsychometricFit& fit, double share, double cut) {
  return level_estimate(fit, {.of = SoughtLevel::Of::sigmoid, .share = share}, cut);
}

}  // namespace seamline::analysis
