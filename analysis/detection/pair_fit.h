#pragma once
#include <vector>

#include "analysis/detection/seen_pairs.h"

namespace seamline::analysis {

/// The `image` observer's last step with any measure D of the difference:
///
///     P(right) = chance + (1 - chance) / (1 + exp(-log2(gain D) / scale))
struct SeenModel {
  DifferenceMeasure measure = DifferenceMeasure::pooled_3;
  double gain = 1, scale_octaves = 1;
};

/// Of a pair whose measures are known; where nothing differs, its chance.
[[nodiscard]] double right_probability(const SeenModel& model, const MeasuredDifference& measured,
                                       double chance);

/// Pairs predicted alike: what was predicted of them on average, and what was seen.
struct CalibrationGroup {
  double predicted = 0, seen = 0;  ///< shares
  int looks = 0;
};

/// A model fitted to the first half and judged on the second.
struct JudgedModel {
  SeenModel model;
  double fitted_bits = 0;  ///< mean log2 likelihood of a look in the first half, 0 at best
  double judged_bits = 0;  ///< the same in the second half
  double roc_area = 0;     ///< second half: that a look that saw had the larger measure than one that did not
  std::vector<CalibrationGroup> calibration;  ///< second half, by rising prediction, at most five
};

struct PairJudgement {
  int references = 0;               ///< different ones
  bool split_by_reference = false;  ///< no reference is in both halves
  int fitted_pairs = 0, judged_pairs = 0;
  double constant_bits = 0;  ///< second half, of one who predicts the first half's share seen everywhere
  JudgedModel observer;      ///< FLIP pooled with the exponent that fits the first half best
  std::vector<JudgedModel> others;  ///< exponent 3, mean FLIP, its largest value, root mean square
};

/// Gain and scale by maximum likelihood: gain within 2^-40 to 2^40, scale within 1/32 to 32 octaves.
[[nodiscard]] SeenModel fit_seen_model(DifferenceMeasure measure, const std::vector<SeenPair>& pairs,
                                       const std::vector<MeasuredDifference>& measured);

/// Halves: every second reference in the order of the table, with all its pairs, where there are four or
/// more; else every second pair. Throws InputError when a half saw everything or nothing.
[[nodiscard]] PairJudgement judge_pairs(const std::vector<SeenPair>& pairs,
                                        const std::vector<MeasuredDifference>& measured);

}  // namespace seamline::analysis
