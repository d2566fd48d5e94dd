#pragma once
#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Whether widths were placed by the answers (`procedure = "quest_plus"`). A study that is not known counts
/// as one of constant stimuli.
[[nodiscard]] bool is_adaptive(const std::optional<StudyDefinition>& study);

/// Adaptive placement asks each person at widths that depend on their answers, and how often too: a mean at a
/// width is then over people who differ from those of the next width, and is biased. No curve is made of such
/// means: the thresholds are none, with a reason.
void set_aside_adaptive(Analysis& analysis);

/// What the reader of such an analysis is told.
inline constexpr const char* adaptive_note =
    "Widths were placed by the answers (QUEST+), so PT, SN and IP of mean noticeability cannot be computed; "
    "means of objects are over different people at different widths and only describe the answers. "
    "'seamline log LOG --tracks' prints the thresholds that the posteriors give.";

}  // namespace seamline::analysis
