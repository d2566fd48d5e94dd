#include "analysis/joint/joint_goodness.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/many_people.h"
#include "support/arithmetic/random.h"
#include "support/running/parallel.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

struct OutcomeDistances {
  double choices = 0, ratings = 0;
};

double deviance(double observed, double expected) {
  return observed > 0 ? 2 * observed * std::log(observed / std::max(expected, 1e-300)) : 0;
}

/// G^2 of choices and of ratings of right answers given that they are right.
OutcomeDistances distances(const JointModel& model, const Eigen::VectorXd& counts,
                           const Eigen::VectorXd& theta) {
  OutcomeDistances sum;
  const Eigen::Index k = model.ratings, width = 2 * k;
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    const JointCell& cell = model.cells[c];
    const auto of_cell = counts.segment(static_cast<Eigen::Index>(c) * width, width);
    const double right = of_cell.head(k).sum(), wrong = of_cell.tail(k).sum(), all = right + wrong;
    if (all <= 0) continue;
    const Eigen::VectorXd p = outcome_probabilities(curve_at(model, theta, cell.curve), cell.x, cell.chance);
    const double p_right = p.head(k).sum();
    sum.choices += deviance(right, all * p_right) + deviance(wrong, all * (1 - p_right));
    for (Eigen::Index r = 0; r < k; ++r) sum.ratings += deviance(of_cell[r], right * p[r] / p_right);
  }
  return sum;
}

/// One outcome of a cell.
Eigen::Index draw_outcome(const Eigen::VectorXd& p, Random& random) {
  double rest = random.uniform() * p.sum();
  for (Eigen::Index o = 0; o + 1 < p.size(); ++o) {
    rest -= p[o];
    if (rest < 0) return o;
  }
  return p.size() - 1;
}

/// A person's shifts of all curves.
void draw_shifts(const JointPeople& people, Random& random, std::vector<double>& shift) {
  const double own = people.shift_sd * random.normal();
  for (double& of_curve : shift) of_curve = own + people.curve_sd * random.normal();
}

/// Answers of `asked` people to a cell, all of them with one shift.
void add_answers(const JointModel& model, JointCurve curve, Eigen::Index c, double shift, int asked,
                 Random& random, JointCounts& counts) {
  const JointCell& cell = model.cells[c];
  curve.m += shift;
  const Eigen::VectorXd probabilities = outcome_probabilities(curve, cell.x, cell.chance);
  for (int i = 0; i < asked; ++i)
    counts.cells[c * probabilities.size() + draw_outcome(probabilities, random)] += 1;
}

/// Of many people: shifts are rounded to a twentieth of their standard deviation, and people with equal ones
/// are asked together.
void add_answers_of_many(const JointModel& model, const JointPeople& people, const Eigen::MatrixXi& answers,
                         const std::vector<JointCurve>& group, Random& random, JointCounts& counts) {
  constexpr int steps_a_sd = 20, farthest = 6 * steps_a_sd;
  const double step = std::hypot(people.shift_sd, people.curve_sd) / steps_a_sd;
  Eigen::MatrixXi asked = Eigen::MatrixXi::Zero(answers.cols(), 2 * farthest + 1);
  std::vector<double> shift(group.size());
  for (Eigen::Index p = 0; p < answers.rows(); ++p) {
    draw_shifts(people, random, shift);
    for (Eigen::Index c = 0; c < answers.cols(); ++c) {
      const double away = shift[model.cells[c].curve] / step;
      asked(c, farthest + static_cast<Eigen::Index>(
                              std::lround(std::clamp<double>(away, -farthest, farthest)))) += answers(p, c);
    }
  }
  for (Eigen::Index c = 0; c < asked.rows(); ++c)
    for (Eigen::Index s = 0; s < asked.cols(); ++s)
      if (asked(c, s) > 0)
        add_answers(model, group[model.cells[c].curve], c, static_cast<double>(s - farthest) * step,
                    asked(c, s), random, counts);
}

/// Answers of people like those of the fit, as many in each cell as there were.
JointCounts simulate_answers(const JointModel& model, const JointPeople& people,
                             const Eigen::MatrixXi& answers, const Eigen::VectorXi& references,
                             Random& random) {
  JointCounts counts{.cells = Eigen::VectorXd::Zero(answers.cols() * 2 * model.ratings),
                     .references = Eigen::VectorXd::Zero(model.ratings)};
  std::vector<JointCurve> group;
  for (int c = 0; c < model.curves; ++c) group.push_back(curve_at(model, people.own_theta, c));
  if (answers.rows() > many_people) {
    add_answers_of_many(model, people, answers, group, random, counts);
  } else {
    std::vector<double> shift(group.size());
    for (Eigen::Index p = 0; p < answers.rows(); ++p) {
      draw_shifts(people, random, shift);
      for (Eigen::Index c = 0; c < answers.cols(); ++c) {
        const std::size_t curve = model.cells[c].curve;
        if (answers(p, c) > 0)
          add_answers(model, group[curve], c, shift[curve], answers(p, c), random, counts);
      }
    }
  }
  const Eigen::VectorXd guess = Eigen::Map<const Eigen::VectorXd>(group.front().g.data(), model.ratings);
  for (int i = 0; i < references.sum(); ++i) counts.references[draw_outcome(guess, random)] += 1;
  return counts;
}

/// How many answers each person gave in each cell, in whole numbers.
Eigen::MatrixXi answers_in_cells(const JointData& data) {
  const Eigen::Index width = data.cell_counts();
  Eigen::MatrixXi answers(data.answers.rows(), static_cast<Eigen::Index>(data.cells.size()));
  for (Eigen::Index p = 0; p < answers.rows(); ++p)
    for (Eigen::Index c = 0; c < answers.cols(); ++c)
      answers(p, c) = static_cast<int>(std::lround(data.answers.row(p).segment(c * width, width).sum()));
  return answers;
}

std::vector<ScoreCell> score_cells(const JointFit& fit, const Eigen::VectorXd& counts) {
  std::vector<ScoreCell> cells;
  const JointModel& model = fit.model;
  const Eigen::Index k = model.ratings, width = 2 * k;
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    const JointCell& cell = model.cells[c];
    const auto of_cell = counts.segment(static_cast<Eigen::Index>(c) * width, width);
    const double all = of_cell.sum();
    const Eigen::VectorXd p =
        outcome_probabilities(curve_at(model, fit.theta, cell.curve), cell.x, cell.chance);
    for (int score = 0; score <= model.ratings; ++score)
      cells.push_back({.curve = cell.curve,
                       .x = cell.x,
                       .score = score,
                       .observed = score == 0 ? of_cell.tail(k).sum() : of_cell[score - 1],
                       .expected = all * (score == 0 ? p.tail(k).sum() : p[score - 1])});
  }
  return cells;
}

}  // namespace

JointGoodness joint_goodness(const JointFit& fit, const JointData& data, const JointPeople& people,
                             const JointGoodnessRequest& request) {
  const JointCounts counts = all_counts(data);
  const OutcomeDistances here = distances(fit.model, counts.cells, fit.theta);
  JointGoodness goodness{.cells = score_cells(fit, counts.cells),
                         .choices_g2 = here.choices,
                         .ratings_g2 = here.ratings,
                         .choices_p = nan,
                         .ratings_p = nan,
                         .replicates = 0};
  const Eigen::MatrixXi answers = answers_in_cells(data);
  Eigen::VectorXi references(data.ratings);
  for (Eigen::Index r = 0; r < references.size(); ++r)
    references[r] = static_cast<int>(std::lround(counts.references[r]));
  std::vector<OutcomeDistances> replicates(static_cast<std::size_t>(std::max(0, request.replicates)),
                                           {.choices = nan, .ratings = nan});
  run_parallel(request.replicates, request.threads, [&](int replicate) {
    Random random(request.seed, replicate);
    const JointCounts drawn = simulate_answers(fit.model, people, answers, references, random);
    if (const std::optional<Eigen::VectorXd> top = climb_joint(fit.model, drawn, fit.theta))
      replicates[replicate] = distances(fit.model, drawn.cells, *top);
  });
  int further_choices = 0, further_ratings = 0;
  for (const OutcomeDistances& one : replicates) {
    if (std::isnan(one.choices)) continue;
    ++goodness.replicates;
    if (one.choices >= here.choices) ++further_choices;
    if (one.ratings >= here.ratings) ++further_ratings;
  }
  if (goodness.replicates == 0) return goodness;
  goodness.choices_p = (1.0 + further_choices) / (1 + goodness.replicates);
  if (data.ratings > 1) goodness.ratings_p = (1.0 + further_ratings) / (1 + goodness.replicates);
  return goodness;
}

}  // namespace seamline::analysis
