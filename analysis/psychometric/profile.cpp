#include "analysis/psychometric/profile.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "stimuli/support/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_strides = 60, most_cuts = 60;
constexpr double stride_growth = 1.7;
constexpr double relative_precision = 1e-6;  ///< of an end, in lengths of the interval's half
constexpr std::size_t scan_climbs = 2;
constexpr double beyond_share = 0.01;  ///< how far beyond a crossing other ridges are looked for

double depth(double best, double value) {
  return std::sqrt(2 * std::max(0.0, best - value));
}

}  // namespace

/// A value of the coordinate and the profile there.
struct Profile::Probe {
  double x = 0, value = 0;
};

struct Profile::Coordinate {
  int index = 0;
  SoughtLevel level = {};
  double lower = 0, upper = 0;  ///< bounds of the search
  double start = 0;             ///< at the maximum
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

Interval Profile::interval(const Coordinate& coordinate, double cut) const {
  return {.low = end(coordinate, cut, -1), .high = end(coordinate, cut, 1)};
}

bool Profile::holds(const SoughtLevel& level, double place, double cut) const {
  const Coordinate coordinate{.index = parameter::threshold,
                              .level = level,
                              .lower = search_.problem.lower[0],
                              .upper = search_.problem.upper[0],
                              .start = place};
  return anywhere(coordinate, place, search_.best).value >= search_.best.value - cut / 2;
}

Maximum Profile::near(const Coordinate& coordinate, double x, const Maximum& warm) const {
  Held held{.fixed = {}, .level = coordinate.level};
  held.fixed[static_cast<std::size_t>(coordinate.index)] = true;
  Theta start = warm.theta;
  if (coordinate.index == 0) {
    start[0] = x;
  } else {
    start[coordinate.index] = x;
  }
  return maximise(search_.problem, held, start, warm.eta);
}

/// The profile from every combination of the grid's nuisance values, climbing from the best.
Maximum Profile::anywhere(const Coordinate& coordinate, double x, const Maximum& warm) const {
  std::array<std::vector<double>, 4> axes = {search_.places, search_.log_scales, search_.lapses,
                                             search_.guesses};
  axes[static_cast<std::size_t>(coordinate.index)] = {x};
  if (coordinate.index == 0) axes[1].insert(axes[1].begin(), search_.problem.lower[1] + 1);
  std::vector<Maximum> found;
  for (double m : axes[0])
    for (double s : axes[1])
      for (double l : axes[2])
        for (double g : axes[3]) {
          const Theta coordinates{m, s, l, g};
          const std::optional<Theta> theta = theta_with(search_.problem, coordinates, coordinate.level);
          if (!theta) continue;
          const double value = objective_value(search_.problem, *theta, 0);
          if (std::isfinite(value)) found.push_back({.theta = coordinates, .value = value});
        }
  const std::size_t kept = std::min(found.size(), scan_climbs);
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end(),
                    [](const Maximum& a, const Maximum& b) { return a.value > b.value; });
  Maximum best = near(coordinate, x, warm);
  if (!std::isfinite(best.value)) best.value = -infinity;
  for (std::size_t i = 0; i < kept; ++i)
    if (const Maximum other = near(coordinate, x, found[i]); other.value > best.value) best = other;
  return best;
}

double Profile::end(const Coordinate& coordinate, double cut, double towards) const {
  const double needed = search_.best.value - cut / 2;
  const double bound = towards > 0 ? coordinate.upper : coordinate.lower;
  double inside = coordinate.start;
  Maximum warm = search_.best;
  if (coordinate.index < 2)  // a second peak further out
    for (const Maximum& cell : search_.cells) {
      if (cell.value < needed) continue;
      const double x = coordinate.index == 0
                           ? place_of(search_.problem, cell.theta, coordinate.level).value_or(inside)
                           : cell.theta[coordinate.index];
      if (towards * (x - inside) > 0 && towards * (bound - x) >= 0) {
        inside = x;
        warm = cell;
      }
    }
  if (towards * (bound - inside) <= 0) return towards * infinity;

  const double sd = std::sqrt(coordinate_variance(search_.problem, search_.best, coordinate.index));
  const double whole = coordinate.index < 2 ? 1 : coordinate.upper - coordinate.lower;
  double stride =
      std::isfinite(sd) && sd > 0 ? std::clamp(sd * std::sqrt(cut), 1e-7 * whole, 0.5 * whole) : 0.1 * whole;
  for (int i = 0; i < most_strides; ++i, stride *= stride_growth) {
    double x = towards > 0 ? std::min(bound, inside + stride) : std::max(bound, inside - stride);
    Maximum there = near(coordinate, x, warm);
    if (!(there.value >= needed)) {
      // The crossing on this ridge; a little beyond it every other ridge is looked at.
      const double end = crossing(coordinate, cut, inside, {.x = x, .value = there.value}, warm);
      const double beyond = end + towards * std::max(beyond_share * std::abs(end - coordinate.start), 1e-12);
      x = towards > 0 ? std::min(bound, beyond) : std::max(bound, beyond);
      there = anywhere(coordinate, x, warm);
      if (!(there.value >= needed)) return end;
    }
    if (x == bound) return towards * infinity;
    inside = x;
    warm = there;
  }
  return towards * infinity;
}

/// Illinois' method on the signed root of the deviance, which is nearly straight.
double Profile::crossing(const Coordinate& coordinate, double cut, double inside, const Probe& first_outside,
                         Maximum warm) const {
  const double best = search_.best.value, target = std::sqrt(cut);
  double outside = first_outside.x;
  double f_inside = depth(best, near(coordinate, inside, warm).value) - target;
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
    Maximum there = near(coordinate, x, warm);
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
  for (int i = 0; i < 4; ++i) {
    const bool known =
        i != coordinate && (at.theta[i] <= problem.lower[i] || at.theta[i] >= problem.upper[i]);
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
