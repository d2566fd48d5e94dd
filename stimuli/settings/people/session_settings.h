#pragma once
#include "stimuli/definition/study_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 3> words_of<ResumePolicy> = {"resume", "restart", "refuse"};

/// Its language is a tag of BCP 47 as far as its form goes: parts of one to eight letters and digits, the
/// first of letters.
[[nodiscard]] std::string fault_of_language(const SessionDefinition& session);

/// `[session]`.
template <>
inline constexpr auto settings_of<SessionDefinition> = std::to_array<Setting<SessionDefinition>>({
    {.key = "question",
     .slot = &SessionDefinition::question,
     .meaning = "What people are asked of each picture.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "rating_question",
     .slot = &SessionDefinition::rating_question,
     .meaning = "What those are asked who chose the right object.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "rating_labels",
     .slot = Described{"four texts"},
     .meaning = "Labels of the ratings 1 to 4.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "the paper's"},
    {.key = "break_every_trials",
     .slot = &SessionDefinition::break_every_trials,
     .range = {1, 100000, "trials"},
     .meaning = "Trials between breaks, catch trials among them.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "minimum_viewing_s",
     .slot = &SessionDefinition::minimum_viewing_s,
     .range = {0, 60, "s"},
     .meaning = "An earlier choice does not count. 0.1 s is the least, whatever stands here.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "inter_trial_s",
     .slot = &SessionDefinition::inter_trial_s,
     .range = {0, 60, "s"},
     .meaning = "Grey with a fixation mark before each picture.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "resume",
     .slot = choice<&SessionDefinition::resume>(),
     .meaning = "Who comes again before the end goes on, begins again (earlier answers are set aside), or is "
                "refused.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "orders",
     .slot = &SessionDefinition::orders,
     .range = {0, 100000, "orders"},
     .meaning = "Counterbalanced orders that people share. 0: everybody has an order of their own.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "text_scale",
     .slot = &SessionDefinition::text_scale,
     .range = {0.5, 4},
     .meaning = "Size of the application's texts.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "font",
     .slot = &SessionDefinition::font,
     .meaning = "The first font of all texts; letters that it lacks come from those of the computer.",
     .changes = Changes::presentation,
     .of_condition = false,
     .form = "a TrueType file",
     .usual = "the application's"},
    {.key = "language",
     .slot = &SessionDefinition::language,
     .meaning = "Language of the texts, for the page in a browser.",
     .changes = Changes::presentation,
     .of_condition = false,
     .fault = fault_of_language,
     .form = "a tag as `\"de\"`, `\"pt-BR\"`"},
});

/// `[catch]`. A thousand of a kind in a session: more would be another study.
template <>
inline constexpr auto settings_of<CatchDefinition> = std::to_array<Setting<CatchDefinition>>({
    {.key = "attention",
     .slot = &CatchDefinition::attention,
     .range = {0, 1000, "trials"},
     .meaning = "Trials with an insertion that nobody who looks can miss: one object two stops brighter and "
                "magenta.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "reference",
     .slot = &CatchDefinition::reference,
     .range = {0, 1000, "trials"},
     .meaning = "Trials in which nothing was inserted. No answer is right; they show how a participant "
                "guesses.",
     .changes = Changes::presentation,
     .of_condition = false},
});

/// `[training]`.
template <>
inline constexpr auto settings_of<TrainingDefinition> = std::to_array<Setting<TrainingDefinition>>({
    {.key = "trials",
     .slot = &TrainingDefinition::trials,
     .range = {0, 1000, "trials"},
     .meaning = "Practice trials: those whose level is noticed most, one artifact after the other.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "stimuli",
     .slot = Described{"list of ids"},
     .meaning = "Which ones, in place of `trials`.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "none"},
    {.key = "feedback_right",
     .slot = &TrainingDefinition::feedback_right,
     .meaning = "`{object}` is \"on the left\", \"in the middle\" or \"on the right\".",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "feedback_wrong",
     .slot = &TrainingDefinition::feedback_wrong,
     .meaning = "The same, of a wrong choice.",
     .changes = Changes::presentation,
     .of_condition = false},
});

/// `[consent]`.
template <>
inline constexpr auto settings_of<ConsentDefinition> = std::to_array<Setting<ConsentDefinition>>({
    {.key = "text",
     .slot = &ConsentDefinition::text,
     .meaning =
         "What people read first; an empty line begins a paragraph. The template is shown to `--pilot` "
         "participants only.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "a template"},
    {.key = "accept",
     .slot = &ConsentDefinition::accept,
     .meaning = "The answer that begins.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "decline",
     .slot = &ConsentDefinition::decline,
     .meaning = "The answer that ends.",
     .changes = Changes::presentation,
     .of_condition = false},
});

}  // namespace seamline::inline stimuli
