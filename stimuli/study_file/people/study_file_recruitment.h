#pragma once
#include <memory>
#include <span>

#include "stimuli/definition/form_definition.h"
#include "stimuli/definition/people/recruitment_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads `[recruitment]` of a study file, beside its form and its attention trials (which the screening and
/// the quotas ask about); none where there is none. Throws InputError as read_study does.
[[nodiscard]] std::shared_ptr<const RecruitmentDefinition> read_recruitment(const TomlTable& study,
                                                                            std::span<const FormField> form,
                                                                            int attention_trials);

/// Texts of `known` that a table [texts] has, each with no other `{places}` than the English one.
[[nodiscard]] std::map<std::string, std::string> read_page_texts(const TomlTable& texts,
                                                                 std::span<const PageText> known);

/// The `{word}` places of a text.
[[nodiscard]] std::vector<std::string> places_in(const std::string& text);

}  // namespace seamline::inline stimuli
