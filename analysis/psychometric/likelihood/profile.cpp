#include "analysis/psychometric/likelihood/profile.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_strides = 60, most_cuts = 60;
constexpr double stride_growth = 1.7;
constexpr double relative_precision = 1e-6;  ///< of an end, in lengths of the interval's half
constexpr double beyond_share = 0.01;        ///< how far beyond a crossing other ridges are looked for
constexpr std::size_t steps_followed = 16;
constexpr double step_slack = 3;       ///< log units: less likely steps may still start a climb
constexpr int probes_in_gap = 4;       ///< places tried between two levels
constexpr std::size_t most_gaps = 64;  ///< with more levels several count as one gap
constexpr int probes_elsewhere = 8;    ///< of a scale or a rate

double depth(double best, double value) {
  return std::sqrt(2 * std::max(0.0, best - value));
}

}  // namespace

/// A value of the coordinate and the profile there.
struct Profile::Probe {
  double x = 0, value = 0;
};

Interval Profile::place(const SoughtLevel& level, double cut) const {
  const std::optional<double> start = place_of(search_.problem, search_.best.theta, level);
  if (!start) return {};
  return interval({.index = parameter::threshold,
                   .level = level,
                   .lower = search_.problem.lower[0],
                   .upper = search_.problem.upper[0],
                   .start = *start},
                  cut);
}

Interval Profile::log_scale(double cut) const {
  const int i = parameter::log_scale;
  return interval({.index = i,
                   .level = {},
                   .lower = search_.problem.lower[i],
                   .upper = search_.problem.upper[i],
                   .start = search_.best.theta[i]},
                  cut);
}

Interval Profile::rate(int index, double cut) const {
  const double lower = search_.problem.lower[index], upper = search_.problem.upper[index];
  if (upper <= lower) return {.low = lower, .high = upper};
  const Interval found = interval(
      {.index = index, .level = {}, .lower = lower, .upper = upper, .start = search_.best.theta[index]}, cut);
  return {.low = std::max(found.low, lower), .high = std::min(found.high, upper)};
}

Interval Profile::interval(const ProfileCoordinate& coordinate, double cut) const {
  const std::vector<StepFit> steps =
      likely_steps(search_.problem, search_.best.value - cut / 2 - step_slack, steps_followed);
  return {.low = end(coordinate, cut, -1, steps), .high = end(coordinate, cut, 1, steps)};
}

bool Profile::holds(const SoughtLevel& level, double place, double cut) const {
  const ProfileCoordinate coordinate{.index = parameter::threshold,
                                     .level = level,
                                     .lower = search_.problem.lower[0],
                                     .upper = search_.problem.upper[0],
                                     .start = place};
  return highest_profile(search_, coordinate, place, search_.best, {}).value >= search_.best.value - cut / 2;
}

/// Functions known to be within the cut, with their coordinate.
struct Profile::Top {
  double x = 0;
  Maximum at;
};

std::vector<Profile::Top> Profile::tops(const ProfileCoordinate& coordinate, double needed,
                                        const std::vector<StepFit>& steps) const {
  const FitProblem& problem = search_.problem;
  std::vector<Top> tops = {{.x = coordinate.start, .at = search_.best}};
  const auto add = [&](const Theta& theta, const Maximum& at) {
    if (!(at.value >= needed)) return;
    const std::optional<double> x = coordinate.index == 0 ? place_of(problem, theta, coordinate.level)
                                                          : std::optional(theta[coordinate.index]);
    if (x) tops.push_back({.x = *x, .at = at});
  };
  if (search_.smooth) add(search_.smooth->theta, *search_.smooth);
  if (coordinate.index < 2)
    for (const Maximum& cell : search_.cells) add(cell.theta, cell);
  for (const StepFit& step : steps) {
    add(step.maximum.theta, step.maximum);
    if (step.maximum.value < needed) continue;
    if (coordinate.index == 1) tops.push_back({.x = step.largest_log_scale, .at = step.maximum});
    if (coordinate.index != 0 || !place_of(problem, step.maximum.theta, coordinate.level)) continue;
    // In the limit of scale 0 every level of performance lies at the step.
    if (step.through_level) {
      const double m = step.maximum.theta[0];
      const auto level = std::min_element(
          problem.levels.begin(), problem.levels.end(),
          [&](const UnitCounts& a, const UnitCounts& b) { return std::abs(a.t - m) < std::abs(b.t - m); });
      tops.push_back({.x = level->t, .at = step.maximum});
    } else {
      for (double t : {step.low_t, step.high_t})
        if (std::isfinite(t)) tops.push_back({.x = t, .at = step.maximum});
    }
  }
  return tops;
}

/// Where the axis is looked at beyond the end of a ridge, rising.
std::vector<double> Profile::probes(const ProfileCoordinate& coordinate) const {
  std::vector<double> places;
  const double first = coordinate.lower, last = coordinate.upper;
  if (coordinate.index != 0) {
    for (int i = 0; i <= probes_elsewhere; ++i)
      places.push_back(first + (last - first) * i / probes_elsewhere);
    return places;
  }
  const auto& levels = search_.problem.levels;
  const std::size_t stride = 1 + (levels.size() - 1) / most_gaps;
  for (std::size_t i = 0; i + 1 < levels.size(); i += stride) {
    const double low = levels[i].t, high = levels[std::min(i + stride, levels.size() - 1)].t;
    for (int part = 0; part < probes_in_gap; ++part)
      places.push_back(low + (high - low) * (part + 0.5) / probes_in_gap);
  }
  for (double beyond = 0.5; beyond > 0.01; beyond /= 2) {
    places.insert(places.begin(), levels.front().t - beyond);
    places.push_back(levels.back().t + beyond);
  }
  for (double beyond : {1.0, 2.0, 4.0}) {
    places.push_back(levels.front().t - beyond);
    places.push_back(levels.back().t + beyond);
  }
  places.push_back(first);
  places.push_back(last);
  std::sort(places.begin(), places.end());
  return places;
}

/// The crossing of the ridge on which `top` lies, and of those that begin within it.
double Profile::end_of_ridge(const ProfileCoordinate& coordinate, double cut, double towards, Top top,
                             const std::vector<StepFit>& steps) const {
  const double needed = search_.best.value - cut / 2;
  const double bound = towards > 0 ? coordinate.upper : coordinate.lower;
  double inside = top.x;
  Maximum warm = top.at;
  if (towards * (bound - inside) <= 0) return towards * infinity;

  const double sd = std::sqrt(coordinate_variance(search_.problem, search_.best, coordinate.index));
  const double whole = coordinate.index < 2 ? 1 : coordinate.upper - coordinate.lower;
  double stride =
      std::isfinite(sd) && sd > 0 ? std::clamp(sd * std::sqrt(cut), 1e-7 * whole, 0.5 * whole) : 0.1 * whole;
  for (int i = 0; i < most_strides; ++i, stride *= stride_growth) {
    double x = towards > 0 ? std::min(bound, inside + stride) : std::max(bound, inside - stride);
    Maximum there = climb_held(search_, coordinate, x, warm);
    if (!(there.value >= needed)) {
      // The crossing on this ridge; a little beyond it every other ridge is looked at.
      const double end = crossing(coordinate, cut, inside, {.x = x, .value = there.value}, warm);
      const double beyond = end + towards * std::max(beyond_share * std::abs(end - coordinate.start), 1e-12);
      x = towards > 0 ? std::min(bound, beyond) : std::max(bound, beyond);
      there = highest_profile(search_, coordinate, x, warm, steps);
      if (!(there.value >= needed)) return end;
    }
    if (x == bound) return towards * infinity;
    inside = x;
    warm = there;
  }
  return towards * infinity;
}

double Profile::end(const ProfileCoordinate& coordinate, double cut, double towards,
                    const std::vector<StepFit>& steps) const {
  const double needed = search_.best.value - cut / 2;
  const double bound = towards > 0 ? coordinate.upper : coordinate.lower;
  Top outermost{.x = coordinate.start, .at = search_.best};
  for (const Top& top : tops(coordinate, needed, steps))
    if (towards * (top.x - outermost.x) > 0 && towards * (bound - top.x) >= 0) outermost = top;
  const double found = end_of_ridge(coordinate, cut, towards, outermost, steps);
  if (!std::isfinite(found)) return found;
  // Another ridge may rise above the cut further out: every part of the axis is looked at, from far outside.
  std::vector<double> places = probes(coordinate);
  if (towards < 0) std::reverse(places.begin(), places.end());
  for (std::size_t i = places.size(); i-- > 0 && towards * (places[i] - found) > 0;) {
    if (coordinate.index == 0) {
      const double near_side = i > 0 ? places[i - 1] : places[i];
      const double far_side = i + 1 < places.size() ? places[i + 1] : places[i];
      if (bound_.above(coordinate.level, std::min(near_side, far_side), std::max(near_side, far_side)) <
          needed)
        continue;
    }
    const Maximum there = highest_profile(search_, coordinate, places[i], outermost.at, steps);
    if (there.value >= needed)
      return end_of_ridge(coordinate, cut, towards, {.x = places[i], .at = there}, steps);
  }
  return found;
}

/// Illinois' method on the signed root of the deviance, which is nearly straight.
double Profile::crossing(const ProfileCoordinate& coordinate, double cut, double inside,
                         const Probe& first_outside, Maximum warm) const {
  const double best = search_.best.value, target = std::sqrt(cut);
  double outside = first_outside.x;
  double f_inside = depth(best, climb_held(search_, coordinate, inside, warm).value) - target;
  double f_outside = depth(best, first_outside.value) - target;
  if (!std::isfinite(f_outside)) f_outside = 10;
  const auto is_wide =
      [&] {  // of the interval as it is known now: the first stride may have been far too long
        return std::abs(outside - inside) > relative_precision * std::abs(outside - coordinate.start);
      };
  int last_side = 0;
  double x = inside;
  for (int i = 0; i < most_cuts && is_wide(); ++i) {
    const double share = f_inside < 0 ? std::clamp(f_inside / (f_inside - f_outside), 0.02, 0.98) : 0.5;
    x = i % 8 == 7 ? inside + (outside - inside) / 2 : inside + share * (outside - inside);
    Maximum there = climb_held(search_, coordinate, x, warm);
    double f = depth(best, there.value) - target;
    if (!std::isfinite(f)) f = 10;
    if (std::abs(f) < 1e-7) break;
    const int side = f < 0 ? -1 : 1;
    if (side < 0) {
      inside = x;
      f_inside = f;
      warm = there;
      if (last_side == side) f_outside /= 2;
    } else {
      outside = x;
      f_outside = f;
      if (last_side == side) f_inside /= 2;
    }
    last_side = side;
  }
  return x;
}

double coordinate_variance(const FitProblem& problem, const Maximum& at, int coordinate) {
  const Objective objective = objective_at(problem, at.theta, at.eta);
  Eigen::Matrix4d information = objective.expected;
  if (problem.equal_rates) {  // d/d(both) is the sum of d/d(lapse) and d/d(guess)
    information.row(parameter::lapse) += information.row(parameter::guess);
    information.col(parameter::lapse) += information.col(parameter::guess);
  }
  for (int i = 0; i < 4; ++i) {
    const bool known =
        i != coordinate && (at.theta[i] <= problem.lower[i] || at.theta[i] >= problem.upper[i] ||
                            (problem.equal_rates && i == parameter::guess));
    if (!known) continue;
    information.row(i).setZero();
    information.col(i).setZero();
    information(i, i) = 1;
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> factor(information);
  if (!factor.isInvertible()) return infinity;
  const double variance = factor.inverse()(coordinate, coordinate);
  return variance > 0 ? variance : infinity;
}

}  // namespace seamline::analysis
