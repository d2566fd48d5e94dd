#pragma once
#include <Eigen/Core>
#include <vector>

namespace seamline::analysis {

/// The mean opinion score of one stimulus.
struct OpinionScore {
  int n = 0;            ///< people with a score
  double mean = 0;      ///< MOS; NaN without scores
  double sd = 0;        ///< over people, with n - 1; NaN under two scores
  double ci95_low = 0;  ///< mean -+ t(n - 1, 0.975) sd / sqrt(n); NaN under two scores
  double ci95_high = 0;
};

/// One a stimulus. `score` is people x stimuli, NaN where there is no score.
[[nodiscard]] std::vector<OpinionScore> opinion_scores(const Eigen::MatrixXd& score);

/// Ends of a rating scale.
struct RatingScale {
  double lowest = 0, highest = 4;  ///< noticeability
};

/// How much people differ over all stimuli, in one number: the SOS parameter a of Hossfeld, Schatz and Egger
/// (2011, SOS: the MOS is not enough!). The variance of scores on a bounded scale L..H is
///
///     S(x)^2 = a (x - L) (H - x)
///
/// at the mean score x, a = 0 when all agree and 1 when all choose an end; fitted by least squares over
/// stimuli.
struct SosParameter {
  double a = 0;         ///< NaN when no stimulus has a mean within the scale
  double ci95_low = 0;  ///< delete-one jackknife over people with Student's t; NaN under three people
  double ci95_high = 0;
  int stimuli = 0;  ///< with at least two scores
};

[[nodiscard]] SosParameter sos_parameter(const Eigen::MatrixXd& score, const RatingScale& scale);

}  // namespace seamline::analysis
