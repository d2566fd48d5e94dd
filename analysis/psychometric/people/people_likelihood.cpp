#include "analysis/psychometric/people/people_likelihood.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "analysis/ordinal/likelihood/gauss_hermite.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

using Effects = Eigen::Vector2d;  ///< u and v, standard normal
using EffectsMatrix = Eigen::Matrix2d;

constexpr int most_effect_steps = 60;

/// The person's own function.
Theta theta_of_person(const FitProblem& person, const PeopleTheta& theta, const Effects& effects) {
  return with_tied_rates(
      person, {theta[people_parameter::mean] + theta[people_parameter::sd] * effects[0],
               theta[people_parameter::log_scale] + theta[people_parameter::log_scale_sd] * effects[1],
               theta[people_parameter::lapse], theta[people_parameter::guess]});
}

Effects effect_sds(const PeopleTheta& theta) {
  return {theta[people_parameter::sd], theta[people_parameter::log_scale_sd]};
}

/// Derivatives of the person's function by the model's parameters.
Eigen::Matrix<double, 4, 6> person_by_model(const FitProblem& person, const Effects& effects) {
  Eigen::Matrix<double, 4, 6> jacobian = Eigen::Matrix<double, 4, 6>::Zero();
  jacobian.leftCols<4>().setIdentity();
  jacobian(parameter::threshold, people_parameter::sd) = effects[0];
  jacobian(parameter::log_scale, people_parameter::log_scale_sd) = effects[1];
  if (person.equal_rates) {
    jacobian(parameter::guess, people_parameter::lapse) = 1;
    jacobian(parameter::guess, people_parameter::guess) = 0;
  }
  return jacobian;
}

/// Where ln P - (u^2 + v^2) / 2 is highest, and the Cholesky factor of the inverse curvature there, by Fisher
/// scoring, which is positive definite wherever it stands.
struct EffectsPeak {
  Effects at = Effects::Zero();
  EffectsMatrix root = EffectsMatrix::Identity();
};

EffectsPeak peak_of(const FitProblem& person, const PeopleTheta& theta) {
  const Effects sd = effect_sds(theta);
  EffectsPeak peak;
  const auto height = [&](const Effects& effects) {
    return log_likelihood(person, theta_of_person(person, theta, effects), 0) - 0.5 * effects.squaredNorm();
  };
  double here = height(peak.at);
  for (int step = 0;; ++step) {
    const Objective objective = objective_at(person, theta_of_person(person, theta, peak.at), 0);
    const Effects slope = sd.cwiseProduct(objective.gradient.head<2>()) - peak.at;
    const EffectsMatrix curvature = EffectsMatrix::Identity() + sd.asDiagonal() *
                                                                    objective.expected.topLeftCorner<2, 2>() *
                                                                    sd.asDiagonal();
    const Eigen::LLT<EffectsMatrix> factor(curvature);
    peak.root = EffectsMatrix(factor.matrixU()).inverse();
    Effects move = factor.solve(slope);
    if (step == most_effect_steps || slope.dot(move) < 1e-12) return peak;
    if (move.norm() > 2) move *= 2 / move.norm();
    double there = height(peak.at + move);
    for (int halving = 0; halving < 30 && !(there >= here); ++halving) {
      move /= 2;
      there = height(peak.at + move);
    }
    if (!(there >= here)) return peak;
    peak.at += move;
    here = there;
  }
}

/// A node of the quadrature with what is there.
struct EffectsNode {
  Effects effects;
  double log_weight = 0;
  Objective objective;
};

std::vector<EffectsNode> nodes_around(const EffectsPeak& peak, const FitProblem& person,
                                      const PeopleTheta& theta, int nodes) {
  const Effects sd = effect_sds(theta);
  const GaussHermite u = gauss_hermite(sd[0] > 0 ? nodes : 1), v = gauss_hermite(sd[1] > 0 ? nodes : 1);
  std::vector<EffectsNode> all;
  for (Eigen::Index i = 0; i < u.node.size(); ++i)
    for (Eigen::Index j = 0; j < v.node.size(); ++j) {
      const Effects z{u.node[i], v.node[j]};
      EffectsNode node;
      node.effects = peak.at + std::numbers::sqrt2 * (peak.root * z);
      node.objective = objective_at(person, theta_of_person(person, theta, node.effects), 0);
      node.log_weight = std::log(u.weight[i]) + std::log(v.weight[j]) + z.squaredNorm() +
                        node.objective.value - 0.5 * node.effects.squaredNorm();
      all.push_back(node);
    }
  return all;
}

}  // namespace

PeopleProblem make_people_problem(const FitProblem& frame,
                                  const std::vector<std::vector<LevelCounts>>& counts) {
  PeopleProblem people;
  const double largest_log_scale_sd = 5, ranges_of_sd = 5;
  people.lower << frame.lower, 0, 0;
  people.upper << frame.upper, ranges_of_sd, largest_log_scale_sd;
  FitProblem blank = frame;
  blank.levels.clear();
  blank.rows.clear();
  blank.no_stimulus = {};
  blank.priors = {};
  blank.overdispersed = false;
  for (const std::vector<LevelCounts>& rows : counts) {
    FitProblem person = blank;
    std::vector<LevelCounts> levels = pooled_by_level(rows);
    const LevelCounts none = take_no_stimulus(levels, frame.axis);
    const auto unit = [&](const LevelCounts& level, double t) {
      return UnitCounts{
          .t = t, .k = static_cast<double>(level.correct), .n = static_cast<double>(level.trials)};
    };
    for (const LevelCounts& level : levels)
      person.levels.push_back(unit(level, frame.to_unit(axis_value(frame.axis, level.level))));
    if (none.trials > 0) person.no_stimulus = unit(none, no_stimulus_t);
    people.each.push_back(std::move(person));
  }
  return people;
}

PersonPart person_part(const FitProblem& person, const PeopleTheta& theta, int nodes) {
  const EffectsPeak peak = peak_of(person, theta);
  const std::vector<EffectsNode> all = nodes_around(peak, person, theta, nodes);
  double largest = -infinity, sum = 0;
  for (const EffectsNode& node : all) largest = std::max(largest, node.log_weight);
  PersonPart part;
  if (!std::isfinite(largest)) {
    part.value = -infinity;
    return part;
  }
  for (const EffectsNode& node : all) sum += std::exp(node.log_weight - largest);
  part.value = std::log(peak.root.determinant()) - std::log(std::numbers::pi) + largest + std::log(sum);
  PeopleMatrix second = PeopleMatrix::Zero();
  double mean_square = 0, log_scale_square = 0;
  for (const EffectsNode& node : all) {
    const double weight = std::exp(node.log_weight - largest) / sum;
    if (!(weight > 0)) continue;
    const auto jacobian = person_by_model(person, node.effects);
    const PeopleTheta score = jacobian.transpose() * node.objective.gradient;
    part.gradient += weight * score;
    second += weight * (score * score.transpose());
    part.hessian -= weight * (jacobian.transpose() * node.objective.observed * jacobian);
    const Theta own = theta_of_person(person, theta, node.effects);
    part.mean += weight * own[parameter::threshold];
    part.log_scale += weight * own[parameter::log_scale];
    mean_square += weight * own[parameter::threshold] * own[parameter::threshold];
    log_scale_square += weight * own[parameter::log_scale] * own[parameter::log_scale];
  }
  part.hessian += second - part.gradient * part.gradient.transpose();
  part.mean_variance = std::max(0.0, mean_square - part.mean * part.mean);
  part.log_scale_variance = std::max(0.0, log_scale_square - part.log_scale * part.log_scale);
  return part;
}

}  // namespace seamline::analysis
