#include "window/type/paragraph.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/arithmetic/grid_index.h"
#include "window/type/characters.h"
#include "window/type/line_breaks.h"
#include "window/type/text_direction.h"

namespace seamline::inline window {
namespace {

/// A run of one font.
struct FontRun {
  TextRun run;
  std::uint8_t level = 0;
  std::size_t font = 0;
};

struct Range {
  std::size_t begin = 0, end = 0;
};

bool is_space(char32_t character) {
  return character == U' ' || character == 0x3000 || (character >= 0x2000 && character <= 0x200B);
}

std::vector<FontRun> runs_of(const TypeStyle& style, std::u32string_view paragraph) {
  const std::vector<std::uint8_t> levels = direction_levels(paragraph, style.right_to_left);
  const std::vector<Script> scripts = scripts_of(paragraph);
  const std::vector<std::size_t> fonts = fonts_of(*style.fonts, paragraph);
  std::vector<FontRun> runs;
  for (std::size_t i = 0; i < paragraph.size(); ++i) {
    if (i == 0 || levels[i] != levels[i - 1] || scripts[i] != scripts[i - 1] || fonts[i] != fonts[i - 1])
      runs.push_back({{i, i, levels[i] % 2 == 1, scripts[i]}, levels[i], fonts[i]});
    runs.back().run.end = i + 1;
  }
  return runs;
}

std::vector<ShapedGlyph> shape(const TypeStyle& style, std::u32string_view paragraph, const FontRun& run) {
  return (*style.fonts)[run.font].shaping.shape(paragraph, run.run, style.language, style.em_px());
}

/// What each character adds to the width of a line; none: it is part of the shape of one before it.
std::vector<std::optional<double>> advances_of(const TypeStyle& style, std::u32string_view paragraph,
                                               const std::vector<FontRun>& runs) {
  std::vector<std::optional<double>> advances_px(paragraph.size());
  for (const FontRun& run : runs)
    for (const ShapedGlyph& glyph : shape(style, paragraph, run))
      advances_px[glyph.character] = advances_px[glyph.character].value_or(0) + glyph.advance_px;
  return advances_px;
}

/// Where a line ends that begins at `begin`. Spaces at its end need no room.
std::size_t end_of_line(std::u32string_view paragraph, const std::vector<std::optional<double>>& advances_px,
                        const std::vector<bool>& may_end, std::size_t begin, double wrap_px) {
  constexpr double slack_px = 0.01;  // of sums
  double width_px = 0;
  std::size_t word = begin, shape = begin;  // where the last ones began
  for (std::size_t i = begin; i < paragraph.size(); ++i) {
    if (advances_px[i]) shape = i;
    width_px += advances_px[i].value_or(0);
    if (width_px > wrap_px + slack_px && !is_space(paragraph[i])) {
      if (word > begin) return word;
      if (shape > begin) return shape;
    }
    if (may_end[i]) word = i + 1;
  }
  return paragraph.size();
}

std::vector<Range> lines_within(const TypeStyle& style, std::u32string_view paragraph,
                                const std::vector<FontRun>& runs, double wrap_px) {
  if (wrap_px <= 0 || paragraph.empty()) return {{0, paragraph.size()}};
  const std::vector<std::optional<double>> advances_px = advances_of(style, paragraph, runs);
  const std::vector<bool> may_end = line_may_end(paragraph, style.language);
  std::vector<Range> lines;
  for (std::size_t begin = 0; begin < paragraph.size();) {
    const std::size_t end = end_of_line(paragraph, advances_px, may_end, begin, wrap_px);
    lines.push_back({begin, end});
    while (lines.back().end > begin && is_space(paragraph[lines.back().end - 1])) --lines.back().end;
    begin = end;
  }
  return lines;
}

TextLine line_of(const TypeStyle& style, std::u32string_view paragraph, const std::vector<FontRun>& runs,
                 const Range& range) {
  std::vector<FontRun> on_line;
  std::vector<std::uint8_t> levels;
  for (FontRun run : runs) {
    run.run.begin = std::max(run.run.begin, range.begin);
    run.run.end = std::min(run.run.end, range.end);
    if (run.run.begin >= run.run.end) continue;
    on_line.push_back(run);
    levels.push_back(run.level);
  }
  TextLine line;
  for (const std::size_t at : order_on_line(levels))
    for (const ShapedGlyph& glyph : shape(style, paragraph, on_line[at])) {
      line.glyphs.push_back({.font = on_line[at].font,
                             .number = glyph.number,
                             .character = glyph.character,
                             .x_px = line.width_px + glyph.right_px,
                             .y_px = glyph.down_px});
      line.width_px += glyph.advance_px;
    }
  line.width_px = std::max(line.width_px, 0.0);
  return line;
}

/// Paragraphs are set with room between their lines, and half a line between them; labels are not.
double line_height_px(const TypeStyle& style, bool is_empty, double wrap_px) {
  if (wrap_px <= 0) return style.size_px;
  return std::round(is_empty ? 0.6 * style.size_px : 1.32 * style.size_px);
}

/// A glyph on its line, whole pixels away from where it is drawn alone.
Coverage drawn(const TypeStyle& style, const PlacedGlyph& placed,
               Coverage (OutlineFont::*draw)(std::uint32_t, double, double) const) {
  constexpr double steps_in_pixel = 4;  // of places between pixels
  const double em_px = style.em_px();
  const double x_px = std::round(placed.x_px * steps_in_pixel) / steps_in_pixel;
  const double whole_px = std::floor(x_px);
  const double foot_px = std::ceil(style.fonts->front().outlines.ascent_em() * em_px);
  Coverage glyph = ((*style.fonts)[placed.font].outlines.*draw)(placed.number, em_px, x_px - whole_px);
  glyph.left_px += static_cast<int>(whole_px);
  glyph.top_px += static_cast<int>(foot_px + std::round(placed.y_px));
  return glyph;
}

/// The smallest frame around both.
void grow(Coverage& frame, const Coverage& by) {
  if (by.width_px == 0 || by.height_px == 0) return;
  if (frame.width_px == 0) frame = by;
  const int right_px = std::max(frame.left_px + frame.width_px, by.left_px + by.width_px);
  const int bottom_px = std::max(frame.top_px + frame.height_px, by.top_px + by.height_px);
  frame.left_px = std::min(frame.left_px, by.left_px);
  frame.top_px = std::min(frame.top_px, by.top_px);
  frame.width_px = right_px - frame.left_px;
  frame.height_px = bottom_px - frame.top_px;
}

/// Adds the coverage of a glyph to a line's: what both leave open stays open.
void add(const Coverage& glyph, Coverage& line) {
  for (int y = 0; y < glyph.height_px; ++y)
    for (int x = 0; x < glyph.width_px; ++x) {
      const int to_x = glyph.left_px - line.left_px + x, to_y = glyph.top_px - line.top_px + y;
      if (to_x < 0 || to_x >= line.width_px || to_y < 0 || to_y >= line.height_px) continue;
      std::uint8_t& under = line.values[grid_index(to_y, to_x, line.width_px)];
      const int over = glyph.values[grid_index(y, x, glyph.width_px)];
      under = static_cast<std::uint8_t>(255 - ((255 - under) * (255 - over) + 127) / 255);
    }
}

}  // namespace

double TypeStyle::em_px() const {
  return std::clamp(size_px / fonts->front().outlines.height_em(), smallest_em_px, largest_em_px);
}

ArrangedText arrange(const TypeStyle& style, std::string_view utf8, double wrap_px) {
  ArrangedText text;
  for (const std::u32string& paragraph : lines_of(utf8)) {
    const std::vector<FontRun> runs = runs_of(style, paragraph);
    for (const Range& range : lines_within(style, paragraph, runs, wrap_px)) {
      TextLine& line = text.lines.emplace_back(line_of(style, paragraph, runs, range));
      line.top_px = text.height_px;
      text.width_px = std::max(text.width_px, line.width_px);
      text.height_px += line_height_px(style, paragraph.empty(), wrap_px);
    }
  }
  const double room_px = wrap_px > 0 ? wrap_px : text.width_px;
  if (style.right_to_left)
    for (TextLine& line : text.lines) line.left_px = std::round(room_px - line.width_px);
  return text;
}

Coverage draw_line(const TypeStyle& style, const TextLine& line, int most_width_px) {
  const auto least_px = -static_cast<int>(std::ceil(style.size_px));
  Coverage whole;
  for (const PlacedGlyph& placed : line.glyphs)
    if (placed.x_px >= least_px && placed.x_px <= most_width_px)
      grow(whole, drawn(style, placed, &OutlineFont::frame));
  const int right_px = std::min(whole.left_px + whole.width_px, most_width_px);
  whole.left_px = std::max(whole.left_px, least_px);
  whole.width_px = std::max(0, right_px - whole.left_px);
  whole.values.resize(whole.width_px * static_cast<std::size_t>(whole.height_px));
  for (const PlacedGlyph& placed : line.glyphs)
    if (placed.x_px >= least_px && placed.x_px <= most_width_px)
      add(drawn(style, placed, &OutlineFont::glyph), whole);
  return whole;
}

}  // namespace seamline::inline window
