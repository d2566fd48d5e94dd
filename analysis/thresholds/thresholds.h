#pragma once
#include <vector>

#include "analysis/scores/cells.h"
#include "analysis/statistics/estimate.h"
#include "analysis/statistics/interval.h"
#include "analysis/statistics/logistic4.h"
#include "analysis/statistics/resampling.h"

namespace seamline::analysis {

inline constexpr double perceptual_level =
    0.5;  ///< PT: halfway between not noticeable (0) and slightly noticeable (1)
inline constexpr double slight_level = 1.0;  ///< SN: "slightly noticeable"

/// What a curve of mean noticeability says: estimates only, from people or from an observer's expected means.
struct CurveThresholds {
  ThresholdEstimate perceptual;                    ///< PT
  ThresholdEstimate slightly_noticeable;           ///< SN
  ThresholdEstimate inflection;                    ///< IP
  ThresholdEstimate perceptual_logistic;           ///< PT read off the logistic instead of the isotonic fit
  ThresholdEstimate slightly_noticeable_logistic;  ///< SN read off the logistic
  IsotonicFit isotonic;
  Logistic4Fit logistic;
};

/// Applies the rule of closed_estimates.h to all that is read off a curve whose intervals are known.
void keep_closed(CurveThresholds& found, const std::vector<double>& level_x, const LevelAxis& axis);

/// PT, SN and IP of one artifact with intervals over participants.
struct ArtifactThresholds {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  int participants = 0;   ///< on the curve
  int fewest = 0;         ///< of them at the level where the fewest answered; degrees of freedom are of these
  CurveThresholds estimates;
  /// Expanded percentile bootstrap intervals of PT and SN, for comparison: they cover less often
  /// (documentation/evidence/coverage.md).
  LevelInterval perceptual_bootstrap, slightly_noticeable_bootstrap;
  LevelInterval perceptual_logistic_bootstrap, slightly_noticeable_logistic_bootstrap;
};

/// The functionals PT, SN and IP of means at levels (x of LevelAxis, rising); intervals are left open. `axis`
/// is for the words of reasons.
[[nodiscard]] CurveThresholds thresholds_of_means(const std::vector<double>& level_x,
                                                  const std::vector<double>& means,
                                                  const LevelAxis& axis = {});

/// The same from people's scores, with 95 % intervals: PT and SN by inverting a score test (`level_interval`,
/// `logistic_level_interval`), IP by the expanded percentile bootstrap over people. A replicate without a
/// width counts as infinite, or as the whole range when it does not say on which side; none is dropped. With
/// fewer than two people at a level every interval is open, and so are those off the logistic under four
/// widths. There is an estimate exactly where its interval is closed (`keep_closed`).
[[nodiscard]] ArtifactThresholds estimate_thresholds(const ArtifactScores& scores,
                                                     const ResamplingRequest& request);

/// log2 of the tested widths.
[[nodiscard]] std::vector<double> log2_widths(const std::vector<int>& width_px);

}  // namespace seamline::analysis
