#include "renderer/views/lens_sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace seamline::renderer {

SheetScreen sheet_screen(const View& view, int picture_width_px) {
  return {.sheet = view.sheet,
          .views = view.views,
          .place_px = view.names_panel() ? view.place_on_panel_px(picture_width_px) : std::array{0, 0}};
}

double place_under_lens(const SheetScreen& screen, int x, int y, int channel) {
  const LensSheet& sheet = screen.sheet;
  const double column = 3.0 * (x + screen.place_px[0]) + channel + 0.5;
  const double lean = 3.0 * (y + screen.place_px[1]) * std::tan(sheet.slant_deg * std::numbers::pi / 180);
  const double lenses = (column + sheet.offset_subpixels - lean) / sheet.pitch_subpixels;
  return lenses - std::floor(lenses);
}

int view_of_subpixel(const SheetScreen& screen, int x, int y, int channel) {
  const int from_left = static_cast<int>(screen.views * place_under_lens(screen, x, y, channel));
  return screen.views - 1 - std::min(from_left, screen.views - 1);
}

Image interleave(const SheetScreen& screen, const Image& strip) {
  const int width_px = strip.width_px / screen.views;
  Image picture(width_px, strip.height_px, 3);
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.at(x, y, channel) =
            strip.at(view_of_subpixel(screen, x, y, channel) * width_px + x, y, channel);
  return picture;
}

Image through_lenses(const SheetScreen& screen, const Image& interleaved, int eye) {
  Image seen(interleaved.width_px, interleaved.height_px, 3);
  std::vector<int> lit;  // columns that send their light to the eye
  for (int y = 0; y < seen.height_px; ++y)
    for (int channel = 0; channel < 3; ++channel) {
      lit.clear();
      for (int x = 0; x < seen.width_px; ++x)
        if (view_of_subpixel(screen, x, y, channel) == eye) lit.push_back(x);
      if (lit.empty()) continue;
      for (int x = 0; x < seen.width_px; ++x) {
        const auto after = std::lower_bound(lit.begin(), lit.end(), x);
        const int right = after == lit.end() ? lit.back() : *after;
        const int left = after == lit.begin() || right == x ? right : *(after - 1);
        const float share =
            right == left ? 0.0F : static_cast<float>(x - left) / static_cast<float>(right - left);
        seen.at(x, y, channel) =
            (1.0F - share) * interleaved.at(left, y, channel) + share * interleaved.at(right, y, channel);
      }
    }
  return seen;
}

}  // namespace seamline::renderer
