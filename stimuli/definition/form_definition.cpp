#include "stimuli/definition/form_definition.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace seamline::inline stimuli {
namespace {

std::optional<FormFault> fault_of_number(const auto& field, const std::string& value) {
  double number = 0;
  const char* end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, number);
  if (error != std::errc() || stop != end || !std::isfinite(number)) return FormFault::not_a_number;
  if (field.whole && number != std::floor(number)) return FormFault::not_a_number;
  if (number < field.least || number > field.most) return FormFault::out_of_range;
  return std::nullopt;
}

std::optional<FormFault> fault_of_option(const std::vector<std::string>& options, const std::string& value) {
  const bool known = std::find(options.begin(), options.end(), value) != options.end();
  return known ? std::nullopt : std::optional(FormFault::not_an_option);
}

}  // namespace

std::vector<FormField> default_form() {
  return {
      {.name = "age", .label = "Your age", .kind = NumberField{.least = 18, .most = 120, .whole = true}},
      {.name = "gender",
       .label = "Your gender",
       .kind = ChoiceField{{"female", "male", "another", "I prefer not to say"}}},
      {.name = "vision",
       .label = "Your vision",
       .kind = ChoiceField{{"normal", "corrected to normal (glasses or lenses)", "neither"}}},
      {.name = "technical_background",
       .label = "Do you study or work in a technical field such as computer graphics, computer science or "
                "computer vision?",
       .kind = ChoiceField{{"yes", "no"}}}};
}

std::optional<FormFault> fault_of(const FormField& field, const std::string& value) {
  if (value.empty()) return field.required ? std::optional(FormFault::missing) : std::nullopt;
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.least; })
          return fault_of_number(kind, value);
        else
          return fault_of_option(kind.options, value);
      },
      field.kind);
}

}  // namespace seamline::inline stimuli
