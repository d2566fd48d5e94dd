#include "analysis/psychometric/likelihood/overdispersion.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace seamline::analysis {

namespace {

/// Terms of sums over single answers: a long likelihood takes a minute with ten times as many.
constexpr double most_terms = 30'000;

/// Of very many rows every so-and-so-many-th is enough: they tell how rows vary. Whether any was left out.
bool thin(FitProblem& problem) {
  double terms = 0;
  for (const UnitCounts& row : problem.rows) terms += std::min(row.n, 256.0);
  const auto stride = static_cast<std::size_t>(std::ceil(terms / most_terms));
  if (stride <= 1) return false;
  std::vector<UnitCounts> kept;
  for (std::size_t i = 0; i < problem.rows.size(); i += stride) kept.push_back(problem.rows[i]);
  problem.levels = problem.rows = std::move(kept);
  problem.no_stimulus = {};  // its rows are among them
  return true;
}

}  // namespace

OverdispersionEstimate estimate_overdispersion(const PsychometricFit& fit) {
  OverdispersionEstimate estimate;
  estimate.ci95.low = 0;
  if (fit.levels.size() < 2) {
    estimate.reason = "not identified: under two levels";
    return estimate;
  }
  FitProblem problem = fit.search.problem;
  const auto& rows = problem.rows;
  if (std::all_of(rows.begin(), rows.end(), [](const UnitCounts& row) { return row.n <= 1; })) {
    estimate.reason = "not identified: one trial a row";
    return estimate;
  }
  const std::size_t all = rows.size();
  if (thin(problem)) estimate.reason = fmt::format("from {} of {} rows", rows.size(), all);
  problem.overdispersed = true;
  Maximum best = maximise(problem, {}, fit.search.best.theta, 0);
  if (fit.search.smooth)
    if (const Maximum other = maximise(problem, {}, fit.search.smooth->theta, 0); other.value > best.value)
      best = other;
  problem.overdispersed = false;  // from here eta is held
  Theta warm = best.theta;
  const auto excess = [&](double eta) {
    const Maximum there = maximise(problem, {}, warm, eta);
    return chi_squared_95 / 2 - (best.value - there.value);
  };
  const auto crossing = [&](double inside, double outside) {
    std::uintmax_t steps = 40;
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, std::min(inside, outside), std::max(inside, outside),
                                          boost::math::tools::eps_tolerance<double>(20), steps);
    return low + (high - low) / 2;
  };
  if (best.eta > 0 && excess(0) < 0) estimate.ci95.low = crossing(best.eta, 0);
  if (excess(largest_eta) < 0) {
    estimate.ci95.high = crossing(best.eta, largest_eta);
    estimate.eta = best.eta;
  } else {
    estimate.reason = "not identified: no overdispersion is excluded";
  }
  return estimate;
}

}  // namespace seamline::analysis
