#pragma once
#include "stimuli/definition/parts/staircase_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 6> words_of<TaskKind> = {"object", "pair",   "interval",
                                                                       "yes_no", "rating", "match"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<TaskMask> = {"none", "noise", "scrambled"};
inline constexpr std::array<std::string_view, 2> words_of_scales = {"labels", "slider"};
inline constexpr std::array<std::string_view, 2> words_of_blocks = {"", "condition"};
inline constexpr std::array<std::string_view, 2> words_of_asks = {"which", "same"};

[[nodiscard]] std::string fault_of_objects(const TaskDefinition& task);
[[nodiscard]] std::string fault_of_exposure(const TaskDefinition& task);
[[nodiscard]] std::string fault_of_mask(const TaskDefinition& task);
[[nodiscard]] std::string fault_of_mask_time(const TaskDefinition& task);

/// `[task]`. What `kind` changes of the defaults is set by study_file_task.cpp.
template <>
inline constexpr auto settings_of<TaskDefinition> = std::to_array<Setting<TaskDefinition>>({
    {.key = "kind",
     .slot = choice<&TaskDefinition::kind>(),
     .meaning = "Which of the objects; which of two pictures side by side; which of the pictures one after "
                "another; whether anything was inserted; a label; [where the seam is just "
                "seen](../how-to/match_the_level.md).",
     .wording = {.before = "task "},
     .changes = Changes::presentation,
     .required = "one of these words"},
    {.key = "exposure_s",
     .slot = &TaskDefinition::exposure_s,
     .range = {0, 600, "s"},
     .meaning = "How long a picture is seen. 0: until the answer. At least 0.05 of `interval`.",
     .beside = {"kind",
                {"pair", "interval", "yes_no", "rating"},
                R"(kind = "pair", "interval", "yes_no" or "rating" where it is set)"},
     .wording = {.before = " exposure "},
     .changes = Changes::presentation,
     .fault = fault_of_exposure,
     .usual = "0; 0.5 of `interval`"},
    {.key = "second_question",
     .slot = &TaskDefinition::second_question,
     .meaning = "Whether the choice is followed by a rating.",
     .beside = {"kind",
                {"object", "pair", "interval"},
                R"(kind = "object", "pair" or "interval" where it is set)"},
     .wording = {.before = " second question ", .yes = "yes", .no = "no"},
     .changes = Changes::presentation,
     .usual = "`true` of `object`, else `false`"},
    {.key = "repetitions",
     .slot = &TaskDefinition::repetitions,
     .range = {1, 1000, "repetitions"},
     .meaning = "How often each stimulus is shown to a participant, each time in an order of its own; of "
                "`match` how often each object is matched in each condition.",
     .wording = {.before = " repetitions ", .after = "\n"},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "objects",
     .slot = &TaskDefinition::objects,
     .range = {1, most_objects_of_scene, "objects"},
     .meaning = "Objects of each scene, in the order in which they stand in the picture from left to right. "
                "At least 2 of `object`.",
     .wording = {.before = "task objects ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .fault = fault_of_objects},
    {.key = "pictures",
     .slot = &TaskDefinition::pictures,
     .range = {2, 3, "pictures"},
     .meaning = "Pictures of a trial.",
     .beside = {"kind", {"interval"}, R"(kind = "interval" where it is set)"},
     .wording = {.before = "task pictures ", .written = Written::where_used},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "gap_s",
     .slot = &TaskDefinition::gap_s,
     .range = {0.05, 60, "s"},
     .meaning = "Grey between two pictures.",
     .beside = {"kind", {"interval"}, R"(kind = "interval" where it is set)"},
     .wording = {.before = " gap ", .after = "\n", .written = Written::where_used},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "mask",
     .slot = choice<&TaskDefinition::mask>(),
     .meaning =
         "What covers a picture's place once its exposure ends, the last one's too: `noise` is squares "
         "of 4 pixels in random grey, `scrambled` squares of 16 pixels of the reference in a random "
         "order. Drawn by the study's seed, one a scene.",
     .beside = {"kind",
                {"pair", "interval", "yes_no", "rating"},
                R"(kind = "pair", "interval", "yes_no" or "rating" where it is set)"},
     .wording = {.before = "task mask ", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .of_condition = false,
     .fault = fault_of_mask},
    {.key = "mask_s",
     .slot = &TaskDefinition::mask_s,
     .range = {0.01, 10, "s"},
     .meaning =
         "How long the mask is seen, in whole frames. Of `interval` it takes the beginning of `gap_s`.",
     .beside = {"mask", {"noise", "scrambled"}, R"(mask = "noise" or "scrambled" where it is set)"},
     .wording = {.before = " for ", .after = " s\n", .written = Written::where_used},
     .changes = Changes::presentation,
     .of_condition = false,
     .fault = fault_of_mask_time},
    {.key = "scale",
     .slot = one_of<&TaskDefinition::slider, false, true>(words_of_scales),
     .meaning = "Five labels, or a line with a place from 0 to 100 on it. Its fifths count as the five "
                "labels; the number stands in the exported tables and in `slider.csv` of the report.",
     .beside = {"kind", {"rating"}, R"(kind = "rating" where it is set)"},
     .wording = {.before = "task scale ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "asks",
     .slot = one_of<&TaskDefinition::same, false, true>(words_of_asks),
     .meaning = "Which of the two holds the insertion; or whether the right picture is the same as its "
                "reference on the left. `\"same\"` is a yes/no task: it needs `catch.reference` and has no "
                "second question.",
     .beside = {"kind", {"pair"}, R"(kind = "pair" where it is set)"},
     .wording = {.before = "task ", .after = " or different\n", .written = Written::where_unusual},
     .changes = Changes::presentation},
    {.key = "answers",
     .slot = &TaskDefinition::answers,
     .meaning = "What the alternatives are called. Of `pair`, `interval`, `yes_no`, `match` (clearer, "
                "fainter, just seen), and of `object` where there are not three; not part of the hash.",
     .changes = Changes::presentation,
     .is_read_apart = true,
     .form = "one an alternative",
     .usual = "English"},
    {.key = "labels",
     .slot = &TaskDefinition::labels,
     .meaning =
         "Labels of `rating`, from nothing seen to most noticeable. Of a slider also two, at its ends.",
     .wording = {.before = "task label ", .after = "\n"},
     .changes = Changes::presentation,
     .is_read_apart = true,
     .form = "five",
     .usual = "ITU-R BT.500"},
    {.key = "blocks",
     .slot = one_of<&TaskDefinition::blocks, false, true>(words_of_blocks),
     .meaning = "All trials of a condition follow each other. The order of conditions is a row of Williams' "
                "balanced Latin square, taken in turn by the participants' slots.",
     .wording = {.before = "task blocks ", .after = "\n", .written = Written::where_unusual},
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "none"},
});
static_assert(are_sound<TaskDefinition>(settings_of<TaskDefinition>));

/// `[staircase]`.
template <>
inline constexpr auto settings_of<StaircaseDefinition> = std::to_array<Setting<StaircaseDefinition>>({
    {.key = "down",
     .slot = &StaircaseDefinition::down,
     .range = {1, 10, "answers"},
     .meaning = "Right answers in a row that lead to the next level where less is seen.",
     .wording = {.before = "staircase down "},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "up",
     .slot = &StaircaseDefinition::up,
     .range = {1, 10, "answers"},
     .meaning = "Wrong answers in a row that lead to the next level where more is seen.",
     .wording = {.before = " up "},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "reversals",
     .slot = &StaircaseDefinition::reversals,
     .range = {4, 100, "reversals"},
     .meaning = "A staircase ends when it has turned so often,",
     .wording = {.before = " reversals "},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "max_trials",
     .slot = &StaircaseDefinition::max_trials,
     .range = {10, 1000, "trials"},
     .meaning = "or after so many trials.",
     .wording = {.before = " trials "},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "by_object",
     .slot = &StaircaseDefinition::by_object,
     .meaning = "Staircases of each object's own; else those of an artifact in a condition show all its "
                "objects.",
     .wording = {.written = Written::where_unusual, .yes = " each object"},
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "start",
     .slot = &StaircaseDefinition::start,
     .range = {-1e9, 1e9, "levels"},
     .meaning = "A staircase for each of them, in each curve.",
     .wording = {.before = " start "},
     .changes = Changes::presentation,
     .of_condition = false,
     .form = "levels of the study",
     .usual = "where most is seen"},
});
static_assert(are_sound<StaircaseDefinition>(settings_of<StaircaseDefinition>));

}  // namespace seamline::inline stimuli
