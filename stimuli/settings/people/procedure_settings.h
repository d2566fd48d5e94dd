#pragma once
#include "stimuli/definition/procedure_definition.h"
#include "stimuli/settings/people/observer_settings.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 3> words_of<PlacementOutcome> = {"correct", "noticeability",
                                                                               "joint"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<PlacementTrack> = {"artifact", "object"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<Sigmoid> = {"logistic", "norm", "gumbel"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<Axis> = {"linear", "log2"};

[[nodiscard]] std::string fault_of_fewest_trials(const QuestPlusDefinition& quest);

/// `[quest_plus]`. Ranges of the grid, and keys that end with a unit, are read by study_file_procedure.cpp.
/// The canonical text is older than these rows: procedure_definition.cpp.
template <>
inline constexpr auto settings_of<QuestPlusDefinition> = std::to_array<Setting<QuestPlusDefinition>>({
    {.key = "max_shows_per_image",
     .slot = &QuestPlusDefinition::max_shows_per_image,
     .range = {1, 100000, "shows"},
     .meaning = "How often a participant may see the same image.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "how often a participant may see the same image"},
    {.key = "outcome",
     .slot = choice<&QuestPlusDefinition::outcome>(),
     .meaning =
         "What is learnt from: was the right object chosen; the score 0 to 4; or the score by the "
         "joint model of seeing, guessing and rating, which new studies should take. It makes "
         "`sigmoid = \"norm\"`, 7 scales, lapses 0 to 0.04 in 3 values and rating steps 0.177 to 1 the "
         "defaults.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true},
    {.key = "track",
     .slot = choice<&QuestPlusDefinition::track>(),
     .meaning = "A threshold for each artifact, or for each object of it; in each condition.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "sigmoid",
     .slot = choice<&QuestPlusDefinition::sigmoid>(),
     .meaning = "Form of the function (`\"gumbel\"` is the Weibull function in log2 width).",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "axis",
     .slot = choice<&QuestPlusDefinition::axis>(),
     .meaning = "The axis on which the function is a sigmoid.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "the level's"},
    {.key = "noticeability",
     .slot = one_of<&QuestPlusDefinition::direction, Direction::decreasing, Direction::increasing>(
         words_of_noticeability),
     .meaning = "With the level.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "the level's"},
    {.key = "threshold_px",
     .slot = Described{"range"},
     .meaning = "Thresholds of the grid, equal ratios.",
     .of_condition = false,
     .is_read_apart = true,
     .form = "above 0",
     .usual = "an octave beyond the levels, 41"},
    {.key = "scale_octaves",
     .slot = Described{"range"},
     .range = {1e-3, 100},
     .meaning = "Scales of the grid, equal ratios.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "0.125 to 2, 9"},
    {.key = "lapse",
     .slot = Described{"range"},
     .range = {0, 0.5},
     .meaning = "Lapse rates, equal steps.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "0 to 0.08, 5"},
    {.key = "guess",
     .slot = Described{"range"},
     .range = {0, 0.99},
     .meaning = "Guess rates, equal steps.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "1/3, 1"},
    {.key = "rating_step_octaves",
     .slot = Described{"range"},
     .range = {1e-3, 100},
     .meaning = "How much coarser the map is for each further rating, equal ratios. Beside `outcome = "
                "\"joint\"` or `\"noticeability\"`.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "0.125 to 1, 4"},
    {.key = "max_trials",
     .slot = &QuestPlusDefinition::max_trials,
     .range = {1, 100000, "trials"},
     .meaning = "Trials of a track.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "min_trials",
     .slot = &QuestPlusDefinition::min_trials,
     .range = {1, 100000, "trials"},
     .meaning = "At most `max_trials`. Trials before one of the next two may end a track.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .fault = fault_of_fewest_trials},
    {.key = "stop_interval_octaves",
     .slot = Described{"number"},
     .range = {1e-3, 100},
     .meaning = "A track ends when the threshold's 95 % interval is at most this wide.",
     .of_condition = false,
     .is_read_apart = true,
     .usual = "never"},
    {.key = "stop_entropy_nats",
     .slot = &QuestPlusDefinition::stop_entropy_nats,
     .range = {0, 100, "nats"},
     .meaning = "A track ends when the posterior's entropy is at most this.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "never"},
    {.key = "edge_share",
     .slot = &QuestPlusDefinition::edge_share,
     .range = {1e-6, 1},
     .meaning = "Alarm when an outermost value of the grid holds more of the posterior.",
     .changes = Changes::presentation,
     .of_condition = false},
});
static_assert(are_sound<QuestPlusDefinition>(settings_of<QuestPlusDefinition>));

}  // namespace seamline::inline stimuli
