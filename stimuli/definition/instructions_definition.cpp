#include "stimuli/definition/instructions_definition.h"

namespace seamline::inline stimuli {

std::vector<InstructionPage> default_instructions() {
  return {
      {.text =
           "Each picture shows a place with three objects: one on the left, one in the middle and one on "
           "the right.\n\nOne of the three was not there when the picture was taken. It was inserted by a "
           "computer, and something about its light, its shadow or its edge may be wrong.\n\nYour task is "
           "to find the inserted object.",
       .pictures = {}},
      {.text =
           "Choose the object that you think was inserted: click it, or press 1 for left, 2 for middle, 3 "
           "for right. Often it will be hard to tell. Then guess.\n\nAfter that you are asked how "
           "noticeable the insertion was. Click one of the four answers or press 1 to 4. If you saw "
           "nothing, choose the lowest one.\n\nThere is no time limit. Press Esc for a pause. A few "
           "practice pictures come first.",
       .pictures = {}}};
}

}  // namespace seamline::inline stimuli
