#include "stimuli/definition/methods/sigmoid.h"

namespace seamline::inline stimuli {

std::optional<Sigmoid> sigmoid_from_word(std::string_view text) {
  for (const Sigmoid sigmoid : every_sigmoid)
    if (word(sigmoid) == text) return sigmoid;
  return std::nullopt;
}

}  // namespace seamline::inline stimuli
