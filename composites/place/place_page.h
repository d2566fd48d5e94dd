#pragma once
#include <string>

#include "window/canvas.h"

namespace seamline::place {

inline constexpr double type_px = 18, bar_px = 64, margin_px = 8;
inline constexpr int most_window_px = 1280;
inline constexpr double longest_wait_s = 0.25;  ///< after which Ctrl-C in the terminal is seen

/// What stands in the bar under the picture.
struct Bar {
  std::string line, help;
  std::string said;  ///< at the right of the line
  bool warned = false;
};

/// A picture of this shape, as large as fits above the bar.
[[nodiscard]] Rect picture_in(const Size& screen_px, double aspect);

void draw_page(Canvas& canvas, const Rect& picture, const WindowTexture& texture, const Size& screen_px,
               const Bar& bar);

}  // namespace seamline::place
