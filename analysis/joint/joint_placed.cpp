#include "analysis/joint/joint_placed.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/joint/joint_quantities.h"
#include "support/running/parallel.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_placed_iterations = 100;
constexpr int most_people_climbed_again = 20;
/// Of the penalty of log sd; its centre is that of log s.
constexpr double log_between_sd = 1.5;
/// Shares of the pooled curve's variance that lie between people, where the search begins.
constexpr std::array<double, 2> between_shares = {0.3, 0.8};
constexpr double least_share_of_integral = 1e-10;

/// One curve of every person, as a model of its own.
struct OneCurve {
  JointModel model;              ///< of one curve
  std::vector<Eigen::Index> to;  ///< of its coordinates, in those of the whole
  std::vector<JointCounts> people;
};

struct PlacedProblem {
  JointModel model;  ///< between_people
  std::vector<OneCurve> curves;
  std::vector<JointCounts> references;  ///< of each person, without answers
};

OneCurve one_curve(const JointModel& model, const JointData& data, int curve) {
  OneCurve one;
  one.model = model;
  one.model.between_people = false;
  one.model.curves = 1;
  one.model.cells.clear();
  const Eigen::Index width = data.cell_counts();
  std::vector<Eigen::Index> columns;
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    if (data.cells[c].curve != curve) continue;
    one.model.cells.push_back(data.cells[c]);
    one.model.cells.back().curve = 0;
    for (Eigen::Index i = 0; i < width; ++i) columns.push_back(static_cast<Eigen::Index>(c) * width + i);
  }
  one.to.resize(one.model.parameters());
  const auto map = [&](Eigen::Index from, Eigen::Index into) { one.to[from] = into; };
  map(one.model.threshold(0), model.threshold(curve));
  map(one.model.log_scale(0), model.log_scale(curve));
  map(one.model.lapse(0), model.lapse(curve));
  if (model.ratings > 1)
    for (Eigen::Index k = 0; k < model.ratings; ++k)
      map(one.model.first_cut(0) + k, model.first_cut(curve) + k);
  for (Eigen::Index r = 0; r < model.ratings - 1; ++r)
    map(one.model.first_guess(0) + r, model.first_guess(curve) + r);
  for (Eigen::Index p = 0; p < data.answers.rows(); ++p) {
    JointCounts counts{.cells = Eigen::VectorXd(static_cast<Eigen::Index>(columns.size())),
                       .references = Eigen::VectorXd::Zero(data.ratings)};
    for (std::size_t i = 0; i < columns.size(); ++i)
      counts.cells[static_cast<Eigen::Index>(i)] = data.answers(p, columns[i]);
    one.people.push_back(std::move(counts));
  }
  return one;
}

PlacedProblem placed_problem(const JointData& data, const JointSharing& sharing) {
  PlacedProblem problem;
  problem.model = joint_model(data, sharing);
  problem.model.between_people = true;
  for (int c = 0; c < problem.model.curves; ++c) problem.curves.push_back(one_curve(problem.model, data, c));
  for (Eigen::Index p = 0; p < data.answers.rows(); ++p)
    problem.references.push_back({.cells = Eigen::VectorXd::Zero(data.answers.cols()),
                                  .references = data.references.row(p).transpose()});
  return problem;
}

Evaluation nothing_known(const JointModel& model) {
  const Eigen::Index n = model.parameters();
  return {.value = 0, .gradient = Eigen::VectorXd::Zero(n), .hessian = Eigen::MatrixXd::Zero(n, n)};
}

/// Adds the logarithm of a person's integral on one curve, with its exact derivatives: those of the shifts'
/// posterior mean (Louis 1982).
void add_integral(const PlacedProblem& problem, const OneCurve& one, const JointCounts& counts,
                  const Eigen::VectorXd& theta, Evaluation& sum) {
  const double between = std::exp(theta[problem.model.log_between()]);
  const auto own_size = static_cast<Eigen::Index>(one.to.size());
  Eigen::VectorXd own(own_size);
  for (Eigen::Index i = 0; i < own_size; ++i) own[i] = theta[one.to[i]];
  const double middle = own[0];
  const std::vector<PeopleNode>& nodes = people_nodes();
  std::vector<double> value(nodes.size());
  double highest = -infinity;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    own[0] = middle + between * nodes[k].shift;
    value[k] = joint_log_likelihood(one.model, counts, own) + std::log(nodes[k].share);
    highest = std::max(highest, value[k]);
  }
  double all = 0;
  for (double& one_value : value) {
    one_value = std::exp(one_value - highest);
    all += one_value;
  }
  // Coordinates of the curve, then log sd.
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(own_size + 1), gradient(own_size + 1);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(own_size + 1, own_size + 1),
                  hessian(own_size + 1, own_size + 1);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double share = value[k] / all, shift = between * nodes[k].shift;
    if (share < least_share_of_integral) continue;
    own[0] = middle + shift;
    const Evaluation at = joint_likelihood(one.model, counts, own);
    gradient << at.gradient, at.gradient[0] * shift;
    hessian.topLeftCorner(own_size, own_size) = at.hessian;
    hessian.col(own_size).head(own_size) = at.hessian.col(0) * shift;
    hessian.row(own_size).head(own_size) = at.hessian.row(0) * shift;
    hessian(own_size, own_size) = at.hessian(0, 0) * shift * shift + at.gradient[0] * shift;
    mean += share * gradient;
    second += share * (hessian + gradient * gradient.transpose());
  }
  second -= mean * mean.transpose();
  sum.value += highest + std::log(all);
  const auto place = [&](Eigen::Index i) { return i == own_size ? problem.model.log_between() : one.to[i]; };
  for (Eigen::Index i = 0; i <= own_size; ++i) {
    sum.gradient[place(i)] += mean[i];
    for (Eigen::Index j = 0; j <= own_size; ++j) sum.hessian(place(i), place(j)) += second(i, j);
  }
}

void add_evaluation(Evaluation& sum, const Evaluation& other) {
  sum.value += other.value;
  sum.gradient += other.gradient;
  sum.hessian += other.hessian;
}

Evaluation of_placed_person(const PlacedProblem& problem, std::size_t person, const Eigen::VectorXd& theta) {
  Evaluation sum = nothing_known(problem.model);
  for (const OneCurve& one : problem.curves)
    if (one.people[person].cells.sum() > 0) add_integral(problem, one, one.people[person], theta, sum);
  if (problem.references[person].references.sum() > 0)
    add_evaluation(sum, joint_likelihood(problem.model, problem.references[person], theta));
  return sum;
}

Evaluation placed_penalty(const JointModel& model, const Eigen::VectorXd& theta) {
  Evaluation penalty = joint_penalty(model, theta);
  const Eigen::Index at = model.log_between();
  const double away = (theta[at] - penalty_centre(model)[model.log_scale(0)]) / log_between_sd;
  penalty.value -= away * away / 2;
  penalty.gradient[at] -= away / log_between_sd;
  penalty.hessian(at, at) -= 1 / (log_between_sd * log_between_sd);
  return penalty;
}

/// Likelihood and penalty without a person; -1: of all.
Evaluation placed_objective(const PlacedProblem& problem, const Eigen::VectorXd& theta, int without) {
  Evaluation sum = placed_penalty(problem.model, theta);
  for (std::size_t p = 0; p < problem.references.size(); ++p)
    if (static_cast<int>(p) != without) add_evaluation(sum, of_placed_person(problem, p, theta));
  return sum;
}

NewtonResult climb_placed(const PlacedProblem& problem, const Eigen::VectorXd& start, int without) {
  return maximise([&](const Eigen::VectorXd& theta) { return placed_objective(problem, theta, without); },
                  start, most_placed_iterations);
}

/// The pooled curves, with a share of their variance between people.
Eigen::VectorXd start_of(const JointFit& pooled, const JointModel& model, double share) {
  Eigen::VectorXd start(model.parameters());
  start << pooled.theta, 0;
  for (int c = 0; c < model.curves; ++c)
    if (c == 0 || !model.sharing.scale) start[model.log_scale(c)] += 0.5 * std::log(1 - share);
  start[model.log_between()] = pooled.theta[pooled.model.log_scale(0)] + 0.5 * std::log(share);
  return start;
}

}  // namespace

JointFit fit_placed(const JointData& data, const JointSharing& sharing) {
  JointFit fit = fit_joint(data, sharing);
  if (!fit.estimated()) return fit;
  const PlacedProblem problem = placed_problem(data, sharing);
  std::optional<NewtonResult> best;
  for (const double share : between_shares) {
    NewtonResult top = climb_placed(problem, start_of(fit, problem.model, share), -1);
    if (top.converged && (!best || top.evaluation.value > best->evaluation.value)) best = std::move(top);
  }
  fit.model = problem.model;
  const bool peak = best && Eigen::LLT<Eigen::MatrixXd>(-best->evaluation.hessian).info() == Eigen::Success;
  if (!peak) {
    fit.verdict = NoThreshold::not_converged;
    fit.explanation = "No maximum of the likelihood was found.";
    return fit;
  }
  fit.theta = best->at;
  fit.penalised = best->evaluation.value;
  fit.log_likelihood = fit.penalised - placed_penalty(fit.model, fit.theta).value;
  fit.hessian = best->evaluation.hessian;
  return fit;
}

PeopleScores placed_scores(const JointModel& model, const JointData& data, const Eigen::VectorXd& theta) {
  const PlacedProblem problem = placed_problem(data, model.sharing);
  PeopleScores all{.information = Eigen::MatrixXd::Zero(theta.size(), theta.size()),
                   .scores = Eigen::MatrixXd(data.answers.rows(), theta.size())};
  for (Eigen::Index p = 0; p < all.scores.rows(); ++p) {
    const Evaluation own = of_placed_person(problem, static_cast<std::size_t>(p), theta);
    all.information -= own.hessian;
    all.scores.row(p) = own.gradient.transpose();
  }
  return all;
}

JointJackknife leave_placed_people_out(const JointFit& fit, const JointData& data, int threads) {
  const PlacedProblem problem = placed_problem(data, fit.model.sharing);
  const auto people = static_cast<int>(data.people.size());
  JointJackknife left{.theta = Eigen::MatrixXd(people, fit.theta.size()), .covariance = {}};
  run_parallel(people, threads, [&](int p) {
    if (people <= most_people_climbed_again) {
      const NewtonResult without = climb_placed(problem, fit.theta, p);
      if (without.converged) {
        left.theta.row(p) = without.at.transpose();
        return;
      }
    }
    const Evaluation own = of_placed_person(problem, static_cast<std::size_t>(p), fit.theta);
    Eigen::LLT<Eigen::MatrixXd> curvature(own.hessian - fit.hessian);
    if (curvature.info() != Eigen::Success) curvature.compute(-fit.hessian);
    left.theta.row(p) = (fit.theta - curvature.solve(own.gradient)).transpose();
  });
  const Eigen::MatrixXd away = left.theta.rowwise() - left.theta.colwise().mean();
  left.covariance = (people - 1.0) / people * away.transpose() * away;
  return left;
}

}  // namespace seamline::analysis
