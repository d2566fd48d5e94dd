#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/joint/joint_people.h"

namespace seamline::analysis {

/// How often one score was given at one level of a curve, and how often the model expects it.
struct ScoreCell {
  int curve = 0;
  double x = 0;   ///< infinite: nothing to see
  int score = 0;  ///< 0: the wrong object was chosen; 1..K: right with this rating
  double observed = 0, expected = 0;
};

struct JointGoodness {
  std::vector<ScoreCell> cells;
  /// Likelihood-ratio statistics against a model with a share of its own for every cell: of right and wrong;
  /// and of the ratings of right answers given that they are right.
  double choices_g2 = 0, ratings_g2 = 0;
  /// Parametric bootstrap: share of data sets, simulated from people who differ as `JointPeople` says, that
  /// lie as far from their own fit. Small values say that the model does not describe the answers.
  double choices_p = 1, ratings_p = 1;
  int replicates = 0;  ///< 0: no p
};

struct JointGoodnessRequest {
  int replicates = 299;
  std::uint64_t seed = 1;
  int threads = 0;
};

/// `fit` has numbers. The same bits for any number of threads. Answers that count for less or more than 1
/// (unbalanced objects) are rounded a cell and person.
[[nodiscard]] JointGoodness joint_goodness(const JointFit& fit, const JointData& data,
                                           const JointPeople& people, const JointGoodnessRequest& request);

}  // namespace seamline::analysis
