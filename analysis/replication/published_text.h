#pragma once
#include <string>
#include <vector>

#include "analysis/replication/published_thresholds.h"

namespace seamline::analysis {

/// Published thresholds and the margin as one rule of an analysis: "laid beside published thresholds:
/// receiver PT 426, shadow PT 206 (150 to 290); agreeing within 0.5 (octaves, or the unit of the level)". The
/// same values give the same rule whatever their file is called.
[[nodiscard]] std::string rule_of_published(const std::vector<PublishedThreshold>& published, double margin);

}  // namespace seamline::analysis
