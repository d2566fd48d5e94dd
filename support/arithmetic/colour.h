#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace seamline {

/// Linear radiance or reflectance in three channels (Rec. 709 primaries).
using Rgb = Eigen::Array3f;

/// The sRGB curve: linear 0..1 to display units 0..1 (IEC 61966-2-1). Clips outside 0..1; NaN becomes 0.
[[nodiscard]] float srgb_from_linear(float linear);

/// The inverse of `srgb_from_linear` on 0..1.
[[nodiscard]] float linear_from_srgb(float display);

/// Display units 0..1 to an 8-bit code: round to nearest, no dither.
[[nodiscard]] std::uint8_t code_from_display(float display);

}  // namespace seamline
