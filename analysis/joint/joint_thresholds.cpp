#include "analysis/joint/joint_thresholds.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/ordinal/contrasts/max_t.h"
#include "analysis/statistics/distributions.h"

namespace seamline::analysis {

namespace {

/// A place with its standard error, before anything is said of it.
struct RoughPlace {
  std::optional<JointPlace> place;
  double standard_error = nan;
  std::string reason;
};

double standard_error_of(const Eigen::VectorXd& gradient, const JointJackknife& left_out) {
  return std::sqrt(std::max(0.0, gradient.dot(left_out.covariance * gradient)));
}

/// Whether the floor with its uncertainty reaches the level.
bool level_in_floor(const JointFit& fit, const JointJackknife& left_out, int curve, const SoughtMean& sought,
                    double t) {
  if (sought.mean == JointMean::seen) return false;
  constexpr double scales_beyond = 40;
  const double far =
      fit.theta[fit.model.threshold(curve)] + scales_beyond * std::exp(fit.theta[fit.model.log_scale(curve)]);
  const MeanAtX floor = mean_at_x(fit.model, fit.theta, curve, sought.mean, far);
  return floor.value + t * standard_error_of(floor.gradient, left_out) >= sought.level;
}

RoughPlace rough_place(const JointFit& fit, const JointJackknife& left_out, int curve, JointQuantity quantity,
                       double t) {
  RoughPlace rough;
  if (fit.model.ratings == 1 && quantity != JointQuantity::detection) {
    rough.reason = "ratings were not asked";
    return rough;
  }
  const std::optional<SoughtMean> sought = sought_mean(quantity);
  if (sought && level_in_floor(fit, left_out, curve, *sought, t)) {
    rough.reason = "not identified: the level lies in the guess floor";
    return rough;
  }
  rough.place = place_of(fit.model, fit.theta, curve, quantity);
  if (!rough.place) {
    rough.reason = "the curve has no such place";
    return rough;
  }
  rough.standard_error = standard_error_of(rough.place->gradient, left_out);
  return rough;
}

std::string reason_without_numbers(const JointFit& fit, int curve) {
  const CurveVerdict verdict = fit.curves[static_cast<std::size_t>(curve)];
  if (verdict != CurveVerdict::estimated) return std::string(word(verdict));
  return std::string(word(fit.verdict));
}

/// The largest gap between neighbouring levels.
double largest_gap(const std::vector<double>& levels) {
  double gap = 0;
  for (std::size_t l = 1; l < levels.size(); ++l) gap = std::max(gap, levels[l] - levels[l - 1]);
  return gap;
}

/// estimate -+ half, open where it leaves [low, high].
LevelInterval interval_within(double x, double half, double low, double high) {
  LevelInterval interval;
  if (x - half >= low) interval.low_x = x - half;
  if (x + half <= high) interval.high_x = x + half;
  return interval;
}

void write_threshold(const RoughPlace& rough, const std::vector<double>& levels, double t, double max_t,
                     JointThreshold& into) {
  into.here.reason = rough.reason;
  into.standard_error = rough.standard_error;
  if (!rough.place) return;
  const double x = rough.place->x, gap = largest_gap(levels);
  const double low = levels.front() - gap, high = levels.back() + gap;
  into.here.ci95 = interval_within(x, t * rough.standard_error, low, high);
  into.simultaneous = interval_within(x, max_t * rough.standard_error, low, high);
  const bool open_low = !std::isfinite(into.here.ci95.low_x),
             open_high = !std::isfinite(into.here.ci95.high_x);
  if (open_low && open_high)
    into.here.reason = "not determined: no level is excluded";
  else if (open_high)
    into.here.reason = "above every level, or not excluded to be";
  else if (open_low)
    into.here.reason = "below every level, or not excluded to be";
  else
    into.here.level_x = x;
  into.beyond_levels = x < levels.front() || x > levels.back();
}

/// Critical value that holds for all places of one quantity together.
double simultaneous_t(const std::vector<RoughPlace>& places, const JointJackknife& left_out, double df) {
  std::vector<Eigen::VectorXd> gradients;
  for (const RoughPlace& rough : places)
    if (rough.place && rough.standard_error > 0)
      gradients.push_back(rough.place->gradient / rough.standard_error);
  const auto count = static_cast<Eigen::Index>(gradients.size());
  if (count < 2) return two_sided_critical(1 - confidence, df);
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const double value = gradients[static_cast<std::size_t>(i)].dot(left_out.covariance *
                                                                      gradients[static_cast<std::size_t>(j)]);
      correlation(i, j) = correlation(j, i) = std::clamp(value, -1.0, 1.0);
    }
  return MaxAbsT(correlation, df).critical(1 - confidence);
}

}  // namespace

std::vector<JointThreshold> joint_thresholds(const JointFit& fit, const JointData& data,
                                             const JointJackknife& left_out) {
  const int curves = fit.model.curves;
  constexpr std::size_t quantities = every_joint_quantity.size();
  std::vector<JointThreshold> rows(static_cast<std::size_t>(curves) * quantities);
  const double df = fit.people - 1, t = fit.estimated() ? two_sided_critical(1 - confidence, df) : nan;
  for (std::size_t q = 0; q < quantities; ++q) {
    std::vector<RoughPlace> places;
    for (int c = 0; c < curves; ++c) {
      JointThreshold& row = rows[static_cast<std::size_t>(c) * quantities + q];
      row.curve = c;
      row.quantity = every_joint_quantity[q];
      row.standard_error = nan;
      const bool known =
          fit.estimated() && fit.curves[static_cast<std::size_t>(c)] == CurveVerdict::estimated;
      places.push_back(
          known ? rough_place(fit, left_out, c, row.quantity, t)
                : RoughPlace{.place = {}, .standard_error = nan, .reason = reason_without_numbers(fit, c)});
    }
    if (!fit.estimated()) {
      for (int c = 0; c < curves; ++c)
        rows[static_cast<std::size_t>(c) * quantities + q].here.reason =
            places[static_cast<std::size_t>(c)].reason;
      continue;
    }
    const double max_t = simultaneous_t(places, left_out, df);
    for (int c = 0; c < curves; ++c)
      write_threshold(places[static_cast<std::size_t>(c)], levels_of_curve(data, c), t, max_t,
                      rows[static_cast<std::size_t>(c) * quantities + q]);
  }
  return rows;
}

MeanBand mean_band(const JointFit& fit, const JointJackknife& left_out, int curve, JointMean mean, double x) {
  const MeanAtX at = mean_at_x(fit.model, fit.theta, curve, mean, x);
  const double half =
      two_sided_critical(1 - confidence, fit.people - 1.0) * standard_error_of(at.gradient, left_out);
  return {.x = x,
          .mean = at.value,
          .low = std::max(0.0, at.value - half),
          .high = std::min(static_cast<double>(fit.model.ratings), at.value + half)};
}

double seen_at(const JointFit& fit, int curve, double x) {
  const JointCurve at = curve_at(fit.model, fit.theta, curve);
  return (1 - at.lapse) * normal_below((at.m - x) / at.s);
}

}  // namespace seamline::analysis
