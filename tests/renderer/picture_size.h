#pragma once

namespace seamline::test {

/// A picture that renders in seconds and still shows every effect.
inline constexpr int picture_width_px = 192, picture_height_px = 108;

}  // namespace seamline::test
