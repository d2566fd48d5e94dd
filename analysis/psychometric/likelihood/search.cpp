#include "analysis/psychometric/likelihood/search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "analysis/psychometric/likelihood/level_bins.h"
#include "study/placement/sigmoid_shape.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int fewest_places = 25, most_places = 61;
constexpr double places_beyond = 0.6;  ///< ranges beyond the tested levels that the grid reaches
constexpr std::size_t most_peaks = 3;
constexpr double far_behind = 1;         ///< log units
constexpr double step_tolerance = 1e-6;  ///< log units
constexpr int most_looks = 4;            ///< at levels pooled in focus
constexpr double scales_in_focus = 8, bins_in_focus = 3;
constexpr double narrower = 0.5;  ///< a focus that is worth another look

/// Between the levels around a place.
double largest_gap_near(const FitProblem& problem, double t) {
  const auto& levels = problem.levels;
  const auto after = std::lower_bound(levels.begin() + 1, levels.end() - 1, t,
                                      [](const UnitCounts& level, double at) { return level.t < at; });
  return std::max((after + 1 < levels.end() ? (after + 1)->t : after->t) - after->t,
                  after->t - (after - 1)->t);
}

std::vector<double> spread(double low, double high, std::initializer_list<double> shares) {
  std::vector<double> values;
  for (double share : shares) {
    values.push_back(low + share * (high - low));
    if (high <= low) break;
  }
  return values;
}

void lay_grid(Search& search) {
  const FitProblem& problem = search.problem;
  const auto levels = static_cast<int>(problem.levels.size());
  const int places = std::clamp(2 * levels, fewest_places, most_places);
  for (int i = 0; i < places; ++i)
    search.places.push_back((0.5 + places_beyond) * (2.0 * i / (places - 1) - 1));
  const bool irregular = problem.smallest_gap < 0.5 * problem.median_gap && levels <= most_places / 2;
  if (irregular) {  // the levels themselves and the middles between them
    for (std::size_t i = 0; i < problem.levels.size(); ++i) {
      search.places.push_back(problem.levels[i].t);
      if (i > 0) search.places.push_back((problem.levels[i - 1].t + problem.levels[i].t) / 2);
    }
    std::sort(search.places.begin(), search.places.end());
  }
  const double smallest =
      std::clamp(0.25 * (irregular ? problem.smallest_gap : problem.median_gap), 1e-4, 0.05);
  constexpr int scales = 8;
  for (int i = 0; i < scales; ++i)
    search.log_scales.push_back(std::log(smallest) + i * (std::log(3) - std::log(smallest)) / (scales - 1));
  search.log_scales.push_back(std::log(30));
  search.lapses = spread(problem.lower[parameter::lapse], problem.upper[parameter::lapse], {0, 0.2, 1});
  search.guesses = problem.equal_rates ? search.lapses
                                       : spread(problem.lower[parameter::guess],
                                                problem.upper[parameter::guess], {0, 0.1, 0.4, 1});
}

double value_of_levels(const FitProblem& problem, const std::vector<study::SigmoidPoint>& F, double l,
                       double g) {
  const UnitCounts& none = problem.no_stimulus;
  const double blind = problem.sign > 0 ? g : 1 - l;
  double sum = none.n > 0 ? binomial_term(none.k, none.n, blind, 1 - blind).value : 0;
  for (std::size_t i = 0; i < F.size(); ++i) {
    const double A = 1 - g - l;
    sum +=
        binomial_term(problem.levels[i].k, problem.levels[i].n, g + A * F[i].below, l + A * F[i].above).value;
  }
  return sum;
}

/// The guess rates that are tried beside a lapse rate.
std::vector<double> guesses_beside(const Search& search, double lapse) {
  return search.problem.equal_rates ? std::vector{lapse} : search.guesses;
}

Maximum likeliest_cell(const Search& search, double place, double log_scale,
                       std::vector<study::SigmoidPoint>& F) {
  const FitProblem& problem = search.problem;
  const double inverse = problem.sign * std::exp(-log_scale);
  for (std::size_t i = 0; i < F.size(); ++i)
    F[i] = study::sigmoid_point(problem.sigmoid, inverse * (problem.levels[i].t - place));
  Maximum cell{.theta = {place, log_scale, search.lapses.front(), search.guesses.front()},
               .value = -infinity};
  for (double l : search.lapses)
    for (double g : guesses_beside(search, l))
      if (const double value = value_of_levels(problem, F, l, g); value > cell.value) {
        cell.value = value;
        cell.theta[parameter::lapse] = l;
        cell.theta[parameter::guess] = g;
      }
  if (problem.priors.threshold || problem.priors.log2_width || problem.priors.lapse)
    cell.value = objective_value(problem, cell.theta, 0);
  return cell;
}

/// The best cells that no neighbour beats, and the best cell of every scale: a steep peak of the grid, which
/// may lead to a step, does not hide a broad maximum beside it.
std::vector<Theta> starts(const Search& search) {
  const auto rows = static_cast<std::ptrdiff_t>(search.places.size());
  const auto columns = static_cast<std::ptrdiff_t>(search.log_scales.size());
  const auto value = [&](std::ptrdiff_t row, std::ptrdiff_t column) {
    if (row < 0 || row >= rows || column < 0 || column >= columns) return -infinity;
    return search.cells[static_cast<std::size_t>(row * columns + column)].value;
  };
  std::vector<const Maximum*> peaks;
  for (std::ptrdiff_t row = 0; row < rows; ++row)
    for (std::ptrdiff_t column = 0; column < columns; ++column) {
      const double here = value(row, column);
      if (!std::isfinite(here)) continue;
      bool peak = true;
      for (std::ptrdiff_t i = -1; i <= 1 && peak; ++i)
        for (std::ptrdiff_t j = -1; j <= 1 && peak; ++j) peak = value(row + i, column + j) <= here;
      if (peak) peaks.push_back(&search.cells[static_cast<std::size_t>(row * columns + column)]);
    }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Maximum* a, const Maximum* b) { return a->value > b->value; });
  std::vector<Theta> thetas;
  for (std::size_t i = 0; i < std::min(peaks.size(), most_peaks); ++i) thetas.push_back(peaks[i]->theta);
  for (std::ptrdiff_t column = 0; column < columns; ++column) {
    std::ptrdiff_t best = 0;
    for (std::ptrdiff_t row = 1; row < rows; ++row)
      if (value(row, column) > value(best, column)) best = row;
    if (std::isfinite(value(best, column)))
      thetas.push_back(search.cells[static_cast<std::size_t>(best * columns + column)].theta);
  }
  return thetas;
}

/// Data that hardly bend have a long ridge of far thresholds and large scales, up which a climb is slow: its
/// far ends are tried as well.
template <class Consider>
void climb_from_edges(const Search& search, const Consider& consider) {
  const FitProblem& problem = search.problem;
  const Held held{.fixed = {true, false, false, false}, .level = {}};
  for (double edge : {problem.lower[parameter::threshold], problem.upper[parameter::threshold]}) {
    Maximum start{.value = -infinity};
    for (double scale : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0})
      for (double l : search.lapses)
        for (double g : guesses_beside(search, l)) {
          const Theta theta{edge, std::log(scale), l, g};
          if (const double value = objective_value(problem, theta, 0); value > start.value)
            start = {.theta = theta, .value = value};
        }
    if (!std::isfinite(start.value)) continue;
    const Maximum found = maximise(problem, held, start.theta, 0);
    if (std::isfinite(found.value) &&
        found.value > (search.smooth ? search.smooth->value : found.value) - far_behind)
      consider(found.theta);
  }
}

void climb(Search& search) {
  const FitProblem& problem = search.problem;
  const auto consider = [&](const Theta& start) {
    const Maximum found = maximise(problem, {}, start, 0);
    if (std::isfinite(found.value) && (!search.smooth || found.value > search.smooth->value))
      search.smooth = found;
  };
  for (const Theta& start : starts(search)) consider(start);
  if (search.step) {  // a function a little less steep than the step, if that is likelier
    Theta start = search.step->maximum.theta;
    start[parameter::log_scale] += std::log(20);
    consider(start);
  }
  climb_from_edges(search, consider);
  if (!search.smooth || problem.upper[parameter::lapse] <= problem.lower[parameter::lapse]) return;
  const Theta middle = search.smooth->theta;
  for (double pinned : {problem.lower[parameter::lapse], problem.upper[parameter::lapse]}) {
    Theta start = middle;
    start[parameter::lapse] = pinned;
    const Held held{.fixed = {false, false, true, false}, .level = {}};
    consider(maximise(problem, held, start, search.smooth->eta).theta);
  }
}

}  // namespace

Search search_maximum(FitProblem problem) {
  Search search;
  search.problem = std::move(problem);
  lay_grid(search);
  std::vector<study::SigmoidPoint> F(search.problem.levels.size());
  for (double place : search.places)
    for (double log_scale : search.log_scales)
      search.cells.push_back(likeliest_cell(search, place, log_scale, F));
  search.step = likeliest_step(search.problem);
  climb(search);
  search.is_step =
      search.step && (!search.smooth || search.step->maximum.value >= search.smooth->value - step_tolerance);
  if (search.is_step)
    search.best = search.step->maximum;
  else if (search.smooth)
    search.best = *search.smooth;
  return search;
}

Search search_levels(FitProblem problem) {
  if (problem.levels.size() <= most_unpooled_levels || problem.overdispersed)
    return search_maximum(std::move(problem));
  const std::vector<UnitCounts> levels = std::move(problem.levels);
  Focus focus{.low = -0.5, .high = 0.5};
  for (int look = 1;; ++look) {
    problem.levels = pooled_into_bins(levels, focus);
    set_gaps(problem);
    Search search = search_maximum(problem);
    const Theta& theta = search.is_step ? search.step->middle : search.best.theta;
    const double reach = scales_in_focus * std::exp(theta[parameter::log_scale]) +
                         bins_in_focus * largest_gap_near(problem, theta[parameter::threshold]);
    const Focus next{.low = std::max(-0.5, theta[parameter::threshold] - reach),
                     .high = std::min(0.5, theta[parameter::threshold] + reach)};
    const bool is_narrower = next.high - next.low < narrower * (focus.high - focus.low);
    if (!is_narrower || look == most_looks || problem.levels.size() < most_unpooled_levels / 2) return search;
    focus = next;
  }
}

Maximum refit(const FitProblem& problem, const Maximum& start) {
  return refit_with_step(problem, start).maximum;
}

Refit refit_with_step(const FitProblem& problem, const Maximum& start) {
  Refit refit{.maximum = maximise(problem, {}, start.theta, start.eta), .step = {}};
  const double climbed = std::isfinite(refit.maximum.value) ? refit.maximum.value : -infinity;
  refit.step = likeliest_step(problem, climbed - step_tolerance);
  if (refit.step) refit.maximum = refit.step->maximum;
  return refit;
}

}  // namespace seamline::analysis
