#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline {

/// Below both of these a participant does not agree with the others: the values in use with ITU-T P.913.
inline constexpr double least_stimulus_correlation = 0.75;
inline constexpr double least_condition_correlation = 0.80;

/// How a participant's scores go with the mean scores of the others.
struct CorrelationCheck {
  /// Pearson correlations over stimuli (r1) and over conditions, the means of the stimuli of each (r2); NaN
  /// when the participant or the others do not vary.
  double stimuli = 0, conditions = 0;
  bool rejected = false;
};

/// The correlation screening of ITU-T P.913, with each participant compared with the mean of the *others*, so
/// that nobody agrees with themselves: rejected when r1 < `least_stimulus_correlation` and r2 <
/// `least_condition_correlation`. Somebody who gives the same score to everything is rejected when the others
/// vary; nobody is when the others do not, or with fewer than three people. `score` is people x stimuli, NaN
/// where there is no score; `condition` numbers the condition of each stimulus. One entry a person.
[[nodiscard]] std::vector<CorrelationCheck> screen_by_correlation(const Eigen::MatrixXd& score,
                                                                  const std::vector<int>& condition);

/// Pearson correlation over the places where both are numbers; NaN when there are under three, or one side
/// does not vary.
[[nodiscard]] double pearson_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace seamline
