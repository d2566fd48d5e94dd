#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/goodness.h"
#include "analysis/psychometric/likelihood/overdispersion.h"
#include "analysis/psychometric/likelihood/profile.h"

namespace seamline::analysis {

/// What the data say about the threshold.
struct Verdict {
  enum class Kind {
    identified,     ///< a number with a closed interval
    below,          ///< only an upper bound
    above,          ///< only a lower bound
    between,        ///< a step between two levels: all thresholds between them are as likely
    not_identified  ///< nothing
  } kind = Kind::not_identified;
  std::string text;      ///< e.g. "identified", "below 64 px", "between 32 and 64 px", "not identified: every
                         ///< level at chance"
  Interval range;        ///< what the text says: the interval, or its one end; open otherwise
  std::string why = {};  ///< of what is not identified, the reason alone; else empty
};

/// What is said of a threshold: verdict, estimate and interval, which never contradict one another. There is
/// an estimate, and it lies in the interval, exactly when the interval is closed; the verdict's range is the
/// interval; what is not identified has an interval that is open on both sides.
struct ThresholdFinding {
  Verdict verdict;
  std::optional<double> estimate;
  Interval ci95;
};

/// Judges a fit and the 95 % interval of its threshold. `unit` follows levels in the text; may be empty.
///
/// A change with level that a constant probability explains within 1.92 log units (a likelihood-ratio test at
/// 5 %) is no change: chance, ceiling, or flat; only the ceiling leaves a bound. An interval
/// that is open on a side is a bound. A closed one comes with a number; for a step between two levels the
/// number is the middle of thresholds that are all as likely, and the verdict says their range.
[[nodiscard]] ThresholdFinding judge_threshold(const PsychometricFit& fit, const Interval& threshold_ci95,
                                               const std::string& unit = "");

/// The verdict alone.
[[nodiscard]] Verdict verdict_on(const PsychometricFit& fit, const Interval& threshold_ci95,
                                 const std::string& unit = "");

/// The same as a sentence: "The threshold lies below 64 px."
[[nodiscard]] std::string verdict_sentence(const Verdict& verdict);

}  // namespace seamline::analysis
