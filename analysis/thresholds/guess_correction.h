#pragma once
#include <string>
#include <vector>

#include "analysis/scores/guess_trials.h"
#include "analysis/statistics/resampling.h"
#include "analysis/thresholds/guess_model.h"
#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

/// The curve of one artifact corrected for guessing, and its thresholds.
struct CorrectedCurve {
  Artifact artifact = Artifact::none;
  std::string condition;
  std::vector<double> level;      ///< as on the curve: widths rise
  std::vector<SeeingCell> cells;  ///< one a level
  /// PT, SN and IP of the corrected curve. PT and SN have score-test intervals on formula scores
  /// (documentation/explanation/guess_correction.md), what is read off the logistic the expanded percentile
  /// bootstrap over people, the whole model being fitted again to each replicate.
  CurveThresholds estimates;
  /// Expanded percentile bootstrap intervals of PT and SN, for comparison.
  LevelInterval perceptual_bootstrap, slightly_noticeable_bootstrap;
  /// Whether people chose right more often than guessers would (t test over people, one-sided, 1 %). When
  /// not, chance is not excluded; nothing more: a test of few people seldom rejects.
  bool above_chance = false;
  int people = 0;              ///< with an answer on the curve
  double right_share = 0;      ///< of their answers, each person weighing the same
  double right_by_chance = 0;  ///< what b says of guessers for the same answers
};

/// Noticeability with the answers of those who guessed taken out.
struct GuessCorrection {
  Guessers guessers;
  double floor =
      0;  ///< uncorrected mean noticeability of people who see nothing: mean of b(o) times mean of g
  std::vector<CorrectedCurve> curves;  ///< in the order of the data's artifacts
  std::vector<std::string> notes;      ///< what a reader must know, a sentence each
};

/// Fits the latent-class model (saw it / guessed). `trials` come from `count_guess_trials` of the same
/// `data`.
[[nodiscard]] GuessCorrection correct_for_guessing(const GuessTrials& trials, const NoticeabilityData& data,
                                                   const ResamplingRequest& request);

}  // namespace seamline::analysis
