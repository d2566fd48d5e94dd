#include "analysis/joint/joint_people.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "analysis/ordinal/contrasts/max_t.h"
#include "analysis/ordinal/likelihood/newton.h"
#include "analysis/statistics/many_people.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_pooling_rounds = 60;
constexpr int most_person_iterations = 30;
/// Rounds end when the standard deviations move by less than this share of the group's scale.
constexpr double pooling_tolerance = 1e-3;
/// Of the group's variance at most this share is between people: nobody's own curve is a step.
constexpr double most_between = 0.95;

struct Spread {
  double shift = 0, curve = 0;  ///< variances of u and v
};

/// Prior precision of the shifts of a person's curves: inverse of curve I + shift 11'.
Eigen::MatrixXd precision_of(const Spread& spread, int curves) {
  const double own = 1 / spread.curve;
  const double joint = spread.shift * own * own / (1 + curves * spread.shift * own);
  return own * Eigen::MatrixXd::Identity(curves, curves) - Eigen::MatrixXd::Constant(curves, curves, joint);
}

/// The group's coordinates with a person's own scales. Criteria keep their places on the axis.
Eigen::VectorXd own_coordinates(const JointFit& fit, const Spread& spread) {
  Eigen::VectorXd own = fit.theta;
  const JointModel& model = fit.model;
  const auto changed = [](bool shared, int curve) { return !shared || curve == 0; };
  for (int c = 0; c < model.curves; ++c) {
    const JointCurve group = curve_at(model, fit.theta, c);
    const double between = spread.shift + spread.curve;
    const double scale =
        std::sqrt(std::max((1 - most_between) * group.s * group.s, group.s * group.s - between));
    if (changed(model.sharing.scale, c)) own[model.log_scale(c)] = std::log(scale);
    if (model.ratings == 1 || !changed(model.sharing.criteria, c)) continue;
    const double stretch = group.s / scale, ratings = group.s * group.rho;
    const double own_ratings =
        std::sqrt(std::max((1 - most_between) * ratings * ratings, ratings * ratings - between));
    own[model.first_cut(c)] *= stretch;
    for (Eigen::Index k = 1; k < model.ratings - 1; ++k) own[model.first_cut(c) + k] += std::log(stretch);
    own[model.log_spread(c)] = std::log(own_ratings / scale);
  }
  return own;
}

/// What is known of one person's shifts.
struct PersonPosterior {
  Eigen::VectorXd shift;  ///< one a curve
  Eigen::MatrixXd covariance;
};

PersonPosterior posterior_of(const JointModel& model, const JointCounts& counts, const Eigen::VectorXd& own,
                             const Eigen::MatrixXd& precision, const Eigen::VectorXd& start) {
  const int curves = model.curves;
  const auto at = [&](const Eigen::VectorXd& shift) {
    Eigen::VectorXd theta = own;
    theta.head(curves) += shift;
    const Evaluation all = joint_likelihood(model, counts, theta);
    return Evaluation{.value = all.value - 0.5 * shift.dot(precision * shift),
                      .gradient = all.gradient.head(curves) - precision * shift,
                      .hessian = all.hessian.topLeftCorner(curves, curves) - precision};
  };
  const NewtonResult found = maximise(at, start, most_person_iterations);
  Eigen::LLT<Eigen::MatrixXd> known(-found.evaluation.hessian);
  if (known.info() != Eigen::Success) known.compute(precision);
  return {.shift = found.at, .covariance = known.solve(Eigen::MatrixXd::Identity(curves, curves))};
}

/// The variances that the people's posteriors have on average; from the diagonal and beside it.
Spread spread_of(const std::vector<PersonPosterior>& people, int curves, double largest) {
  double diagonal = 0, beside = 0;
  for (const PersonPosterior& person : people) {
    const Eigen::MatrixXd square = person.shift * person.shift.transpose() + person.covariance;
    diagonal += square.trace() / curves;
    if (curves > 1) beside += (square.sum() - square.trace()) / (curves * (curves - 1));
  }
  const double n = people.size();
  const double least = 1e-6 * largest;
  Spread spread{.shift = std::max(curves > 1 ? beside / n : diagonal / n, least), .curve = least};
  if (curves > 1) spread.curve = std::max(diagonal / n - spread.shift, least);
  const double sum = spread.shift + spread.curve;
  if (sum > most_between * largest) {
    spread.shift *= most_between * largest / sum;
    spread.curve *= most_between * largest / sum;
  }
  return spread;
}

double smallest_scale(const JointFit& fit) {
  double scale = infinity;
  for (int c = 0; c < fit.model.curves; ++c) scale = std::min(scale, curve_at(fit.model, fit.theta, c).s);
  return scale;
}

/// Whose thresholds say how people differ: everybody, or `many_people` evenly spaced rows.
std::vector<Eigen::Index> rows_of_spread(Eigen::Index people) {
  std::vector<Eigen::Index> rows;
  const Eigen::Index count = std::min<Eigen::Index>(people, many_people);
  for (Eigen::Index i = 0; i < count; ++i) rows.push_back(i * people / count);
  return rows;
}

}  // namespace

JointPeople joint_people(const JointFit& fit, const JointData& data) {
  const int curves = fit.model.curves;
  const double scale = smallest_scale(fit), variance = scale * scale;
  Spread spread{.shift = variance / 4, .curve = variance / 16};
  const PersonPosterior nobody{.shift = Eigen::VectorXd::Zero(curves), .covariance = {}};
  const std::vector<Eigen::Index> rows = rows_of_spread(data.answers.rows());
  std::vector<PersonPosterior> people(rows.size(), nobody);
  JointPeople result;
  for (int round = 0; round < most_pooling_rounds; ++round) {
    result.own_theta = own_coordinates(fit, spread);
    const Eigen::MatrixXd precision = precision_of(spread, curves);
    for (std::size_t p = 0; p < people.size(); ++p)
      people[p] =
          posterior_of(fit.model, person_counts(data, rows[p]), result.own_theta, precision, people[p].shift);
    const Spread next = spread_of(people, curves, variance);
    const double moved = std::abs(std::sqrt(next.shift) - std::sqrt(spread.shift)) +
                         std::abs(std::sqrt(next.curve) - std::sqrt(spread.curve));
    if (moved < pooling_tolerance * scale) break;
    spread = next;
  }
  if (people.size() < data.people.size()) {
    people.assign(data.people.size(), nobody);
    for (std::size_t p = 0; p < people.size(); ++p)
      people[p] = posterior_of(fit.model, person_counts(data, static_cast<Eigen::Index>(p)), result.own_theta,
                               precision_of(spread, curves), nobody.shift);
  }
  result.shift_sd = std::sqrt(spread.shift);
  result.curve_sd = std::sqrt(spread.curve);
  const double z = two_sided_critical(1 - confidence, infinity);
  const Eigen::Index width = data.cell_counts();
  for (std::size_t p = 0; p < people.size(); ++p) {
    const auto row = static_cast<Eigen::Index>(p);
    Eigen::VectorXd answers = Eigen::VectorXd::Zero(curves);
    for (std::size_t c = 0; c < data.cells.size(); ++c)
      answers[data.cells[c].curve] +=
          data.answers.row(row).segment(static_cast<Eigen::Index>(c) * width, width).sum();
    for (int c = 0; c < curves; ++c) {
      const double x = fit.theta[fit.model.threshold(c)] + people[p].shift[c],
                   half = z * std::sqrt(people[p].covariance(c, c));
      result.thresholds.push_back({.person = row,
                                   .curve = c,
                                   .x = x,
                                   .ci95 = {.low_x = x - half, .high_x = x + half},
                                   .answers = answers[c]});
    }
  }
  return result;
}

}  // namespace seamline::analysis
