#pragma once
#include <filesystem>

#include "analysis/matching/match_thresholds.h"
#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Draws `matches.svg` into the folder: a row a curve, a point the mean of each participant, and the mean
/// over participants with its 95 % interval.
[[nodiscard]] Figure draw_matches(const MatchAnalysis& analysis, const std::filesystem::path& folder);

}  // namespace seamline::analysis
