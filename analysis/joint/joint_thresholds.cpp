#include "analysis/joint/joint_thresholds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/ordinal/contrasts/max_t.h"
#include "analysis/statistics/distributions.h"

namespace seamline::analysis {

namespace {

/// A place with its standard error, before anything is said of it.
struct RoughPlace {
  std::optional<JointPlace> place;
  double standard_error = nan;
  std::optional<NoThreshold> reason = {};
};

/// The form of the curve is assumed, and no number of people tells how wrong it is: the logarithm of the
/// scale at a level counts as known with this standard error (documentation/explanation/joint_model.md).
constexpr double form_error = 0.05;
/// Seeing falls from 0.96 to 0.04 over so many scales. Where two levels lie farther apart, each unit of the
/// axis more counts as this standard error of the threshold between them (`place_error_of`).
constexpr double widest_gap_scales = 3.5, place_error = 0.15;

double standard_error_of(const Eigen::VectorXd& gradient, const JointJackknife& left_out) {
  return std::sqrt(std::max(0.0, gradient.dot(left_out.covariance * gradient)));
}

/// Whether the floor with its uncertainty reaches the level.
bool level_in_floor(const JointFit& fit, const JointJackknife& left_out, int curve, const SoughtMean& sought,
                    double t) {
  if (sought.mean != JointMean::as_counted) return false;
  const MeanAtX floor = floor_at(fit.model, fit.theta, curve, sought.mean);
  return floor.value + t * standard_error_of(floor.gradient, left_out) >= sought.level;
}

RoughPlace rough_place(const JointFit& fit, const JointJackknife& left_out, int curve, JointQuantity quantity,
                       double t) {
  RoughPlace rough;
  if (fit.model.ratings == 1 && quantity != JointQuantity::detection) {
    rough.reason = NoThreshold::ratings_not_asked;
    return rough;
  }
  const std::optional<SoughtMean> sought = sought_mean(quantity);
  if (sought && level_in_floor(fit, left_out, curve, *sought, t)) {
    rough.reason = NoThreshold::guess_floor;
    return rough;
  }
  rough.place = place_of(fit.model, fit.theta, curve, quantity);
  if (!rough.place) {
    rough.reason = NoThreshold::no_such_place;
    return rough;
  }
  rough.standard_error = standard_error_of(rough.place->gradient, left_out);
  return rough;
}

/// The largest gap between neighbouring levels.
double largest_gap(const std::vector<double>& levels) {
  double gap = 0;
  for (std::size_t l = 1; l < levels.size(); ++l) gap = std::max(gap, levels[l] - levels[l - 1]);
  return gap;
}

/// estimate -+ half, open where it leaves the range.
LevelInterval interval_within(double x, double half, const LevelInterval& range) {
  LevelInterval interval;
  if (x - half >= range.low_x) interval.low_x = x - half;
  if (x + half <= range.high_x) interval.high_x = x + half;
  return interval;
}

/// Where a pivot first leaves its critical value, going from `from` to `to`; infinite when it does not.
template <class Inside>
double first_outside(double from, double to, const Inside& inside) {
  constexpr int steps = 48, halvings = 30;
  double last = from;
  for (int i = 1; i <= steps; ++i) {
    double next = from + (to - from) * i / steps;
    if (inside(next)) {
      last = next;
      continue;
    }
    for (int h = 0; h < halvings; ++h) {
      const double middle = (last + next) / 2;
      (inside(middle) ? last : next) = middle;
    }
    return last;
  }
  return to > from ? infinity : -infinity;
}

/// The distance between the two levels of a curve that its threshold m lies between; 0 outside of them.
double gap_around(const JointModel& model, int curve, double m) {
  double below = -infinity, above = infinity;
  for (const JointCell& cell : model.cells) {
    if (cell.curve != curve || !std::isfinite(cell.x)) continue;
    if (cell.x <= m) below = std::max(below, cell.x);
    if (cell.x >= m) above = std::min(above, cell.x);
  }
  return std::isfinite(above - below) ? above - below : 0;
}

/// What is the same at every level of a curve.
struct PivotCurve {
  MeanAtX floor;
  double place_error = 0;  ///< `place_error_of`
};

PivotCurve pivot_curve(const JointFit& fit, int curve, JointMean mean) {
  return {.floor = floor_at(fit.model, fit.theta, curve, mean), .place_error = place_error_of(fit, curve)};
}

/// `level_pivot` at a level of the curve.
double pivot_at(const PivotCurve& same, const JointFit& fit, const JointJackknife& left_out, int curve,
                const SoughtMean& sought, double x) {
  const MeanAtX& floor = same.floor;
  const MeanAtX at = mean_at_x(fit.model, fit.theta, curve, sought.mean, x);
  const double above = at.value - floor.value, wanted = sought.level - floor.value;
  if (!(above > 0) || !(wanted > 0)) return 0;
  const Eigen::VectorXd gradient = (at.gradient - floor.gradient) / above + floor.gradient / wanted;
  const double of_form = form_error * gradient[fit.model.log_scale(curve)];
  const double of_place = same.place_error * gradient[fit.model.threshold(curve)];
  return std::log(above / wanted) / std::hypot(standard_error_of(gradient, left_out), of_form, of_place);
}

LevelInterval interval_of(const JointFit& fit, const JointJackknife& left_out, int curve,
                          JointQuantity quantity, const RoughPlace& rough, double t,
                          const LevelInterval& range) {
  const double x = rough.place->x;
  const std::optional<SoughtMean> sought = sought_mean(quantity);
  if (!sought)
    return interval_within(x, t * std::hypot(rough.standard_error, place_error_of(fit, curve)), range);
  const PivotCurve same = pivot_curve(fit, curve, sought->mean);
  const auto inside = [&](double at) {
    return std::abs(pivot_at(same, fit, left_out, curve, *sought, at)) <= t;
  };
  LevelInterval interval;
  if (x > range.low_x) interval.low_x = first_outside(x, range.low_x, inside);
  if (x < range.high_x) interval.high_x = first_outside(x, range.high_x, inside);
  return interval;
}

/// What the open ends of an interval say.
std::optional<NoThreshold> reason_of_ends(const LevelInterval& interval) {
  const bool low = !std::isfinite(interval.low_x), high = !std::isfinite(interval.high_x);
  if (low && high) return NoThreshold::open_both;
  if (high) return NoThreshold::open_hardest;
  if (low) return NoThreshold::open_easiest;
  return std::nullopt;
}

/// Thresholds may lie beyond the levels tested by the largest gap between them.
LevelInterval range_of_thresholds(const std::vector<double>& levels) {
  const double gap = largest_gap(levels);
  return {.low_x = levels.front() - gap, .high_x = levels.back() + gap};
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
      const double value = gradients[i].dot(left_out.covariance * gradients[j]);
      correlation(i, j) = correlation(j, i) = std::clamp(value, -1.0, 1.0);
    }
  return MaxAbsT(correlation, df).critical(1 - confidence);
}

/// Writes what is known of a place into its row, without the simultaneous interval.
void write_pointwise(const JointFit& fit, const JointData& data, const JointJackknife& left_out,
                     const RoughPlace& rough, double t, JointThreshold& row) {
  row.here.reason = rough.reason;
  row.standard_error = rough.standard_error;
  if (!rough.place) return;
  const std::vector<double> levels = levels_of_curve(data, row.curve);
  row.here.ci95 = interval_of(fit, left_out, row.curve, row.quantity, rough, t, range_of_thresholds(levels));
  row.here.reason = reason_of_ends(row.here.ci95);
  if (!row.here.reason) row.here.level_x = rough.place->x;
  row.beyond_levels = rough.place->x < levels.front() || rough.place->x > levels.back();
}

RoughPlace known_place(const JointFit& fit, const JointJackknife& left_out, int curve, JointQuantity quantity,
                       double t) {
  if (fit.estimated() && fit.estimated(curve)) return rough_place(fit, left_out, curve, quantity, t);
  // A curve's own reason before that of the whole fit.
  return {
      .place = {}, .standard_error = nan, .reason = fit.estimated(curve) ? fit.verdict : fit.curves[curve]};
}

double pointwise_t(const JointFit& fit) {
  return fit.estimated() ? two_sided_critical(1 - confidence, fit.people - 1) : nan;
}

}  // namespace

double place_error_of(const JointFit& fit, int curve) {
  const JointCurve at = curve_at(fit.model, fit.theta, curve);
  return place_error * std::max(0.0, gap_around(fit.model, curve, at.m) - widest_gap_scales * at.s);
}

double level_pivot(const JointFit& fit, const JointJackknife& left_out, int curve, const SoughtMean& sought,
                   double x) {
  return pivot_at(pivot_curve(fit, curve, sought.mean), fit, left_out, curve, sought, x);
}

JointThreshold joint_threshold(const JointFit& fit, const JointData& data, const JointJackknife& left_out,
                               int curve, JointQuantity quantity) {
  JointThreshold row{
      .curve = curve, .quantity = quantity, .here = {}, .simultaneous = {}, .standard_error = nan};
  const double t = pointwise_t(fit);
  write_pointwise(fit, data, left_out, known_place(fit, left_out, curve, quantity, t), t, row);
  return row;
}

std::vector<JointThreshold> joint_thresholds(const JointFit& fit, const JointData& data,
                                             const JointJackknife& left_out) {
  const int curves = fit.model.curves;
  constexpr std::size_t quantities = every_joint_quantity.size();
  std::vector<JointThreshold> rows(curves * quantities);
  const double t = pointwise_t(fit);
  for (std::size_t q = 0; q < quantities; ++q) {
    std::vector<RoughPlace> places;
    for (int c = 0; c < curves; ++c) {
      JointThreshold& row = rows[static_cast<std::size_t>(c) * quantities + q];
      row = {.curve = c,
             .quantity = every_joint_quantity[q],
             .here = {},
             .simultaneous = {},
             .standard_error = nan};
      places.push_back(known_place(fit, left_out, c, row.quantity, t));
      write_pointwise(fit, data, left_out, places.back(), t, row);
    }
    if (!fit.estimated()) continue;
    const double max_t = simultaneous_t(places, left_out, fit.people - 1.0);
    for (int c = 0; c < curves; ++c) {
      const RoughPlace& rough = places[c];
      JointThreshold& row = rows[static_cast<std::size_t>(c) * quantities + q];
      if (rough.place)
        row.simultaneous = interval_of(fit, left_out, c, row.quantity, rough, max_t,
                                       range_of_thresholds(levels_of_curve(data, c)));
    }
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
