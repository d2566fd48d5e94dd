#include "analysis/joint/joint_likelihood.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/joint/joint_cell.h"

namespace seamline::analysis {

namespace {

void spread_into(const CurveTerms& terms, const CurveSum& sum, Evaluation& total) {
  total.value += sum.value;
  for (std::size_t i = 0; i < terms.to.size(); ++i) {
    if (terms.to[i] < 0) continue;
    total.gradient[terms.to[i]] += sum.gradient[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j < terms.to.size(); ++j)
      if (terms.to[j] >= 0)
        total.hessian(terms.to[i], terms.to[j]) +=
            sum.hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
}

Evaluation zero_evaluation(const JointModel& model) {
  const Eigen::Index n = model.parameters();
  return {.value = 0, .gradient = Eigen::VectorXd::Zero(n), .hessian = Eigen::MatrixXd::Zero(n, n)};
}

/// The quadratic penalty of one coordinate.
void pull(Evaluation& penalty, const Eigen::VectorXd& theta, Eigen::Index at, double centre, double sd) {
  const double away = (theta[at] - centre) / sd;
  penalty.value -= away * away / 2;
  penalty.gradient[at] -= away / sd;
  penalty.hessian(at, at) -= 1 / (sd * sd);
}

// Of the penalties, as the header says.
constexpr double threshold_sd_ranges = 2, log_scale_sd = 1.5, lapse_centre = -1, lapse_sd = 1.5, cut_sd = 4,
                 distance_sd = 1.5, spread_sd = 1, scales_in_range = 7, guess_answers = 0.5;

}  // namespace

JointCounts all_counts(const JointData& data) {
  return {.cells = data.answers.colwise().sum().transpose(),
          .references = data.references.colwise().sum().transpose()};
}

JointCounts person_counts(const JointData& data, Eigen::Index person) {
  return {.cells = data.answers.row(person).transpose(),
          .references = data.references.row(person).transpose()};
}

Evaluation joint_likelihood(const JointModel& model, const JointCounts& counts,
                            const Eigen::VectorXd& theta) {
  Evaluation total = zero_evaluation(model);
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  std::size_t c = 0;
  for (int curve = 0; curve < model.curves; ++curve) {
    const CurveTerms terms = terms_of(model, theta, curve);
    CellSum sum;
    for (; c < model.cells.size() && model.cells[c].curve == curve; ++c) {
      const auto of_cell = counts.cells.segment(static_cast<Eigen::Index>(c) * width, width);
      if ((of_cell.array() > 0).any()) add_cell(terms, model.cells[c], of_cell, sum);
    }
    // Nobody's curve is shown in a reference trial: where curves have their own guess ratings each has a
    // share.
    for (int r = 0; r < model.ratings; ++r) sum.guesses[r] += counts.references[r] / model.curves;
    spread_into(terms, curve_sum(terms, sum), total);
  }
  return total;
}

Eigen::MatrixXd outcome_scores(const JointModel& model, const Eigen::VectorXd& theta) {
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  Eigen::MatrixXd scores =
      Eigen::MatrixXd::Zero(model.parameters(), static_cast<Eigen::Index>(model.cells.size()) * width);
  std::vector<CurveTerms> curves;
  for (int curve = 0; curve < model.curves; ++curve) curves.push_back(terms_of(model, theta, curve));
  Eigen::VectorXd once = Eigen::VectorXd::Zero(width);  // one answer
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    const CurveTerms& terms = curves[model.cells[c].curve];
    for (Eigen::Index outcome = 0; outcome < width; ++outcome) {
      once[outcome] = 1;
      CellSum sum;
      add_cell(terms, model.cells[c], once, sum);
      once[outcome] = 0;
      const auto score = curve_gradient(terms, sum);
      for (std::size_t i = 0; i < terms.to.size(); ++i)
        if (terms.to[i] >= 0)
          scores(terms.to[i], static_cast<Eigen::Index>(c) * width + outcome) =
              score[static_cast<Eigen::Index>(i)];
    }
  }
  return scores;
}

Eigen::MatrixXd person_scores(const JointModel& model, const JointData& data, const Eigen::VectorXd& theta) {
  JointCounts one{.cells = Eigen::VectorXd::Zero(data.answers.cols()),
                  .references = Eigen::VectorXd::Zero(data.ratings)};
  Eigen::MatrixXd of_reference(model.parameters(), data.ratings);
  for (Eigen::Index r = 0; r < data.ratings; ++r) {
    one.references.setZero();
    one.references[r] = 1;
    of_reference.col(r) = joint_likelihood(model, one, theta).gradient;
  }
  return data.answers * outcome_scores(model, theta).transpose() + data.references * of_reference.transpose();
}

double joint_log_likelihood(const JointModel& model, const JointCounts& counts,
                            const Eigen::VectorXd& theta) {
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  double value = 0;
  std::vector<JointCurve> curves;
  for (int curve = 0; curve < model.curves; ++curve) {
    curves.push_back(curve_at(model, theta, curve));
    for (int r = 0; r < model.ratings; ++r)
      if (counts.references[r] > 0)
        value +=
            counts.references[r] / model.curves * std::log(std::max(least_probability, curves.back().g[r]));
  }
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    const auto of_cell = counts.cells.segment(static_cast<Eigen::Index>(c) * width, width);
    const JointCell& cell = model.cells[c];
    const Eigen::VectorXd p = outcome_probabilities(curves[cell.curve], cell.x, cell.chance);
    for (Eigen::Index o = 0; o < width; ++o)
      if (of_cell[o] > 0) value += of_cell[o] * std::log(std::max(least_probability, p[o]));
  }
  return value;
}

Eigen::VectorXd penalty_centre(const JointModel& model) {
  Eigen::VectorXd centre = Eigen::VectorXd::Zero(model.parameters());
  for (int curve = 0; curve < model.curves; ++curve) {
    centre[model.threshold(curve)] = model.centre_x;
    centre[model.log_scale(curve)] = std::log(model.range_x / scales_in_range);
    centre[model.lapse(curve)] = lapse_centre;
  }
  return centre;
}

Evaluation joint_penalty(const JointModel& model, const Eigen::VectorXd& theta) {
  Evaluation penalty = zero_evaluation(model);
  const Eigen::VectorXd centre = penalty_centre(model);
  const auto first = [](bool shared, int curve) { return !shared || curve == 0; };
  for (int curve = 0; curve < model.curves; ++curve) {
    const auto at = [&](Eigen::Index place, double sd) { pull(penalty, theta, place, centre[place], sd); };
    at(model.threshold(curve), threshold_sd_ranges * model.range_x);
    if (first(model.sharing.scale, curve)) at(model.log_scale(curve), log_scale_sd);
    if (first(model.sharing.lapse, curve)) at(model.lapse(curve), lapse_sd);
    if (model.ratings == 1) continue;
    if (first(model.sharing.criteria, curve)) {
      at(model.first_cut(curve), cut_sd);
      for (Eigen::Index k = 1; k < model.ratings - 1; ++k) at(model.first_cut(curve) + k, distance_sd);
      at(model.log_spread(curve), spread_sd);
    }
    if (!first(model.sharing.guess_ratings, curve)) continue;
    CellSum half;
    half.guesses.fill(guess_answers);
    const CurveTerms terms = terms_of(model, theta, curve);
    spread_into(terms, curve_sum(terms, half), penalty);
  }
  return penalty;
}

}  // namespace seamline::analysis
