#include "stimuli/settings/mitigation_settings.h"

namespace seamline::inline stimuli {

std::string fault_of_mask_width(const Mitigation& mitigation) {
  return mitigation.mask_width_px % 2 == 0 ? "" : "an even width";
}

std::string fault_of_matte_width(const Mitigation& mitigation) {
  return mitigation.matte_width_px % 2 == 0 ? "" : "an even width";
}

std::string_view word(ShadowMitigation mitigation) {
  return word_of(mitigation);
}
std::string_view word(Blockers blockers) {
  return word_of(blockers);
}

std::string canonical_text(const Mitigation& mitigation) {
  return settings_text(mitigation);
}

}  // namespace seamline::inline stimuli
