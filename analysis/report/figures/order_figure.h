#pragma once
#include <filesystem>
#include <optional>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Mean noticeability by tenths of the session, what was shown and who was asked being equal. None where
/// order is not looked at.
[[nodiscard]] std::optional<Figure> order_figure(const Analysis& analysis, const ReportNumbers& numbers,
                                                 const std::filesystem::path& folder);

}  // namespace seamline::analysis
