#pragma once
#include <cstdint>

namespace seamline::inline window {

// Everything in the window is measured in framebuffer pixels, x to the right, y downwards from the top left.

struct Point {
  double x_px = 0, y_px = 0;
};

struct Size {
  double width_px = 0, height_px = 0;
};

struct Rect {
  double x_px = 0, y_px = 0, width_px = 0, height_px = 0;

  [[nodiscard]] double right_px() const { return x_px + width_px; }
  [[nodiscard]] double bottom_px() const { return y_px + height_px; }
  [[nodiscard]] Point centre() const { return {x_px + width_px / 2, y_px + height_px / 2}; }
  [[nodiscard]] bool contains(const Point& p) const {
    return p.x_px >= x_px && p.x_px < right_px() && p.y_px >= y_px && p.y_px < bottom_px();
  }
  [[nodiscard]] Rect grown(double by_px) const {
    return {x_px - by_px, y_px - by_px, width_px + 2 * by_px, height_px + 2 * by_px};
  }
  bool operator==(const Rect&) const = default;
};

/// An sRGB code, straight alpha.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
};

[[nodiscard]] constexpr Colour grey(int code, int alpha = 255) {
  const auto value = static_cast<std::uint8_t>(code);
  return {value, value, value, static_cast<std::uint8_t>(alpha)};
}

}  // namespace seamline::inline window
