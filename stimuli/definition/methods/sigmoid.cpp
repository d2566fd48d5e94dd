#include "stimuli/definition/methods/sigmoid.h"

namespace seamline::inline stimuli {

std::string_view word(Sigmoid sigmoid) {
  switch (sigmoid) {
    case Sigmoid::logistic:
      return "logistic";
    case Sigmoid::normal:
      return "norm";
    case Sigmoid::gumbel:
      return "gumbel";
  }
  return {};
}

std::optional<Sigmoid> sigmoid_from_word(std::string_view text) {
  for (const Sigmoid sigmoid : every_sigmoid)
    if (word(sigmoid) == text) return sigmoid;
  return std::nullopt;
}

}  // namespace seamline::inline stimuli
