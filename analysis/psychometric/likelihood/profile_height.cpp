#include "analysis/psychometric/likelihood/profile_height.h"

#include <algorithm>
#include <cmath>

#include "analysis/psychometric/likelihood/profile.h"
#include "analysis/statistics/distributions.h"
#include "study/placement/sigmoid_shape.h"

namespace seamline::analysis {

namespace {

constexpr std::size_t scan_climbs = 4;
constexpr double steepest_tried = 0.001;  ///< gaps; scales from here on double

/// Scales that may be the likeliest for a level at `place`: the grid's, steeper ones, and those on which a
/// tested level keeps its own performance (the steep ridges).
std::vector<double> log_scales_at(const Search& search, const SoughtLevel& level, double place) {
  const FitProblem& problem = search.problem;
  std::vector<double> log_scales = search.log_scales;
  for (double scale = steepest_tried * problem.smallest_gap; std::log(scale) < search.log_scales.front();
       scale *= 2)
    log_scales.push_back(std::log(scale));
  const auto after = std::upper_bound(problem.levels.begin(), problem.levels.end(), place,
                                      [](double t, const UnitCounts& counts) { return t < counts.t; });
  const auto first = after - std::min<std::ptrdiff_t>(3, after - problem.levels.begin());
  const auto end = after + std::min<std::ptrdiff_t>(3, problem.levels.end() - after);
  for (double l : search.lapses)
    for (double g : search.guesses) {
      const double A = 1 - g - l,
                   sought = level.of == SoughtLevel::Of::sigmoid ? level.share : (level.share - g) / A;
      if (!(sought > 0 && sought < 1)) continue;
      const double z = study::sigmoid_quantile(problem.sigmoid, sought);
      for (auto counts = first; counts != end; ++counts) {
        const double F = (counts->k / counts->n - g) / A;
        if (!(F > 0 && F < 1)) continue;
        const double scale =
            problem.sign * (counts->t - place) / (study::sigmoid_quantile(problem.sigmoid, F) - z);
        if (scale > 0 && std::isfinite(scale) && std::log(scale) > problem.lower[1])
          log_scales.push_back(std::log(scale));
      }
    }
  std::sort(log_scales.begin(), log_scales.end());
  return log_scales;
}

/// Where climbs to the profile at x begin, besides the warm start: the likeliest combinations of a grid, and
/// with the place held the best of every local maximum over the scale.
std::vector<Theta> starts(const Search& search, const ProfileCoordinate& coordinate, double x) {
  std::array<std::vector<double>, 4> axes = {search.places, search.log_scales, search.lapses, search.guesses};
  const bool holds_place = coordinate.index == 0;
  if (holds_place) axes[1] = log_scales_at(search, coordinate.level, x);
  axes[coordinate.index] = {x};
  std::vector<Maximum> found;
  for (double s : axes[1])
    for (double m : axes[0]) {
      Maximum best{.value = -infinity};
      for (double l : axes[2])
        for (double g : axes[3]) {
          const Theta coordinates{m, s, l, g};
          const std::optional<Theta> theta = theta_with(search.problem, coordinates, coordinate.level);
          if (!theta) continue;
          if (const double value = objective_value(search.problem, *theta, 0); value > best.value)
            best = {.theta = coordinates, .value = value};
        }
      if (holds_place || std::isfinite(best.value)) found.push_back(best);
    }
  if (holds_place) {
    std::vector<Maximum> peaks;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool beaten = (i > 0 && found[i - 1].value > found[i].value) ||
                          (i + 1 < found.size() && found[i + 1].value > found[i].value);
      if (!beaten && std::isfinite(found[i].value)) peaks.push_back(found[i]);
    }
    found = std::move(peaks);
  }
  const std::size_t kept = std::min(found.size(), scan_climbs);
  std::partial_sort(found.begin(), found.begin() + kept, found.end(),
                    [](const Maximum& a, const Maximum& b) { return a.value > b.value; });
  std::vector<Theta> thetas;
  for (std::size_t i = 0; i < kept; ++i) thetas.push_back(found[i].theta);
  return thetas;
}

/// What a beta-binomial profile may fall below its maximum beyond what a known eta would allow. Rows are few,
/// so that the likeliest eta is too small and its uncertainty is felt: were all scatter overdispersion,
/// answers would be normal with an unknown variance, whose likelihood ratio falls by N ln(1 + t^2 / (N - p))
/// / 2 at the ends of a 95 % interval. That is allowed in the share of the scatter that is overdispersion at
/// the held value's own eta.
double overdispersion_allowance(const FitProblem& problem, double eta) {
  if (!problem.overdispersed || !(eta > 0)) return 0;
  double share = 0;
  for (const UnitCounts& row : problem.rows) {
    const double extra = (row.n - 1) * eta * eta;
    share += extra / (1 + extra);
  }
  const double rows = problem.rows.size();
  double parameters = 2;
  for (const int rate : {parameter::lapse, parameter::guess})
    if (problem.upper[rate] > problem.lower[rate] && !(problem.equal_rates && rate == parameter::guess))
      parameters += 1;
  const double left = std::max(1.0, rows - parameters);
  const double t = student_quantile(left, 0.975);
  return share / rows * std::max(0.0, rows * std::log1p(t * t / left) - chi_squared_95) / 2;
}

}  // namespace

Maximum climb_held(const Search& search, const ProfileCoordinate& coordinate, double x, const Maximum& warm) {
  Held held{.fixed = {}, .level = coordinate.level};
  held.fixed[coordinate.index] = true;
  Theta start = warm.theta;
  start[coordinate.index] = x;
  Maximum found = maximise(search.problem, held, start, warm.eta);
  found.value += overdispersion_allowance(search.problem, found.eta);
  return found;
}

Maximum highest_profile(const Search& search, const ProfileCoordinate& coordinate, double x,
                        const Maximum& warm, const std::vector<StepFit>& steps) {
  Maximum best = climb_held(search, coordinate, x, warm);
  if (!std::isfinite(best.value)) best.value = -infinity;
  const auto consider = [&](const Theta& start) {
    const Maximum other = climb_held(search, coordinate, x, {.theta = start, .eta = warm.eta});
    if (other.value > best.value) best = other;
  };
  consider(search.best.theta);
  if (search.smooth) consider(search.smooth->theta);
  for (const Theta& start : starts(search, coordinate, x)) consider(start);
  if (coordinate.index != 0)
    for (const StepFit& step : steps) consider(step.middle);
  return best;
}

}  // namespace seamline::analysis
