#pragma once
#include <filesystem>
#include <optional>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Mean noticeability as answered and corrected for guessing. None where there are no such numbers.
[[nodiscard]] std::optional<Figure> guessing_figure(const Analysis& analysis,
                                                    const std::filesystem::path& folder);

}  // namespace seamline::analysis
