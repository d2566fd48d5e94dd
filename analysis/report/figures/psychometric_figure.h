#pragma once
#include <filesystem>
#include <optional>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Right choices against width: points by trials, fitted curve with its band, residuals below. None where
/// there are no such numbers.
[[nodiscard]] std::optional<Figure> psychometric_figure(const Analysis& analysis,
                                                        const ReportNumbers& numbers,
                                                        const std::filesystem::path& folder);

}  // namespace seamline::analysis
