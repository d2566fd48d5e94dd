#pragma once
#include "stimuli/definition/people/language_definition.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

/// `[[language]]`. Not in the hash.
template <>
inline constexpr auto settings_of<LanguageDefinition> = std::to_array<Setting<LanguageDefinition>>({
    {.key = "tag",
     .slot = &LanguageDefinition::tag,
     .meaning = "The language; not `session.language`.",
     .changes = Changes::presentation,
     .of_condition = false,
     .required = "a text in quotes",
     .form = "a tag of BCP 47"},
    {.key = "texts",
     .slot = &LanguageDefinition::texts,
     .meaning = "Its texts; later ones win.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .required = "an array of texts",
     .form = "`\"builtin:TAG\"`, file, or a list of them"},
    {.key = "font",
     .slot = &LanguageDefinition::font,
     .meaning = "Beside the study file.",
     .changes = Changes::presentation,
     .of_condition = false,
     .form = "a TrueType file",
     .usual = "the study's"},
});

}  // namespace seamline::inline stimuli
