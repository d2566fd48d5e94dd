#pragma once
#include <array>
#include <string_view>

#include "stimuli/definition/study_definition.h"
#include "stimuli/definition/views/look_definition.h"

namespace seamline::inline stimuli {

/// A study file says `projection = "panorama"`; the value is the field of view, all round.
inline constexpr double panorama_fov_deg = 360;
[[nodiscard]] bool is_panorama(const CameraDefinition& camera);
[[nodiscard]] bool is_panorama(const SceneDefinition& scene);
/// Whether the pictures of a study show all directions; then those of all its scenes do.
[[nodiscard]] bool is_panorama(const StudyDefinition& study);

/// How a condition's pictures are looked at; null: whole, as they are.
[[nodiscard]] const LookDefinition* look_of(const StudyDefinition& study,
                                            const ConditionDefinition& condition);
/// The same of the condition with this name; empty: the study's own.
[[nodiscard]] const LookDefinition* look_of(const StudyDefinition& study, std::string_view condition);

/// Whose question about comfort is asked at breaks: the study's, else the first condition's that has one;
/// null where none has.
[[nodiscard]] const LookDefinition* comfort_asked(const StudyDefinition& study);

/// Yaw and pitch in degrees at which a trial of the scene begins.
[[nodiscard]] std::array<double, 2> start_deg(const LookDefinition& look, const SceneDefinition& scene);
/// The same of the scene with this name, which the study has.
[[nodiscard]] std::array<double, 2> start_deg(const LookDefinition& look, const StudyDefinition& study,
                                              std::string_view scene);

}  // namespace seamline::inline stimuli
