#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/joint/joint_fit.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_climb_iterations = 100;
constexpr std::array<double, 4> scale_factors = {0.5, 1, 2.5, 8};  ///< of the penalty's scale
constexpr std::array<double, 2> first_cuts = {-1, 1.5};            ///< t_2
/// Thresholds tried, from a third of the range of levels below it to a third above, or two scales from its
/// middle: a wide curve may have its threshold far outside.
constexpr int thresholds_tried = 21;
constexpr double beyond_range = 1.0 / 3, beyond_scales = 2;
constexpr double smoothed_guess = 0.5;
/// Where starts end at tops of different height, as on answers that no psychometric function made, the search
/// goes on from the highest top, moved at random by these standard deviations in turn.
constexpr int most_moves = 64;
constexpr std::array<double, 2> move_sd = {1, 2.5};
constexpr double same_height = 1e-3;  ///< log likelihood

/// Ratings of wrong answers and references, which are guesses, as the guess ratings to begin with.
void start_guesses(const JointModel& model, const JointCounts& counts, Eigen::VectorXd& theta) {
  if (model.ratings == 1) return;
  Eigen::VectorXd wrong = counts.references.array() + smoothed_guess;
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  for (std::size_t c = 0; c < model.cells.size(); ++c)
    wrong += counts.cells.segment(static_cast<Eigen::Index>(c) * width + model.ratings, model.ratings);
  for (int curve = 0; curve < model.curves; ++curve)
    for (Eigen::Index r = 1; r < model.ratings; ++r)
      theta[model.first_guess(curve) + r - 1] = std::log(wrong[r] / wrong[0]);
}

double cell_log_likelihood(const JointModel& model, const JointCounts& counts, const JointCurve& curve,
                           std::size_t cell) {
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  const auto of_cell = counts.cells.segment(static_cast<Eigen::Index>(cell) * width, width);
  const Eigen::VectorXd p = outcome_probabilities(curve, model.cells[cell].x, model.cells[cell].chance);
  double value = 0;
  for (Eigen::Index o = 0; o < width; ++o)
    if (of_cell[o] > 0) value += of_cell[o] * std::log(std::max(p[o], 1e-300));
  return value;
}

/// Moves each curve's threshold to the likeliest of those tried.
void place_thresholds(const JointModel& model, const JointCounts& counts, Eigen::VectorXd& theta) {
  std::size_t first = 0;
  for (int curve = 0; curve < model.curves; ++curve) {
    std::size_t end = first;
    while (end < model.cells.size() && model.cells[end].curve == curve) ++end;
    JointCurve at = curve_at(model, theta, curve);
    const double reach = std::max((0.5 + beyond_range) * model.range_x, beyond_scales * at.s);
    double best = -infinity;
    for (int i = 0; i < thresholds_tried; ++i) {
      at.m = model.centre_x + reach * (2.0 * i / (thresholds_tried - 1) - 1);
      double value = 0;
      for (std::size_t cell = first; cell < end; ++cell)
        value += cell_log_likelihood(model, counts, at, cell);
      if (value <= best) continue;
      best = value;
      theta[model.threshold(curve)] = at.m;
    }
    first = end;
  }
}

/// A move changes every parameter. Beside very many of them it hardly ever ends at a higher top, and each
/// climb takes the cube of their number.
int moves_of(const JointModel& model) {
  constexpr double few_parameters = 100;
  const double share = std::min(1.0, few_parameters / static_cast<double>(model.parameters()));
  return static_cast<int>(most_moves * share * share * share);
}

std::vector<Eigen::VectorXd> starts_of(const JointModel& model, const JointCounts& counts) {
  std::vector<Eigen::VectorXd> starts;
  for (const double factor : scale_factors)
    for (const double cut : first_cuts) {
      if (model.ratings == 1 && cut > first_cuts.front()) break;  // there are no criteria to try
      Eigen::VectorXd start = penalty_centre(model);
      for (int curve = 0; curve < model.curves; ++curve) {
        start[model.log_scale(curve)] = penalty_centre(model)[model.log_scale(curve)] + std::log(factor);
        if (model.ratings > 1) start[model.first_cut(curve)] = cut;
      }
      start_guesses(model, counts, start);
      place_thresholds(model, counts, start);
      starts.push_back(std::move(start));
    }
  return starts;
}

}  // namespace

Evaluation joint_objective(const JointModel& model, const JointCounts& counts, const Eigen::VectorXd& theta) {
  Evaluation sum = joint_likelihood(model, counts, theta);
  const Evaluation penalty = joint_penalty(model, theta);
  sum.value += penalty.value;
  sum.gradient += penalty.gradient;
  sum.hessian += penalty.hessian;
  return sum;
}

std::optional<Eigen::VectorXd> climb_joint(const JointModel& model, const JointCounts& counts,
                                           const Eigen::VectorXd& start) {
  const NewtonResult found =
      maximise([&](const Eigen::VectorXd& theta) { return joint_objective(model, counts, theta); }, start,
               most_climb_iterations);
  if (!found.converged) return std::nullopt;
  return found.at;
}

std::optional<Eigen::VectorXd> maximise_joint(const JointModel& model, const JointCounts& counts) {
  std::optional<Eigen::VectorXd> best;
  double highest = -infinity, lowest = infinity;
  const auto climb_from = [&](const Eigen::VectorXd& start) {
    const std::optional<Eigen::VectorXd> top = climb_joint(model, counts, start);
    if (!top) return;
    const double value = joint_log_likelihood(model, counts, *top) + joint_penalty(model, *top).value;
    lowest = std::min(lowest, value);
    if (value <= highest) return;
    highest = value;
    best = top;
  };
  for (const Eigen::VectorXd& start : starts_of(model, counts)) climb_from(start);
  if (!best || !(highest - lowest > same_height)) return best;
  Random random(model.parameters(), 0);
  const int moves = moves_of(model);
  for (int move = 0; move < moves; ++move) {
    Eigen::VectorXd start = *best;
    for (double& value : start)
      value += move_sd[static_cast<std::size_t>(move) % move_sd.size()] * random.normal();
    climb_from(start);
  }
  return best;
}

}  // namespace seamline::analysis
