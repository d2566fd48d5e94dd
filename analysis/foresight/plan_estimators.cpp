#include "analysis/foresight/plan_estimators.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/foresight/joint_estimator.h"
#include "analysis/statistics/interval.h"
#include "analysis/statistics/isotonic.h"
#include "analysis/statistics/resampling.h"

namespace seamline::analysis {
namespace {

constexpr int replicates_of_a_difference = 400;

/// A crossing that may lie beyond the levels tested, as the range that it may lie in.
LevelInterval crossing_range(double level, const std::vector<double>& level_x,
                             std::span<const double> means) {
  const double x = largest_x_at(level, level_x, fit_non_increasing(means).value);
  return {.low_x = x == above_every_level ? level_x.back() : x,
          .high_x = x == below_every_level ? level_x.front() : x};
}

/// Of a crossing less another one, by resampling people as `threshold_differences` does.
LevelInterval difference_interval(const Eigen::MatrixXd& scores, const Eigen::MatrixXd& against, double level,
                                  const std::vector<double>& level_x, std::uint64_t seed) {
  Eigen::MatrixXd joint(scores.rows(), scores.cols() + against.cols());
  joint << scores, against;
  std::vector<LevelInterval> replicates(replicates_of_a_difference);
  for_each_replicate(joint, {.replicates = replicates_of_a_difference, .seed = seed, .threads = 1},
                     [&](int replicate, const Eigen::VectorXd& mean) {
                       const std::span<const double> means(mean.data(),
                                                           static_cast<std::size_t>(mean.size()));
                       const LevelInterval to = crossing_range(level, level_x, means.first(level_x.size()));
                       const LevelInterval from = crossing_range(level, level_x, means.last(level_x.size()));
                       replicates[replicate] = {.low_x = distance_between(to.low_x, from.high_x),
                                                .high_x = distance_between(to.high_x, from.low_x)};
                     });
  return percentile_interval(replicates, expanded_levels(static_cast<int>(scores.rows())));
}

std::vector<LevelInterval> straight_line_intervals(const SimulatedAnswers& answers, int people,
                                                   const std::vector<PlanTarget>& targets,
                                                   std::uint64_t seed) {
  const double guess_rating = mean_guess_rating(answers, people);
  std::map<std::pair<std::size_t, bool>, MeanVector> means;
  const auto scores = [&](std::size_t curve, bool corrected) {
    return scores_of(answers, curve, people, corrected ? std::optional(guess_rating) : std::nullopt);
  };
  std::vector<LevelInterval> intervals;
  for (const PlanTarget& target : targets) {
    const auto& [quantity, curve, against, truth_x] = target;
    if (against) {
      intervals.push_back(difference_interval(scores(curve, quantity.corrected()),
                                              scores(*against, quantity.corrected()), quantity.sought.level,
                                              answers.level_x, seed));
      continue;
    }
    const auto [found, fresh] = means.try_emplace({curve, quantity.corrected()});
    if (fresh) found->second = mean_and_covariance(scores(curve, quantity.corrected()));
    intervals.push_back(level_interval(quantity.sought.level, answers.level_x, found->second, people));
  }
  return intervals;
}

std::optional<double> straight_line_limit(const PlannedPopulation& population, const PlannedCurve& curve,
                                          const PlannedQuantity& quantity,
                                          const std::vector<double>& level_x) {
  std::vector<double> means;
  for (const double x : level_x)
    means.push_back(mean_noticeability(population, curve, x, quantity.sought.mean));
  const double x = largest_x_at(quantity.sought.level, level_x, means);
  return std::isfinite(x) ? std::optional(x) : std::nullopt;
}

}  // namespace

std::string_view word(PlanEstimator estimator) {
  switch (estimator) {
    case PlanEstimator::joint:
      return "joint";
    case PlanEstimator::straight_lines:
      return "straight-lines";
  }
  return {};
}

std::string_view name_of(PlanEstimator estimator) {
  switch (estimator) {
    case PlanEstimator::joint:
      return "the joint model of seeing, guessing and rating";
    case PlanEstimator::straight_lines:
      return "straight lines between isotonic means (the paper's way)";
  }
  return {};
}

std::optional<PlanEstimator> plan_estimator_from_word(std::string_view text) {
  for (const PlanEstimator estimator : {PlanEstimator::joint, PlanEstimator::straight_lines})
    if (word(estimator) == text) return estimator;
  return std::nullopt;
}

std::vector<LevelInterval> planned_intervals(PlanEstimator estimator, const std::vector<PlannedCurve>& curves,
                                             const SimulatedAnswers& answers, int people,
                                             const std::vector<PlanTarget>& targets, std::uint64_t seed) {
  switch (estimator) {
    case PlanEstimator::joint:
      return joint_intervals(curves, answers, people, targets);
    case PlanEstimator::straight_lines:
      return straight_line_intervals(answers, people, targets, seed);
  }
  return {};
}

std::vector<std::optional<double>> limits_of(PlanEstimator estimator, const PlannedPopulation& population,
                                             const std::vector<PlannedCurve>& curves,
                                             const std::vector<PlanTarget>& targets,
                                             const std::vector<double>& level_x) {
  if (estimator == PlanEstimator::joint) return joint_limits(population, curves, targets, level_x);
  std::vector<std::optional<double>> limits;
  for (const PlanTarget& target : targets) {
    const auto limit = [&](std::size_t curve) {
      return straight_line_limit(population, curves[curve], target.quantity, level_x);
    };
    limits.push_back(limit(target.curve));
    if (!target.against || !limits.back()) continue;
    const std::optional<double> other = limit(*target.against);
    limits.back() = other ? std::optional(*limits.back() - *other) : std::nullopt;
  }
  return limits;
}

}  // namespace seamline::analysis
