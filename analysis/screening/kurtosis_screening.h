#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline::analysis {

/// How often a participant's scores were extreme among everybody's, and what ITU-R BT.500 concludes.
struct KurtosisCount {
  int above = 0;    ///< P: scores at or above the mean by the limit
  int below = 0;    ///< Q: scores at or below it by the limit
  int stimuli = 0;  ///< N: scored by this participant
  bool rejected = false;
};

/// The screening of ITU-R BT.500 (Annex on the screening of observers). For each stimulus, over people: mean
/// u, standard deviation S with n - 1, kurtosis beta2 = m4 / m2^2 with n. A score is extreme when it is at
/// least 2 S (2 <= beta2 <= 4, near normal) or sqrt(20) S (else) from u. A participant is rejected when
///
///     (P + Q) / N > 0.05   and   |P - Q| / (P + Q) < 0.3
///
/// that is, when often extreme, and on both sides: somebody who always rates high is not rejected. Stimuli on
/// which all agree (S = 0) make nobody extreme, and P + Q = 0 never rejects; without these two everybody is
/// extreme where everybody agrees. `score` is people x stimuli, NaN where there is no score. One entry a
/// person.
[[nodiscard]] std::vector<KurtosisCount> screen_by_kurtosis(const Eigen::MatrixXd& score);

}  // namespace seamline::analysis
