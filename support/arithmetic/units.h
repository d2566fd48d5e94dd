#pragma once
#include <numbers>

namespace seamline {

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;
inline constexpr double mm_per_m = 1000;

/// Lux of KHR_lights_punctual for 1 W/m2, and candela for 1 W/sr.
inline constexpr double lux_per_w_m2 = 683.0;

}  // namespace seamline
