#pragma once
#include <filesystem>
#include <optional>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Mean noticeability as answered (points with standard errors) and by the joint model (line with 95 % band),
/// as counted and of what is seen. None where the model has no numbers.
[[nodiscard]] std::optional<Figure> joint_curves_figure(const Analysis& analysis,
                                                        const std::filesystem::path& folder);

/// Shares of every score at every level, observed (points) and expected by the joint model (lines).
[[nodiscard]] std::optional<Figure> joint_scores_figure(const Analysis& analysis,
                                                        const std::filesystem::path& folder);

}  // namespace seamline::analysis
