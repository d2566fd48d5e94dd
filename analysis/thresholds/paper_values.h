#pragma once
#include <array>
#include <optional>

#include "stimuli/definition/artifact.h"

namespace seamline::analysis {

/// One column of Table 1 of "Visual Perception of Real World Depth Map Resolution for Mixed Reality
/// Rendering": widths in px, none where the paper has a dash.
struct PaperThresholds {
  Artifact artifact = Artifact::none;
  int type = 0;
  std::optional<int> perceptual_px, slightly_noticeable_px, inflection_px;
};

inline constexpr std::array<PaperThresholds, 4> paper_table_1 = {{
    {Artifact::receiver, 1, 426, 116, 250},
    {Artifact::shadow, 2, 206, std::nullopt, 228},
    {Artifact::occlusion, 3, std::nullopt, 1126, 354},
    {Artifact::overlap, 4, std::nullopt, 1596, 336},
}};

/// The paper's column for an artifact; none for artifacts that it did not study.
[[nodiscard]] constexpr std::optional<PaperThresholds> paper_thresholds(Artifact artifact) {
  for (const PaperThresholds& column : paper_table_1)
    if (column.artifact == artifact) return column;
  return std::nullopt;
}

}  // namespace seamline::analysis
