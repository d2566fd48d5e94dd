#include "stimuli/definition/people/form_kinds.h"

namespace seamline::inline stimuli {
namespace {

template <class Options, class Field>
Options* find_options(Field& field) {
  return std::visit(
      [](auto& kind) -> Options* {
        if constexpr (requires { kind.options; })
          return &kind.options;
        else
          return nullptr;
      },
      field.kind);
}

}  // namespace

std::optional<NumberField> number_of(const FormField& field) {
  return std::visit(
      [](const auto& kind) -> std::optional<NumberField> {
        if constexpr (requires { kind.least; })
          return NumberField{.least = kind.least, .most = kind.most, .whole = kind.whole};
        else
          return std::nullopt;
      },
      field.kind);
}

const std::vector<std::string>* options_of(const FormField& field) {
  return find_options<const std::vector<std::string>>(field);
}

std::vector<std::string>* options_of(FormField& field) {
  return find_options<std::vector<std::string>>(field);
}

}  // namespace seamline::inline stimuli
