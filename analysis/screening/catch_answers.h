#pragma once
#include <vector>

#include "analysis/scores/guess_trials.h"
#include "analysis/screening/screening.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// The answers of a log to reference trials, for the correction for guessing.
[[nodiscard]] std::vector<ReferenceAnswer> reference_answers(const study::LogContents& log);

/// The answers of a log to attention trials, for screening.
[[nodiscard]] std::vector<CatchAnswer> attention_answers(const study::LogContents& log);

}  // namespace seamline::analysis
