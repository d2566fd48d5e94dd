#include "analysis/foresight/joint_estimator.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/joint/joint_sharing.h"
#include "analysis/joint/joint_thresholds.h"
#include "analysis/ordinal/contrasts/max_t.h"

namespace seamline::analysis {
namespace {

/// Answers at every cell of the study whose estimates are the limit: penalties count for nothing beside them.
constexpr double answers_of_a_limit = 1e7;
/// What the analysis takes for false alarms where there never is one, of as many reference trials.
constexpr double least_chance = 0.5 / answers_of_a_limit;

/// A table without answers.
JointData empty_data(const std::vector<PlannedCurve>& curves, const std::vector<double>& level_x, int ratings,
                     double chance, int people) {
  JointData data;
  data.ratings = ratings;
  for (std::size_t curve = 0; curve < curves.size(); ++curve) {
    data.curves.push_back(name_of(curves[curve]));
    for (const double x : level_x)
      data.cells.push_back({.curve = static_cast<int>(curve), .x = x, .chance = chance});
  }
  for (int p = 0; p < people; ++p) data.people.push_back(std::to_string(p));
  data.references = Eigen::MatrixXd::Zero(people, data.ratings);
  return data;
}

LevelInterval difference_of(const JointFit& fit, const JointJackknife& left_out, const PlanTarget& target,
                            double t) {
  const JointQuantity quantity = target.quantity.joint;
  const std::optional<JointPlace> to =
      place_of(fit.model, fit.theta, static_cast<int>(target.curve), quantity);
  const std::optional<JointPlace> from =
      place_of(fit.model, fit.theta, static_cast<int>(*target.against), quantity);
  if (!to || !from) return {};
  const Eigen::VectorXd gradient = to->gradient - from->gradient;
  const double half = t * std::sqrt(std::max(0.0, gradient.dot(left_out.covariance * gradient)));
  return {.low_x = to->x - from->x - half, .high_x = to->x - from->x + half};
}

}  // namespace

std::vector<LevelInterval> joint_intervals(const std::vector<PlannedCurve>& curves,
                                           const SimulatedAnswers& answers, int people,
                                           const std::vector<PlanTarget>& targets) {
  JointData data =
      empty_data(curves, answers.level_x, answers.task.ratings(), chance_of(answers, people), people);
  data.answers = answers.counts.topRows(people);
  data.references = answers.references.topRows(people);
  const JointFit fit = fit_shared(data, {}, true).fit;
  std::vector<LevelInterval> intervals(targets.size());
  if (!fit.estimated()) return intervals;
  const JointJackknife left_out = leave_people_out(fit, data, 1);
  const auto interval_of = [&](std::size_t curve, const PlannedQuantity& quantity) {
    return joint_threshold(fit, data, left_out, static_cast<int>(curve), quantity.joint).here.ci95;
  };
  const double t = two_sided_critical(1 - confidence, people - 1.0);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const PlanTarget& target = targets[i];
    intervals[i] = interval_of(target.curve, target.quantity);
    if (!target.against) continue;
    const bool both = length_x(intervals[i]) && length_x(interval_of(*target.against, target.quantity));
    intervals[i] = both ? difference_of(fit, left_out, target, t) : LevelInterval{};
  }
  return intervals;
}

std::vector<std::optional<double>> joint_limits(const PlannedPopulation& population,
                                                const std::vector<PlannedCurve>& curves,
                                                const std::vector<PlanTarget>& targets,
                                                const std::vector<double>& level_x) {
  const PlannedTask& task = population.task;
  JointData data = empty_data(curves, level_x, task.ratings(), std::max(task.chance(), least_chance), 1);
  data.answers.resize(1, static_cast<Eigen::Index>(data.cells.size()) * data.cell_counts());
  for (std::size_t cell = 0; cell < data.cells.size(); ++cell)
    data.answers.row(0).segment(static_cast<Eigen::Index>(cell) * data.cell_counts(), data.cell_counts()) =
        answers_of_a_limit *
        answer_shares(population, curves[cell / level_x.size()], data.cells[cell].x).transpose();
  const JointModel model = joint_model(data);
  const std::optional<Eigen::VectorXd> theta = maximise_joint(model, all_counts(data));
  std::vector<std::optional<double>> limits(targets.size());
  if (!theta) return limits;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const JointQuantity quantity = targets[i].quantity.joint;
    const auto place = [&](std::size_t curve) {
      return place_of(model, *theta, static_cast<int>(curve), quantity);
    };
    const std::optional<JointPlace> own = place(targets[i].curve);
    if (!own) continue;
    limits[i] = own->x;
    if (!targets[i].against) continue;
    const std::optional<JointPlace> other = place(*targets[i].against);
    limits[i] = other ? std::optional(own->x - other->x) : std::nullopt;
  }
  return limits;
}

}  // namespace seamline::analysis
