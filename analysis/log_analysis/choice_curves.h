#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/psychometric/intervals/goodness.h"
#include "analysis/psychometric/intervals/pooled_fit.h"

namespace seamline::analysis {

/// The fitted share of right choices at a level, with a pointwise 95 % band.
struct BandPoint {
  double level = 0;
  double fitted = 0;         ///< 0 to 1
  double low = 0, high = 0;  ///< 0 to 1
};

/// The psychometric function of one artifact and condition: right choices against the level, everybody's
/// answers together.
struct ChoiceCurve {
  Artifact artifact = Artifact::none;
  std::string condition;            ///< empty where the study has one
  std::optional<UnitCounts> apart;  ///< answers at a level that stands apart; its t means nothing
  std::string missing;              ///< a sentence: why there is no fit; everything below is empty then
  int people = 0;                   ///< with an answer to the artifact
  std::optional<PooledFit> pooled;  ///< threshold interval over participants, verdict
  /// 95 % percentile intervals over the same replicates of participants as the band; open without a
  /// threshold. Width along the axis between F = 0.05 and 0.95, lapse 0 to 1.
  Interval width_ci95, lapse_ci95;
  Goodness goodness;            ///< residuals a level
  double deviance_p = 0;        ///< as if answers were independent; NaN: not tested
  std::vector<BandPoint> band;  ///< levels rising, evenly spaced along the axis, the tested range
  int band_replicates = 0;
  std::vector<std::string> warnings;  ///< what a reader of the fit must know, a sentence each
};

/// Whether the data say where the function is, so that its width and lapse rate may be printed as numbers.
[[nodiscard]] bool has_threshold(const ChoiceCurve& curve);

/// At most this many replicates of participants make a band: percentiles of a drawing need no more.
inline constexpr int most_band_replicates = 1000;
inline constexpr int deviance_replicates = 1000;

/// Fits every artifact and condition of `analysis`, in its order: cumulative normal along the axis, guess
/// rate the task's (ScoreMatrix::guess_rate), lapse free to 0.1, in the direction of the log. A level that
/// stands apart is no part of the sigmoid. Bands are percentiles over participants drawn with replacement,
/// each replicate fitted again. Same numbers for any number of threads. Adaptive logs have no curves; each
/// says so in `missing`.
[[nodiscard]] std::vector<ChoiceCurve> choice_curves(const Analysis& analysis);

}  // namespace seamline::analysis
