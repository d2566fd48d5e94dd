#include "stimuli/settings/study_settings.h"

namespace seamline::inline stimuli {

std::string_view word(MeshDensity density) {
  return word_of(density);
}

}  // namespace seamline::inline stimuli
