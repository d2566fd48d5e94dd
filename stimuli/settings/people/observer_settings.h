#pragma once
#include "stimuli/definition/axis.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

inline constexpr std::array<std::string_view, 2> words_of_noticeability = {
    noticeability_word(Direction::decreasing), noticeability_word(Direction::increasing)};

[[nodiscard]] std::string midpoints_text(const ObserverDefinition& observer);
[[nodiscard]] bool has_no_midpoints(const ObserverDefinition& observer);

/// `[level]`.
template <>
inline constexpr auto settings_of<LevelDefinition> = std::to_array<Setting<LevelDefinition>>({
    {.key = "quantity",
     .slot = Described{"text"},
     .meaning = "What varies. It is set nowhere else.",
     .of_condition = false,
     .is_read_apart = true,
     .form = "a key of the next table",
     .usual = "required"},
    {.key = "values",
     .slot = Described{"list of numbers"},
     .meaning = "The levels, each once. They become part of stimulus ids, so they must differ in the id's "
                "decimals.",
     .of_condition = false,
     .is_read_apart = true,
     .form = "see next table",
     .usual = "required"},
    {.key = "noticeability",
     .slot = one_of<&LevelDefinition::noticeability, Direction::decreasing, Direction::increasing>(
         words_of_noticeability),
     .meaning = "Whether noticeability falls or rises as the level grows.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "the quantity's"},
});

/// `[observer]`. Midpoints are read by study_file.cpp.
template <>
inline constexpr auto settings_of<ObserverDefinition> = std::to_array<Setting<ObserverDefinition>>({
    {.key = "scale_octaves",
     .slot = &ObserverDefinition::scale_octaves,
     .range = {1e-6, 100, "octaves"},
     .meaning = "How gradually seeing fades.",
     .wording = {.before = "observer "},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "people_sd_octaves",
     .slot = &ObserverDefinition::people_sd_octaves,
     .range = {0, 100, "octaves"},
     .meaning = "Standard deviation of `shift`.",
     .wording = {.before = " ", .after = "\n"},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "midpoint_width_px",
     .slot = Described{"table"},
     .range = {1e-3, 1e9, "px"},
     .meaning = "Midpoints of `receiver`, `shadow`, `occlusion`, `overlap`, `bounce`, `all` and `none`.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "300, 180, 620, 900, 150, 900, 1"},
    {.key = "midpoint",
     .slot = Part<ObserverDefinition>{midpoints_text, has_no_midpoints},
     .meaning = "The same where the level is no width. Mesh tolerances and later quantities have no "
                "defaults.",
     .wording = {},
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = "in the level's unit"},
    {.key = "condition_midpoint",
     .slot = Described{"tables"},
     .meaning = "`[observer.condition_midpoint.NAME]`: midpoints of one condition.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "the study's"},
    {.key = "scale_deg",
     .slot = Described{"number"},
     .range = {1e-9, 1e9},
     .meaning = "`scale` on a linear axis, with the level's unit behind it.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "a twelfth of the range of levels"},
    {.key = "people_sd_deg",
     .slot = Described{"number"},
     .range = {0, 1e9},
     .meaning = "`people_sd` on a linear axis, likewise.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "a twelfth of the range of levels"},
    {.key = "image_gain",
     .slot = &ObserverDefinition::image_gain,
     .range = {1e-9, 1e9},
     .meaning = "Gain of the observer `image`.",
     .wording = {.before = "image gain ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "noticeability",
     .slot = one_of<&ObserverDefinition::direction, Direction::decreasing, Direction::increasing>(
         words_of_noticeability),
     .meaning = "Direction of the observer `threshold`.",
     .wording = {.before = "noticeability ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "the level's"},
    {.key = "pixels_per_degree",
     .slot = &ObserverDefinition::pixels_per_degree,
     .range = {1, 1000, "pixels per degree"},
     .meaning = "How large the pictures are seen.",
     .wording = {.before = "pixels per degree ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .of_condition = false},
});
static_assert(are_sound<ObserverDefinition>(settings_of<ObserverDefinition>));

}  // namespace seamline::inline stimuli
