#pragma once
#include <optional>
#include <string>

#include "analysis/scores/level_axis.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::analysis {

/// The level that the average `threshold` observer sees half of the time; none where nothing is planted.
[[nodiscard]] std::optional<double> planted_midpoint(const ObserverDefinition& observer, Artifact artifact,
                                                     const std::string& condition);

/// Mean noticeability of `threshold` observers with that midpoint at a level that does not stand apart.
[[nodiscard]] double planted_noticeability(const ObserverDefinition& observer, const LevelAxis& axis,
                                           double midpoint, double level);

}  // namespace seamline::analysis
