#pragma once
#include <compare>
#include <string>
#include <string_view>

namespace seamline::inline stimuli {

/// What stands in for the depth mesh where the real world may hide the virtual object (paper, section 6).
/// `mask`: a mask that somebody painted, which is the truth's silhouettes. `edges`: the depth mesh's own
/// silhouettes, moved onto the photograph's edges.
enum class OcclusionMitigation { none, mask, edges };

/// What stands in for the depth mesh where suns light real surfaces. `matte`: a matte that somebody painted,
/// which is the truth's shadows. `detected`: the depth mesh's shadows, but where the photograph is clearly
/// darker or brighter than they make it.
enum class ShadowMitigation { none, matte, detected };

/// How things that block light and sight are kept: with sheets to what is behind them, as in the paper, or
/// each as a layer of its own, over what the truth has behind it.
enum class Blockers { sheets, layers };

/// What hides a seam besides finer depth. Masks and mattes lie in the panorama's domain.
struct Mitigation {
  OcclusionMitigation occlusion = OcclusionMitigation::none;
  ShadowMitigation shadow = ShadowMitigation::none;
  Blockers blockers = Blockers::sheets;
  int mask_width_px = 4096;   ///< of an occlusion mask's panorama, even; has a meaning only with a mask
  int matte_width_px = 4096;  ///< likewise of a shadow matte's

  auto operator<=>(const Mitigation&) const = default;
};

[[nodiscard]] constexpr std::string_view word(OcclusionMitigation mitigation) {
  switch (mitigation) {
    case OcclusionMitigation::none:
      return "none";
    case OcclusionMitigation::mask:
      return "mask";
    case OcclusionMitigation::edges:
      return "edges";
  }
  return {};
}

[[nodiscard]] constexpr std::string_view word(ShadowMitigation mitigation) {
  switch (mitigation) {
    case ShadowMitigation::none:
      return "none";
    case ShadowMitigation::matte:
      return "matte";
    case ShadowMitigation::detected:
      return "detected";
  }
  return {};
}

[[nodiscard]] constexpr std::string_view word(Blockers blockers) {
  switch (blockers) {
    case Blockers::sheets:
      return "sheets";
    case Blockers::layers:
      return "layers";
  }
  return {};
}

/// "occlusion mask 4096, shadow matte 4096, blockers layers": what is mitigated, and nothing else; empty
/// where nothing is.
[[nodiscard]] inline std::string canonical_text(const Mitigation& mitigation) {
  std::string text;
  const auto add = [&](std::string_view what, std::string_view how, int width_px) {
    if (!text.empty()) text += ", ";
    text += std::string(what) + " " + std::string(how);
    if (width_px > 0) text += " " + std::to_string(width_px);
  };
  if (mitigation.occlusion != OcclusionMitigation::none)
    add("occlusion", word(mitigation.occlusion), mitigation.mask_width_px);
  if (mitigation.shadow != ShadowMitigation::none)
    add("shadow", word(mitigation.shadow), mitigation.matte_width_px);
  if (mitigation.blockers != Blockers::sheets) add("blockers", word(mitigation.blockers), 0);
  return text;
}

}  // namespace seamline::inline stimuli
