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

Image interleave(const SheetScreen& screen, const Image& all_eyes) {
  const int width_px = all_eyes.width_px / screen.views;
  Image picture(width_px, all_eyes.height_px, 3);
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.at(x, y, channel) =
            all_eyes.at(view_of_subpixel(screen, x, y, channel) * width_px + x, y, channel);
  return picture;
}

namespace {

/// The columns of a row that send a channel of theirs to an eye.
std::vector<int> lit_columns(const SheetScreen& screen, int width_px, int y, int channel, int eye) {
  std::vector<int> lit;
  for (int x = 0; x < width_px; ++x)
    if (view_of_subpixel(screen, x, y, channel) == eye) lit.push_back(x);
  return lit;
}

/// `position` between two of rising places, and how far on the way; beyond the outermost that one alone.
struct BetweenPlaces {
  int first = 0, second = 0;
  float share = 0;
};
BetweenPlaces between(const std::vector<int>& places, int position) {
  const auto after = std::lower_bound(places.begin(), places.end(), position);
  const int second = after == places.end() ? places.back() : *after;
  const int first = after == places.begin() || second <= position ? second : *(after - 1);
  if (first == second) return {second, second, 0};
  return {first, second, static_cast<float>(position - first) / static_cast<float>(second - first)};
}

}  // namespace

Image through_lenses(const SheetScreen& screen, const Image& interleaved, int eye) {
  Image seen(interleaved.width_px, interleaved.height_px, 3);
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<int> lit_rows;
    for (int y = 0; y < seen.height_px; ++y) {
      const std::vector<int> lit = lit_columns(screen, seen.width_px, y, channel, eye);
      if (lit.empty()) continue;
      lit_rows.push_back(y);
      for (int x = 0; x < seen.width_px; ++x) {
        const BetweenPlaces at = between(lit, x);
        seen.at(x, y, channel) = (1.0F - at.share) * interleaved.at(at.first, y, channel) +
                                 at.share * interleaved.at(at.second, y, channel);
      }
    }
    if (lit_rows.empty()) continue;
    for (int y = 0; y < seen.height_px; ++y) {
      const BetweenPlaces at = between(lit_rows, y);
      if (at.second == y) continue;
      for (int x = 0; x < seen.width_px; ++x)
        seen.at(x, y, channel) =
            (1.0F - at.share) * seen.at(x, at.first, channel) + at.share * seen.at(x, at.second, channel);
    }
  }
  return seen;
}

}  // namespace seamline::renderer
