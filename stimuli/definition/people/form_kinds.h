#pragma once
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/form_definition.h"

// What a kind of question stores follows from the members of its struct, so nobody but who draws a kind knows
// it by name: one with `least`, `most` and `whole` stores a number, any other one of its `options`.
namespace seamline::inline stimuli {

/// The number that is stored of a question; nothing where one of its options is.
[[nodiscard]] std::optional<NumberField> number_of(const FormField& field);

/// Texts that people read beside the label, to be translated; null where the kind has none.
[[nodiscard]] const std::vector<std::string>* options_of(const FormField& field);
[[nodiscard]] std::vector<std::string>* options_of(FormField& field);

}  // namespace seamline::inline stimuli
