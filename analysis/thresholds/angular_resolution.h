#pragma once
#include <cmath>
#include <numbers>

namespace seamline::analysis {

/// Texels per degree along the equator of an equirectangular depth map W px wide: W / 360.
[[nodiscard]] constexpr double texels_per_degree(double width_px) {
  return width_px / 360;
}

/// Thresholds were measured with maps of the full sphere; a camera that sees `field_of_view_deg` horizontally
/// needs fewer texels for the same angular resolution (paper section 6). Width in px of an equirectangular
/// cut of that field of view with the resolution of a full map `width_px` wide: W v / 360.
[[nodiscard]] constexpr double width_in_field_of_view_px(double width_px, double field_of_view_deg) {
  return width_px * field_of_view_deg / 360;
}

/// The same for a pinhole (perspective) depth camera: its texels are coarsest in angle at the centre of the
/// picture, so that is where it has to match: W tan(v / 2) / pi. `field_of_view_deg` is under 180.
[[nodiscard]] inline double pinhole_width_px(double width_px, double field_of_view_deg) {
  return width_px / std::numbers::pi * std::tan(field_of_view_deg / 2 * std::numbers::pi / 180);
}

}  // namespace seamline::analysis
