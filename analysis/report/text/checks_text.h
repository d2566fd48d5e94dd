#pragma once
#include <string>
#include <vector>

#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {

/// What stands beside the thresholds, as tables for a terminal: isotonic, logistic and corrected for guessing
/// side by side with the range when each object is left out; what guessers do; thresholds with everybody and
/// without those whom a screen names.
[[nodiscard]] std::string checks_text(const Analysis& analysis);

/// What guessers do, in a sentence or two.
[[nodiscard]] std::string guessers_text(const GuessCorrection& correction);

/// What the screens say, in a sentence.
[[nodiscard]] std::string screening_sentence(const Screening& screening);

/// What is printed of a threshold otherwise estimated: artifact (with PT only, the first of its three lines),
/// quantity, isotonic, logistic, corrected for guessing, range when each object is left out. Cells are empty
/// where there is nothing. Terminal and page are written from it.
[[nodiscard]] std::vector<std::string> otherwise_estimated_cells(const ThresholdRow& row);

/// With and without those whom a screen names: who (on the first line of each), artifact, PT, SN, IP.
[[nodiscard]] std::vector<std::vector<std::string>> screened_lines(const Analysis& analysis);

/// "everybody (20)", "without those named by correlation (2 left out: a, b)".
[[nodiscard]] std::string who_text(const ScreenedThresholds& result, const Analysis& analysis);

/// "a = 0.653 (0.512 to 0.794) over 84 stimuli"; fewer than three people have no interval.
[[nodiscard]] std::string sos_text(const SosParameter& sos);

}  // namespace seamline::analysis
