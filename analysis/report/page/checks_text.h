#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What stands beside the thresholds, as tables for a terminal: isotonic, logistic and corrected for guessing
/// side by side with the range when each object is left out; what guessers do; thresholds with everybody and
/// without those whom a screen names.
[[nodiscard]] std::string checks_text(const Analysis& analysis);

/// What guessers do, in a sentence or two.
[[nodiscard]] std::string guessers_text(const GuessCorrection& correction);

/// What the screens say, in a sentence.
[[nodiscard]] std::string screening_sentence(const Screening& screening);

}  // namespace seamline::analysis
