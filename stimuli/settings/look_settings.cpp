#include "stimuli/settings/look_settings.h"

namespace seamline::inline stimuli {
namespace {

std::string fault_of_limits(const std::array<double, 2>& deg) {
  return deg[0] <= 0 && deg[1] >= 0 ? "" : "the least and the largest angle, with 0 between them";
}

}  // namespace

std::string fault_of_yaw(const LookDefinition& look) {
  return fault_of_limits(look.yaw_deg);
}
std::string fault_of_pitch(const LookDefinition& look) {
  return fault_of_limits(look.pitch_deg);
}

std::string_view word(LookKind kind) {
  return word_of(kind);
}

std::string canonical_text(const LookDefinition& look) {
  return settings_text(look);
}

}  // namespace seamline::inline stimuli
