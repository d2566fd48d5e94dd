// The only file that includes HarfBuzz.
#include "window/type/shaping.h"

#include <fmt/core.h>
#include <hb-ot.h>
#include <hb.h>

#include <algorithm>
#include <cmath>

#include "support/text/error.h"

namespace seamline::inline window {
namespace {

constexpr double positions_in_pixel = 1024;
constexpr std::size_t context_characters = 8;  ///< around a run; HarfBuzz looks at 5
constexpr std::size_t most_glyphs_a_character = 16;

bool is_common(Script script) {
  return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN;
}

}  // namespace

std::vector<Script> scripts_of(std::u32string_view text) {
  hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
  std::vector<Script> scripts;
  scripts.reserve(text.size());
  for (const char32_t character : text) {
    const Script own = hb_unicode_script(unicode, character);
    scripts.push_back(is_common(own) && !scripts.empty() ? scripts.back() : own);
  }
  const auto first = std::find_if_not(scripts.begin(), scripts.end(), is_common);
  std::fill(scripts.begin(), first, first == scripts.end() ? script("Zyyy") : *first);
  return scripts;
}

bool is_joined_to_previous(char32_t character) {
  if (character == 0x200C || character == 0x200D) return true;  // that part or join letters
  const hb_unicode_general_category_t category =
      hb_unicode_general_category(hb_unicode_funcs_get_default(), character);
  return category == HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK ||
         category == HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK ||
         category == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK;
}

struct ShapingFont::Handles {
  FontBytes font;
  hb_font_t* shapes = nullptr;
  hb_buffer_t* buffer = hb_buffer_create();

  explicit Handles(FontBytes opened) : font(std::move(opened)) {
    hb_blob_t* blob = hb_blob_create(font.bytes->data(), static_cast<unsigned>(font.bytes->size()),
                                     HB_MEMORY_MODE_READONLY, nullptr, nullptr);
    hb_face_t* face = hb_face_create(blob, 0);
    hb_blob_destroy(blob);
    shapes = hb_font_create(face);
    hb_face_destroy(face);
  }
  ~Handles() {
    hb_buffer_destroy(buffer);
    hb_font_destroy(shapes);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  void require(bool good, const std::string& found) const {
    if (!good)
      throw input_error(
          {.file = font.file, .field = "font", .wanted = "a TrueType or OpenType font", .found = found});
  }

  /// In pixels, and never farther than any letter reaches.
  [[nodiscard]] double pixels(hb_position_t place, double em_px) const {
    const double px = place / positions_in_pixel;
    require(std::abs(px) <= largest_shape_em * em_px,
            fmt::format("letters reaching over {} sizes", largest_shape_em));
    return px;
  }
};

ShapingFont::ShapingFont(FontBytes font) : handles_(std::make_unique<Handles>(std::move(font))) {}
ShapingFont::~ShapingFont() = default;
ShapingFont::ShapingFont(ShapingFont&&) noexcept = default;
ShapingFont& ShapingFont::operator=(ShapingFont&&) noexcept = default;

bool ShapingFont::has(char32_t character) const {
  hb_codepoint_t number = 0;
  if (hb_font_get_nominal_glyph(handles_->shapes, character, &number) != 0) return true;
  // What is not seen needs no shape: marks of direction, joiners, selectors.
  return hb_unicode_general_category(hb_unicode_funcs_get_default(), character) ==
             HB_UNICODE_GENERAL_CATEGORY_FORMAT ||
         (character >= 0xFE00 && character <= 0xFE0F);
}

std::vector<ShapedGlyph> ShapingFont::shape(std::u32string_view text, const TextRun& run,
                                            const std::string& language, double em_px) const {
  const Handles& h = *handles_;
  const std::size_t before = std::min(run.begin, context_characters);
  const std::u32string_view seen =
      text.substr(run.begin - before, before + run.end - run.begin + context_characters);
  const std::vector<std::uint32_t> codes(seen.begin(), seen.end());
  const auto scale = static_cast<int>(std::lround(em_px * positions_in_pixel));
  hb_font_set_scale(h.shapes, scale, scale);
  hb_buffer_t* buffer = h.buffer;
  hb_buffer_reset(buffer);
  hb_buffer_add_utf32(buffer, codes.data(), static_cast<int>(codes.size()), static_cast<unsigned>(before),
                      static_cast<int>(run.end - run.begin));
  hb_buffer_set_direction(buffer, run.right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
  hb_buffer_set_script(buffer, static_cast<hb_script_t>(run.script));
  hb_buffer_set_language(buffer, hb_language_from_string(language.c_str(), -1));
  hb_shape(h.shapes, buffer, nullptr, 0);
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer, &count);
  if (hb_buffer_allocation_successful(buffer) == 0) throw std::bad_alloc();
  h.require(count <= most_glyphs_a_character * (run.end - run.begin), "one with endless shapes for a letter");
  std::vector<ShapedGlyph> glyphs;
  glyphs.reserve(count);
  for (unsigned i = 0; i < count; ++i)
    glyphs.push_back({.number = infos[i].codepoint,
                      .character = run.begin - before + infos[i].cluster,
                      .advance_px = h.pixels(places[i].x_advance, em_px),
                      .right_px = h.pixels(places[i].x_offset, em_px),
                      .down_px = -h.pixels(places[i].y_offset, em_px)});
  return glyphs;
}

}  // namespace seamline::inline window
