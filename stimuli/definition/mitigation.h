#pragma once
#include <compare>
#include <string>
#include <string_view>

#include "stimuli/definition/methods/occlusion.h"

namespace seamline::inline stimuli {

/// What stands in for the depth mesh where suns light real surfaces. `matte`: a matte that somebody painted,
/// which is the truth's shadows. `detected`: the depth mesh's shadows, but where the photograph is clearly
/// darker or brighter than they make it.
enum class ShadowMitigation { none, matte, detected };

/// How things that block light and sight are kept: with sheets to what is behind them, as in the paper, or
/// each as a layer of its own, over what the truth has behind it.
enum class Blockers { sheets, layers };

/// What hides a seam besides finer depth. Masks and mattes lie in the panorama's domain.
struct Mitigation {
  Occlusion occlusion = Occlusion::mesh;  ///< or `mask`, `edges`
  ShadowMitigation shadow = ShadowMitigation::none;
  Blockers blockers = Blockers::sheets;
  int mask_width_px = 4096;   ///< of an occlusion mask's panorama, even; has a meaning only with a mask
  int matte_width_px = 4096;  ///< likewise of a shadow matte's

  auto operator<=>(const Mitigation&) const = default;
};

[[nodiscard]] std::string_view word(ShadowMitigation mitigation);
[[nodiscard]] std::string_view word(Blockers blockers);

/// "occlusion mask 4096, shadow matte 4096, blockers layers": what is mitigated, and nothing else; empty
/// where nothing is.
[[nodiscard]] std::string canonical_text(const Mitigation& mitigation);

}  // namespace seamline::inline stimuli
