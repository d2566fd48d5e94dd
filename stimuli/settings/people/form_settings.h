#pragma once
#include "stimuli/definition/people/recruitment_definition.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/settings/settings_text.h"

// None of it is in the hash.
namespace seamline::inline stimuli {

inline constexpr NumberRange numbers_of_people = {-1e9, 1e9};

template <>
inline constexpr std::array<std::string_view, 2> words_of<decltype(FormField::kind)> = {"number", "choice"};
static_assert(words_of<decltype(FormField::kind)>.size() == std::variant_size_v<decltype(FormField::kind)>);

[[nodiscard]] std::string fault_of_name(const FormField& field);

/// `[[form_field]]` of numbers.
template <>
inline constexpr auto settings_of<NumberField> = std::to_array<Setting<NumberField>>({
    {.key = "least",
     .slot = &NumberField::least,
     .range = numbers_of_people,
     .meaning = "Smallest number.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "most",
     .slot = &NumberField::most,
     .range = numbers_of_people,
     .meaning = "Largest number.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "whole",
     .slot = &NumberField::whole,
     .meaning = "Whole numbers only.",
     .changes = Changes::presentation,
     .of_condition = false},
});

/// `[[form_field]]` of choices.
template <>
inline constexpr auto settings_of<ChoiceField> = std::to_array<Setting<ChoiceField>>({
    {.key = "options",
     .slot = &ChoiceField::options,
     .meaning = "At least two that differ.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "an array of texts"},
});

/// `[[form_field]]`, beside the rows of its kind.
template <>
inline constexpr auto settings_of<FormField> = std::to_array<Setting<FormField>>({
    {.key = "name",
     .slot = &FormField::name,
     .meaning = "Name in the log.",
     .changes = Changes::presentation,
     .of_condition = false,
     .fault = fault_of_name,
     .required = "a text in quotes",
     .form = "`a-z`, `0-9`, `_`"},
    {.key = "label",
     .slot = &FormField::label,
     .meaning = "The question, as people read it.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "a text in quotes"},
    {.key = "required",
     .slot = &FormField::required,
     .meaning = "Whether it must be answered.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "kind",
     .slot = choice<&FormField::kind>(),
     .meaning = "There is no free text, because people write names into it.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "one of these words"},
});
static_assert(are_sound<FormField>(settings_of<FormField>));

/// `[[recruitment.screen]]`, and the rule of a `[[recruitment.quota]]`: `answers` of a choice, the other two
/// of a number.
template <>
inline constexpr auto settings_of<FormRule> = std::to_array<Setting<FormRule>>({
    {.key = "field",
     .slot = &FormRule::field,
     .meaning = "Which `form_field`.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "a text in quotes"},
    {.key = "answers",
     .slot = &FormRule::answers,
     .meaning = "Of a choice: options that keep the rule.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "an array of texts"},
    {.key = "least",
     .slot = &FormRule::least,
     .range = numbers_of_people,
     .meaning = "Of a number, which needs one of these two: the smallest that keeps the rule.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "most",
     .slot = &FormRule::most,
     .range = numbers_of_people,
     .meaning = "The largest.",
     .changes = Changes::presentation,
     .of_condition = false},
});

/// `[[instructions.page]]`.
template <>
inline constexpr auto settings_of<InstructionPage> = std::to_array<Setting<InstructionPage>>({
    {.key = "text",
     .slot = &InstructionPage::text,
     .meaning = "What the page says.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "none"},
    {.key = "pictures",
     .slot = &InstructionPage::pictures,
     .meaning = "PNG or JPEG; in place of the text, or beside it.",
     .changes = Changes::presentation,
     .of_condition = false,
     .usual = "none"},
});

}  // namespace seamline::inline stimuli
