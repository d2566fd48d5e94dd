#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace seamline::inline stimuli {

/// A number within a range, both ends included.
struct NumberField {
  double least = 0;
  double most = 1e6;
  bool whole = true;
};

/// One of some options.
struct ChoiceField {
  std::vector<std::string> options;  ///< at least two, all different
};

/// One question of the participant form. There is no kind for free text, because people write names into it.
struct FormField {
  std::string name;   ///< as in the log: a-z, 0-9, _
  std::string label;  ///< as people read it
  std::variant<NumberField, ChoiceField> kind;
  bool required = true;
};

/// What a participant entered: a number as typed, or an option. An optional field that was left empty has no
/// answer.
struct FormAnswer {
  std::string field;
  std::string value;
  bool operator==(const FormAnswer&) const = default;
};

/// The paper's demographics (section 4): age, gender, vision normal or corrected, technical background.
[[nodiscard]] std::vector<FormField> default_form();

enum class FormFault { missing, not_a_number, out_of_range, not_an_option };

/// What is wrong with an answer, if anything. An empty value is no answer.
[[nodiscard]] std::optional<FormFault> fault_of(const FormField& field, const std::string& value);

}  // namespace seamline::inline stimuli
