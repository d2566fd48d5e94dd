#pragma once
#include <string>

namespace seamline::inline stimuli {

enum class LateTrials {
  used,     ///< marked, and analysed like all others; the report says what they change
  left_out  ///< marked, and no part of the analysis
};

/// What becomes of trials whose clip was not shown as it should be (`[analysis]` of a study with `[clip]`).
/// It shows people nothing, so it is no part of the study's hash.
struct LateFrames {
  double most_share = 0.05;  ///< a trial is marked where more of the frames that were due came late or never
  LateTrials trials = LateTrials::used;

  bool operator==(const LateFrames&) const = default;
};

/// What is promised, a sentence: for reports and preregistrations.
[[nodiscard]] std::string sentence_of(const LateFrames& rule);

}  // namespace seamline::inline stimuli
