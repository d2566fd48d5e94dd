#pragma once
#include <cstdint>

#include "study/app/pictures/picture_place.h"
#include "window/canvas.h"
#include "window/window.h"

namespace seamline::study::app {

/// What came back of a test picture.
struct PixelCheck {
  std::int64_t bytes = 0;      ///< compared
  std::int64_t different = 0;  ///< of those; 0: the screen gets exactly a picture's bytes
};

/// A picture in which every code of every channel occurs, beside others.
[[nodiscard]] ByteImage test_picture(int width_px, int height_px);

/// Draws a test picture of the stimuli's size where and how stimuli are drawn, and compares every byte with
/// what the framebuffer holds. `corner_px`: see `place_trial`. What is on the screen does not change.
[[nodiscard]] PixelCheck check_pixels(Window& window, Canvas& canvas, Size picture_px, double em_px,
                                      const std::optional<Point>& corner_px);

}  // namespace seamline::study::app
