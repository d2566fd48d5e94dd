#pragma once
#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Whether widths were placed by the answers (`procedure = "quest_plus"` or `"staircase"`). A study that is
/// not known counts as one of constant stimuli.
[[nodiscard]] bool is_adaptive(const std::optional<StudyDefinition>& study);

/// Adaptive placement asks each person at widths that depend on their answers, and how often too: a mean at a
/// width is then over people who differ from those of the next width, and is biased. No curve is made of such
/// means: the thresholds are none, with a reason.
void set_aside_adaptive(Analysis& analysis);

/// The thresholds of the group: the joint model with each person's own thresholds (joint_placed.h), fitted to
/// every answer of the people used. Curves and labels as `data`; no contrasts, checks of the fit or people of
/// its own.
[[nodiscard]] JointAnalysis analyze_placed(const Analysis& analysis, const JointRequest& request);

/// What the reader of such an analysis is told.
[[nodiscard]] std::string adaptive_note(const study::LogContents& log);

}  // namespace seamline::analysis
