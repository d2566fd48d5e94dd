#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// One artifact in a condition whose clips move, and in one whose clips are stills.
struct ClipAgainstStill {
  std::string artifact, clip, still;  ///< the last two are conditions
  ContrastRow difference;             ///< of thresholds by the joint model, clip less still
};

/// The joint model's contrasts between conditions that compare a clip with a still: a condition is a still
/// where all frames of each of its clips are one picture. Empty where the study has no such condition, or the
/// model has no numbers.
[[nodiscard]] std::vector<ClipAgainstStill> clips_against_stills(const Analysis& analysis);

/// A sentence each.
[[nodiscard]] std::vector<std::string> sentences_of(const Analysis& analysis,
                                                    const std::vector<ClipAgainstStill>& compared);

/// The table `clip_against_still`, a row each.
[[nodiscard]] CsvTable still_table(const Analysis& analysis, const std::vector<ClipAgainstStill>& compared);

}  // namespace seamline::analysis
