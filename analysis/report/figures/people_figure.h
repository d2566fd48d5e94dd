#pragma once
#include <filesystem>
#include <optional>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Mean noticeability of every participant, a thin line each, under the mean over participants; a panel a
/// curve. None of adaptive logs, and of one participant.
[[nodiscard]] std::optional<Figure> people_figure(const Analysis& analysis,
                                                  const std::filesystem::path& folder);

}  // namespace seamline::analysis
