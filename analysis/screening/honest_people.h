#pragma once
#include <cstdint>

#include "analysis/scores/score_matrix.h"

namespace seamline::analysis {

/// A score screen is judged only where it would name fewer honest people than this.
inline constexpr double most_honest_named = 0.01;

/// How often the score screens would name people who look at the pictures of one study and answer as its
/// participants do; shares are of all those simulated.
struct HonestNaming {
  double kurtosis = 1, correlation = 1;  ///< shares, 0 to 1; 1 where nothing could be simulated
  int simulated = 0;                     ///< people; 0: fewer than three people or no answers
  double people_sd = 0;                  ///< fitted spread of people, of the log odds that they see
};

/// Simulates the study again and again with honest people only (parametric bootstrap), until `people` of them
/// have been screened. Each answers what a participant answered, as often. Their answers follow
///
///     P(right | stimulus i, person p) = g + (1 - g) / (1 + exp(-(l_i + u_p))),    u_p ~ Normal(0, s^2)
///
/// with the guess rate g of `scores` (1/3 for the paper's task) and, where right, the ratings that right
/// choices of that stimulus had. l_i makes the mean over people the share of right choices of the stimulus,
/// which is drawn towards that of its artifact and level, and this towards that of all stimuli, as far as
/// their differences are chance (empirical Bayes): otherwise the noise of few answers would look like
/// something that everybody sees. s has the largest likelihood when some people may have looked at nothing,
/// and then its upper end, 2 log likelihood under the largest. The same numbers for the same scores.
[[nodiscard]] HonestNaming simulate_honest_people(const ScoreMatrix& scores, int people = 5000,
                                                  std::uint64_t seed = 1);

}  // namespace seamline::analysis
