#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline::analysis {

/// Below both of these ITU-T P.913, in use for video quality, discards a participant. Single forced choices
/// are noisier than ratings of video: at these values some of the good participants of a study like ours are
/// discarded (documentation/explanation/screening.md), so they are reported only.
inline constexpr double p913_stimulus_correlation = 0.75;
inline constexpr double p913_condition_correlation = 0.80;

/// How rarely somebody who looks at nothing may escape the screen.
inline constexpr double escape_probability = 0.001;

/// How a participant's scores go with the mean scores of the others.
struct CorrelationCheck {
  /// Pearson correlations over stimuli (r1) and over conditions, the means of the stimuli of each (r2); NaN
  /// when the participant or the others do not vary.
  double stimuli = 0, conditions = 0;
  double critical = 0;      ///< r1 that somebody who looks at nothing exceeds with `escape_probability`
  bool rejected = false;    ///< r1 does not exceed it
  bool below_p913 = false;  ///< r1 and r2 are under the values of P.913; reported, not used
};

/// Compares each participant with the mean of the *others*, so that nobody agrees with themselves, and
/// rejects those whose scores do not follow it: r1 is not above the critical value of the one-sided t test of
/// no correlation, t = r sqrt((K - 2) / (1 - r^2)) with K - 2 degrees of freedom, K stimuli. Somebody who
/// gives the same score to everything is rejected when the others vary; nobody is when the others do not,
/// with fewer than three people, or with fewer than three stimuli. `score` is people x stimuli, NaN where
/// there is no score; `condition` numbers the condition of each stimulus. One entry a person.
[[nodiscard]] std::vector<CorrelationCheck> screen_by_correlation(const Eigen::MatrixXd& score,
                                                                  const std::vector<int>& condition);

/// The correlation over `count` pairs that unrelated values exceed with `probability`; 1 under three pairs.
[[nodiscard]] double critical_correlation(int count, double probability);

/// Pearson correlation over the places where both are numbers; NaN when there are under three, or one side
/// does not vary.
[[nodiscard]] double pearson_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

}  // namespace seamline::analysis
