#pragma once
#include <array>
#include <string_view>

#include "support/files/image.h"

namespace seamline::scenes {

/// The built-in environment maps, by the name that `builtin:NAME` takes.
inline constexpr std::array<std::string_view, 2> builtin_sky_names = {"clear_sky", "window_room"};

/// 512 x 256 texels of radiance, W/m2/sr, as environment maps are (+Y up, the centre looks along -Z).
/// `clear_sky`: a blue sky, paler towards the horizon, with a sun of 2.5 degrees radius and 3.1 W/m2, 45
/// degrees high to the front right, over brownish ground. `window_room`: a closed room of 6 x 3 x 5 m with
/// two windows to its left, a square lamp under its ceiling and walls that are lit evenly.
[[nodiscard]] Image builtin_sky(std::string_view name);

}  // namespace seamline::scenes
