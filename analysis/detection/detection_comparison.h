#pragma once
#include <optional>
#include <vector>

#include "analysis/detection/detection_pattern.h"
#include "analysis/detection/difference_measure.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::analysis {

/// A measure's answer to a pattern at several contrasts.
struct PatternResponse {
  std::vector<double> contrast_db;  ///< -20 log10 of the contrast, falling: ever more contrast
  std::vector<MeasuredDifference> measured;
};

/// FLIP and the root mean square difference of each pattern from the uniform field, at its people's threshold
/// and 6 and 12 dB beside it. The pictures are not rounded to codes. The same for any number of threads.
[[nodiscard]] std::vector<PatternResponse> pattern_responses(const DetectionThresholds& thresholds,
                                                             int threads = 0);

/// -20 log10 of the contrast at which a measure reaches `criterion`: straight lines through the logarithms,
/// continued beyond the ends.
[[nodiscard]] double threshold_db(const PatternResponse& response, DifferenceMeasure measure,
                                  double criterion);

/// One measure beside the people of one source.
struct MeasureFit {
  DifferenceMeasure measure = DifferenceMeasure::pooled_3;
  double criterion = 0;                ///< value at threshold: the mean error over patterns is 0
  double rms_error_db = 0;             ///< root mean square error over the patterns it was fitted to
  double rms_error_other_half_db = 0;  ///< criterion from every second pattern, judged on the others
  std::vector<double> predicted_db;    ///< a threshold for each pattern
};

[[nodiscard]] MeasureFit fit_measure(const DetectionThresholds& thresholds,
                                     const std::vector<PatternResponse>& responses,
                                     DifferenceMeasure measure);

/// The predicted thresholds at a criterion that comes from elsewhere, as they are.
[[nodiscard]] MeasureFit judge_measure(const DetectionThresholds& thresholds,
                                       const std::vector<PatternResponse>& responses,
                                       DifferenceMeasure measure, double criterion);

/// The visible difference (FLIP pooled with exponent 3) that ModelFest's 16 people saw in 68 of 100 trials,
/// as `fit_measure` finds it; a test computes it anew.
inline constexpr double detection_visible_difference = 0.0207;

/// The gain of an `image` observer who sees as many of ModelFest's patterns at threshold as its people did.
/// It depends on the observer's scale alone.
[[nodiscard]] double detection_gain(const ObserverDefinition& observer);

}  // namespace seamline::analysis
