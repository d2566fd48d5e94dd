#include "raytracer/error/worst_tile.h"

#include <algorithm>

#include "raytracer/common/tiles.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

constexpr int enlarged = 8, tile_gap_px = 4, caption_px = 24, text_px = 13;
constexpr int difference_times = 8, mid_grey = 128;
constexpr std::uint8_t gap_code = 128;

std::size_t index_of(const ByteImage& image, int x, int y) {
  return grid_index(y, x, image.width_px) * 3;
}

/// Draws a tile whose codes are `code(index into the picture)` with nearest sampling.
template <class Code>
void draw_tile(const ByteImage& from, const TileGrid::Rectangle& tile, const Code& code, ByteImage& sheet,
               int left) {
  for (int y = 0; y < (tile.bottom - tile.top) * enlarged; ++y)
    for (int x = 0; x < (tile.right - tile.left) * enlarged; ++x) {
      const std::size_t source = index_of(from, tile.left + x / enlarged, tile.top + y / enlarged);
      const std::size_t target = index_of(sheet, left + x, tile_gap_px + y);
      for (std::size_t c = 0; c < 3; ++c) sheet.values[target + c] = code(source + c);
    }
}

void fill_rows(ByteImage& sheet, int top, int bottom, std::uint8_t code) {
  std::fill(sheet.values.begin() + static_cast<std::ptrdiff_t>(index_of(sheet, 0, top)),
            sheet.values.begin() + static_cast<std::ptrdiff_t>(index_of(sheet, 0, bottom)), code);
}

}  // namespace

ByteImage worst_tile_picture(const ByteImage& shown, const ByteImage& reference, int tile,
                             const std::string& caption) {
  const TileGrid::Rectangle r = TileGrid{shown.width_px, shown.height_px}.rectangle(tile);
  // Tiles at the border may be smaller; the sheet keeps its size, so that the caption has room.
  constexpr int cell_px = TileGrid::side_px * enlarged;
  ByteImage sheet{3 * cell_px + 4 * tile_gap_px, cell_px + 2 * tile_gap_px + caption_px, 3, {}};
  sheet.values.resize(static_cast<std::size_t>(sheet.width_px) * static_cast<std::size_t>(sheet.height_px) *
                      3);
  fill_rows(sheet, 0, cell_px + 2 * tile_gap_px, gap_code);
  fill_rows(sheet, cell_px + 2 * tile_gap_px, sheet.height_px, paper_code);
  const auto left_of = [](int cell) { return tile_gap_px + cell * (cell_px + tile_gap_px); };
  draw_tile(
      shown, r, [&](std::size_t i) { return shown.values[i]; }, sheet, left_of(0));
  draw_tile(
      shown, r, [&](std::size_t i) { return reference.values[i]; }, sheet, left_of(1));
  draw_tile(
      shown, r,
      [&](std::size_t i) {
        const int difference = int{shown.values[i]} - int{reference.values[i]};
        return static_cast<std::uint8_t>(std::clamp(mid_grey + difference_times * difference, 0, 255));
      },
      sheet, left_of(2));
  draw_text(sheet, tile_gap_px, sheet.height_px - 7, caption, text_px, ink_code);
  return sheet;
}

}  // namespace seamline::renderer
