#pragma once
#include "stimuli/definition/people/recruitment_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

inline constexpr double most_recruited_people = 1e6;

/// `[recruitment]`. What depends on the form, on identifiers or on catch trials is read by
/// study_file_recruitment.cpp. Nothing of it is in the hash.
template <>
inline constexpr auto settings_of<RecruitmentDefinition> = std::to_array<Setting<RecruitmentDefinition>>({
    {.key = "identifiers",
     .slot = &RecruitmentDefinition::identifiers,
     .meaning = "Names in the link whose values are kept, apart from the log. The first one tells people "
                "apart.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = "names",
     .usual = "none"},
    {.key = "identifiers_required",
     .slot = &RecruitmentDefinition::identifiers_required,
     .meaning = "Who comes without is not let in.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "return_link",
     .slot = &RecruitmentDefinition::return_link,
     .meaning = "Where people are sent at the end; `{code}` and `{NAME}` of an identifier are filled in.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = "`https://` address",
     .usual = "none"},
    {.key = "least_attention",
     .slot = &RecruitmentDefinition::least_attention,
     .range = {0, 1000, "trials"},
     .meaning = "Attention trials to be answered right; at most those of `[catch]`.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "most_people",
     .slot = &RecruitmentDefinition::most_people,
     .range = {0, most_recruited_people, "people"},
     .meaning = "Nobody new is let in while so many finished or are at it. 0: all who come.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "hold_min",
     .slot = &RecruitmentDefinition::hold_min,
     .range = {1, 100000, "min"},
     .meaning = "How long a place is held for somebody unfinished who is not heard of.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "closes",
     .slot = Described{"text"},
     .meaning = "Universal time from which nobody new is let in.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = "`\"2026-12-31 23:59\"`",
     .usual = "never"},
});
static_assert(are_sound<RecruitmentDefinition>(settings_of<RecruitmentDefinition>));

/// `[[recruitment.quota]]`, beside its rule.
template <>
inline constexpr auto settings_of<QuotaDefinition> = std::to_array<Setting<QuotaDefinition>>({
    {.key = "most_people",
     .slot = &QuotaDefinition::most_people,
     .range = {1, most_recruited_people, "people"},
     .meaning = "People whose answers keep the rule.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "how many people"},
});

}  // namespace seamline::inline stimuli
