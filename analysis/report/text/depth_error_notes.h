#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Thresholds of a share of estimated depth in the words of depth estimation, a sentence for each curve that
/// has one: what AbsRel, RMSE and delta 1 the set's depth has there. Nothing of other levels, or where the
/// set is not there any more.
[[nodiscard]] std::vector<std::string> thresholds_as_depth_errors(const Analysis& analysis);

}  // namespace seamline::analysis
