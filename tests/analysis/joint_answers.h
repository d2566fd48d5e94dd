#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "analysis/joint/joint_fit.h"
#include "support/arithmetic/random.h"

namespace seamline::test {

/// What people answer whose curves are those of the joint model. With `people_sd` their thresholds differ.
struct JointAnswers {
  std::vector<double> m = {8.2, 7.5, 9.2, 9.8};
  std::vector<double> levels = {6, 7, 8, 9, 10, 11, 12};
  analysis::JointCurve shape = {.m = 0,
                                .s = 1.1,
                                .lapse = 0.02,
                                .t = {0.2, 0.9, 1.7},
                                .rho = 0.9,
                                .g = {0.7, 0.2, 0.06, 0.04},
                                .ratings = 4};
  double people_sd = 0;
  int people = 20, objects = 3;
};

/// No answers yet.
inline analysis::JointData empty_answers(const JointAnswers& of, double chance = 1.0 / 3) {
  analysis::JointData data;
  data.ratings = of.shape.ratings;
  for (std::size_t c = 0; c < of.m.size(); ++c) {
    data.curves.push_back("curve " + std::to_string(c + 1));
    for (const double x : of.levels)
      data.cells.push_back({.curve = static_cast<int>(c), .x = x, .chance = chance});
  }
  for (int p = 0; p < of.people; ++p) data.people.push_back("p" + std::to_string(p + 1));
  data.answers =
      Eigen::MatrixXd::Zero(of.people, static_cast<Eigen::Index>(data.cells.size()) * data.cell_counts());
  data.references = Eigen::MatrixXd::Zero(of.people, data.ratings);
  return data;
}

inline analysis::JointData draw_answers(const JointAnswers& of, std::uint64_t seed) {
  analysis::JointData data = empty_answers(of);
  Random random(seed);
  for (Eigen::Index p = 0; p < data.answers.rows(); ++p) {
    const double shift = of.people_sd * random.normal();
    for (std::size_t c = 0; c < data.cells.size(); ++c) {
      analysis::JointCurve curve = of.shape;
      curve.m = of.m[static_cast<std::size_t>(data.cells[c].curve)] + shift;
      const Eigen::VectorXd probability =
          analysis::outcome_probabilities(curve, data.cells[c].x, data.cells[c].chance);
      for (int object = 0; object < of.objects; ++object) {
        double rest = random.uniform();
        Eigen::Index outcome = 0;
        while (outcome + 1 < probability.size() && rest >= probability[outcome])
          rest -= probability[outcome++];
        data.answers(p, static_cast<Eigen::Index>(c) * data.cell_counts() + outcome) += 1;
      }
    }
  }
  return data;
}

/// The answers that are expected of as many people as there are, in fractions.
inline analysis::JointData expected_answers(const JointAnswers& of) {
  analysis::JointData data = empty_answers(of);
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    analysis::JointCurve curve = of.shape;
    curve.m = of.m[static_cast<std::size_t>(data.cells[c].curve)];
    data.answers.middleCols(static_cast<Eigen::Index>(c) * data.cell_counts(), data.cell_counts()).rowwise() =
        of.objects *
        analysis::outcome_probabilities(curve, data.cells[c].x, data.cells[c].chance).transpose();
  }
  return data;
}

}  // namespace seamline::test
