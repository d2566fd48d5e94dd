#pragma once
#include "stimuli/definition/views/look_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 3> words_of<LookKind> = {"fixed", "mouse", "head"};

[[nodiscard]] std::string fault_of_yaw(const LookDefinition& look);
[[nodiscard]] std::string fault_of_pitch(const LookDefinition& look);

/// `[look]`. Whether `start_deg` and `horizontal_fov_deg` lie within the other angles is checked by
/// study_file_look.cpp.
template <>
inline constexpr auto settings_of<LookDefinition> = std::to_array<Setting<LookDefinition>>({
    {.key = "kind",
     .slot = choice<&LookDefinition::kind>(),
     .meaning = "One view that stays, one that people turn by mouse and arrow keys, or a headset (in "
                "browsers only).",
     .wording = {},
     .changes = Changes::presentation},
    {.key = "view_px",
     .slot = &LookDefinition::view_px,
     .range = {64, 4096, "px"},
     .meaning = "Size of the view on the screen.",
     .wording = {.before = " ", .after = " px", .between = " x "},
     .changes = Changes::presentation,
     .form = "width and height of the view, as [960, 540]"},
    {.key = "horizontal_fov_deg",
     .slot = &LookDefinition::horizontal_fov_deg,
     .range = {10, 140, "degrees"},
     .meaning = "Field of view.",
     .beside = {"kind", {"fixed", "mouse"}, "nothing: a headset has a field of its own"},
     .wording = {.before = " ", .after = " degrees"},
     .changes = Changes::presentation},
    {.key = "start_deg",
     .slot = &LookDefinition::start_deg,
     .range = {-180, 180, "degrees"},
     .meaning = "Where a trial begins: to the right of the camera's direction, up from the horizon.",
     .wording = {.before = " start ", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .form = "yaw and pitch, as [30, -5]",
     .usual = "the camera's"},
    {.key = "yaw_deg",
     .slot = &LookDefinition::yaw_deg,
     .range = {-180, 180, "degrees"},
     .meaning = "How far it can be turned.",
     .beside = {"kind", {"mouse"}},
     .wording = {.before = " yaw "},
     .changes = Changes::presentation,
     .fault = fault_of_yaw,
     .form = "the least and the largest angle"},
    {.key = "pitch_deg",
     .slot = &LookDefinition::pitch_deg,
     .range = {-90, 90, "degrees"},
     .meaning = "The same up and down.",
     .beside = {"kind", {"mouse"}},
     .wording = {.before = " pitch "},
     .changes = Changes::presentation,
     .fault = fault_of_pitch,
     .form = "the least and the largest angle"},
    {.key = "start_spread_deg",
     .slot = &LookDefinition::start_spread_deg,
     .range = {0, 180, "degrees"},
     .meaning = "Each trial begins at most so far to the left or right of `start_deg`, as drawn.",
     .beside = {"kind", {"mouse"}},
     .wording = {.before = " start within ", .written = Written::where_unusual},
     .changes = Changes::presentation},
    {.key = "fov_limits_deg",
     .slot = &LookDefinition::fov_limits_deg,
     .range = {10, 140, "degrees"},
     .meaning = "Between which + and - change the field, by 5 degrees; around `horizontal_fov_deg`.",
     .beside = {"kind", {"mouse"}},
     .wording = {.before = " field ", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .form = "the least and the largest field",
     .usual = "none"},
    {.key = "follows_device",
     .slot = &LookDefinition::follows_device,
     .meaning = "A telephone or tablet that is turned turns the view, in pages.",
     .beside = {"kind", {"mouse"}},
     .wording = {.written = Written::where_unusual, .yes = " follows device"},
     .changes = Changes::presentation},
    {.key = "hint",
     .slot = &LookDefinition::hint,
     .meaning = "Below the question. Not part of the hash.",
     .beside = {"kind", {"mouse", "head"}},
     .changes = Changes::presentation,
     .usual = "Drag, or press arrow keys ..."},
    {.key = "comfort_question",
     .slot = &LookDefinition::comfort_question,
     .meaning = "Asked at every break. Not part of the hash.",
     .changes = Changes::presentation,
     .usual = "none"},
    {.key = "comfort_labels",
     .slot = Described{"five texts"},
     .meaning = "Its answers.",
     .changes = Changes::presentation,
     .usual = "Not at all ... Very strongly"},
});
static_assert(are_sound<LookDefinition>(settings_of<LookDefinition>));

}  // namespace seamline::inline stimuli
