#pragma once
#include <filesystem>
#include <optional>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Median time to the choice against width, right and wrong choices apart, with quartiles. None where there
/// are no such numbers.
[[nodiscard]] std::optional<Figure> times_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                                 const std::filesystem::path& folder);

}  // namespace seamline::analysis
