#pragma once
#include <span>
#include <vector>

#include "analysis/statistics/estimate.h"
#include "analysis/statistics/interval.h"
#include "analysis/statistics/logistic4.h"

namespace seamline::analysis {

/// The intervals that replicates of one curve give, one for each thing read off it.
struct CurveIntervals {
  LevelInterval perceptual, slightly_noticeable, inflection;
  LevelInterval perceptual_logistic, slightly_noticeable_logistic;
};

/// What each bootstrap replicate of a curve of mean noticeability says about its thresholds. A replicate that
/// never crosses a level counts as infinite on its side, one that does not say where as the whole range it
/// leaves open; none is dropped.
class CurveReplicates {
 public:
  /// `level_x` is rising.
  CurveReplicates(const std::vector<double>& level_x, int replicates);

  /// Reads the thresholds off one replicate's means, one a width. May be called from several threads for
  /// different replicates.
  void set(int replicate, std::span<const double> means);

  /// Percentile intervals at `levels`.
  [[nodiscard]] CurveIntervals intervals(const TailLevels& levels) const;

 private:
  Logistic4Fitter fitter_;
  std::vector<LevelInterval> perceptual_, slightly_noticeable_, inflection_;
  std::vector<LevelInterval> perceptual_logistic_, slightly_noticeable_logistic_;
};

}  // namespace seamline::analysis
