#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Whether no seam is seen at a level, a sentence a curve: two one-sided t tests over participants, 5 % each
/// (Schuirmann 1987), that mean noticeability, corrected for guessing by formula scores, lies within `margin`
/// of 0. A wrong answer takes away what a lucky guess would have added, chance / (1 - chance) times the mean
/// rating of wrong answers. The same as `plan --no-seam-at` has the power of. Throws InputError where nobody
/// was shown that level, or levels were placed by the answers.
[[nodiscard]] std::vector<std::string> no_seam_sentences(const Analysis& analysis, double level,
                                                         double margin);

}  // namespace seamline::analysis
