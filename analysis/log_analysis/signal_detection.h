#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/psychometric/likelihood/profile.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

/// How well people tell a seam from its reference at a level, whatever their criterion (Green and Swets
/// 1966):
///
///     d' = z(H) - z(F),    c = -(z(H) + z(F)) / 2
///
/// with hits H = (h + 1/2) / (n + 1) of n answers at the level and false alarms F = (f + 1/2) / (m + 1) of m
/// reference trials of each participant (Hautus 1995), z the normal quantile. d' and c are means over
/// participants.
struct DetectionRow {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  double level = 0;
  int people = 0;      ///< with an answer at the level and a reference trial
  double hits = 0;     ///< mean share of yes, 0 to 1, uncorrected
  double d_prime = 0;  ///< mean; so are the others
  double criterion = 0;
  Interval d_prime_ci95 = {}, criterion_ci95 = {};  ///< Student's, over participants; NaN for one
};

/// A mean over participants, each of whom counts alike, with Student's interval; NaN for one.
struct MeanOverPeople {
  double mean = nan;
  Interval ci95{.low = nan, .high = nan};
};
[[nodiscard]] MeanOverPeople mean_of_observers(const std::vector<double>& values);

struct SignalDetection {
  double false_alarms = 0;  ///< mean share of yes to reference trials
  int reference_answers = 0;
  std::vector<DetectionRow> rows;  ///< artifacts and levels in the order of the data
};

/// Of a task that asks for yes or no; of others no rows.
[[nodiscard]] SignalDetection signal_detection(const Analysis& analysis);

}  // namespace seamline::analysis
