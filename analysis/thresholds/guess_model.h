#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "study/placement/trial.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

/// What guessers do, with the letters of documentation/explanation/guess_correction.md: b(c), the probability
/// that a guess falls on position c, and g(r), the probability that a guesser then rates r.
struct Guessers {
  std::vector<double> position = {1.0 / 3, 1.0 / 3, 1.0 / 3};       ///< b, one of `CellShape::positions` each
  std::array<double, study::highest_rating> rating = {1, 0, 0, 0};  ///< g
  double wrong_answers = 0, reference_answers = 0;                  ///< what they were estimated from
  bool position_estimated = false;  ///< false: equal positions are assumed, because the data do not say
  TaskFacts task = {};              ///< what `position` is a choice among

  [[nodiscard]] bool known() const { return wrong_answers + reference_answers > 0; }
  [[nodiscard]] double mean_rating() const;
};

/// Estimates b and g from answers that can only be guesses: wrong choices and reference trials. A wrong
/// choice was made among the other positions, P(c | wrong, right o) = b(c) / (1 - b(o)), so b comes from
/// an EM algorithm whose missing data are the guesses that happened to be right (Dempster, Laird and Rubin
/// 1977, the truncated multinomial). They are not mixed with what is seen: an object on the left that is easy
/// to see is no position bias. `cells` holds `CellShape::of_cell` counts a cell, `references`
/// `CellShape::of_trial`.
///
/// Of a task that asks for yes or no, "no" is no guess: b(yes) is the share of false alarms f among n
/// reference trials, (f + 1/2) / (n + 1) (Hautus 1995), which is never 0 or 1, and g what false alarms were
/// rated.
[[nodiscard]] Guessers estimate_guessers(const Eigen::VectorXd& cells, const Eigen::VectorXd& references,
                                         const TaskFacts& task = {});

/// One cell of the latent-class model. In a trial the object is seen with probability s; then the choice is
/// right and the rating is r with probability q(r). Otherwise it is a guess:
///
///     P(right o, rating r) = s q(r) + (1 - s) b(o) g(r),    P(wrong c, rating r) = (1 - s) b(c) g(r)
struct SeeingCell {
  double saw = 0;                                              ///< s
  std::array<double, study::highest_rating> rating_of_seen{};  ///< q; NaN where s is 0
  double noticeability = 0;  ///< s times the mean of q: corrected for guessing
  double log_likelihood = 0;
  int steps = 0;  ///< of the EM algorithm
  bool converged = false;

  /// NaN where nobody saw.
  [[nodiscard]] double mean_rating_of_seen() const {
    return std::isgreater(saw, 0) ? noticeability / saw : nan;
  }
};

/// Fits s and q of one cell by EM for given guessers. In v(r) = s q(r) the log likelihood is concave, so what
/// EM climbs to is its one maximum. Starts at the moment estimate. Without answers everything is NaN.
/// `counts` are the cell's, `CellShape::of_cell` of them; `trace`, when given, receives the log likelihood
/// before each step and at the end.
[[nodiscard]] SeeingCell fit_seeing(const double* counts, const Guessers& guessers, double tolerance = 1e-8,
                                    std::vector<double>* trace = nullptr);

}  // namespace seamline::analysis
