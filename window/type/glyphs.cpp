// The only file that includes FreeType.
#include "window/type/glyphs.h"

#include <fmt/core.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "support/text/error.h"

namespace seamline::inline window {
namespace {

constexpr double units_in_pixel = 64;

bool is_sfnt(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\0\1\0\0"sv) || bytes.starts_with("OTTO") || bytes.starts_with("true") ||
         bytes.starts_with("ttcf");
}

FT_Pos units(double px) {
  return std::lround(px * units_in_pixel);
}

std::string shape_name(std::uint32_t glyph) {
  return fmt::format("shape {}", glyph);
}

}  // namespace

struct OutlineFont::Handles {
  FontBytes font;
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  FT_F26Dot6 em_units = 0;  ///< that the face is set to

  explicit Handles(FontBytes opened) : font(std::move(opened)) {}
  ~Handles() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  void require(bool good, const std::string& found) const {
    if (!good)
      throw input_error(
          {.file = font.file, .field = "font", .wanted = "a TrueType or OpenType font", .found = found});
  }

  void check(FT_Error error, const std::string& found) const {
    if ((error & 0xff) == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    require(error == 0, found);
  }

  void set_size(double em_px) {
    const FT_F26Dot6 wanted = units(std::clamp(em_px, smallest_em_px, largest_em_px));
    if (wanted == em_units) return;
    check(FT_Set_Char_Size(face, 0, wanted, 0, 0), "one without a size");
    em_units = wanted;
  }

  void require_near(FT_Pos place, const std::string& shape) const {
    const FT_Pos most = largest_shape_em * em_units;
    require(place >= -most && place <= most,
            fmt::format("{} reaching over {} sizes", shape, largest_shape_em));
  }

  /// Makes the outline the face's current one, and says which box holds it.
  FT_BBox load(std::uint32_t number, double em_px, double right_px) {
    set_size(em_px);
    const std::string shape = shape_name(number);
    check(FT_Load_Glyph(face, number, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP), "damage in " + shape);
    require(face->glyph->format == FT_GLYPH_FORMAT_OUTLINE, shape + " without an outline");
    FT_BBox box;
    FT_Outline_Get_CBox(&face->glyph->outline, &box);
    if (font.emboldened && box.xMax > box.xMin) FT_Outline_Embolden(&face->glyph->outline, em_units / 24);
    FT_Outline_Get_CBox(&face->glyph->outline, &box);
    for (const FT_Pos side : {box.xMin, box.xMax, box.yMin, box.yMax}) require_near(side, shape);
    FT_Outline_Translate(&face->glyph->outline, units(right_px), 0);
    FT_Outline_Get_CBox(&face->glyph->outline, &box);
    return box;
  }

  void copy(const FT_Bitmap& bitmap, const std::string& shape, Coverage& glyph) const {
    if (bitmap.width == 0 || bitmap.rows == 0) return;
    const auto most = static_cast<unsigned>(2 * (largest_shape_em * em_units / units(1) + 2));
    require(bitmap.pixel_mode == FT_PIXEL_MODE_GRAY && bitmap.buffer != nullptr && bitmap.width <= most &&
                bitmap.rows <= most && static_cast<unsigned>(std::abs(bitmap.pitch)) >= bitmap.width,
            "damage in " + shape);
    glyph.width_px = static_cast<int>(bitmap.width);
    glyph.height_px = static_cast<int>(bitmap.rows);
    // A negative pitch: the buffer begins with the lowest row.
    const unsigned char* row = bitmap.buffer;
    if (bitmap.pitch < 0) row -= std::ptrdiff_t{bitmap.pitch} * (glyph.height_px - 1);
    for (int y = 0; y < glyph.height_px; ++y, row += bitmap.pitch)
      glyph.values.insert(glyph.values.end(), row, row + bitmap.width);
  }
};

OutlineFont::OutlineFont(FontBytes font) : handles_(std::make_unique<Handles>(std::move(font))) {
  Handles& h = *handles_;
  const std::string& bytes = *h.font.bytes;
  h.require(is_sfnt(bytes), "another kind of file");
  h.require(static_cast<std::int64_t>(bytes.size()) <= largest_font_bytes, "a larger one");
  if (FT_Init_FreeType(&h.library) != 0) throw std::bad_alloc();
  h.check(FT_New_Memory_Face(h.library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                             static_cast<FT_Long>(bytes.size()), 0, &h.face),
          "a damaged one");
  h.require(FT_IS_SCALABLE(h.face) && h.face->units_per_EM > 0, "one without outlines");
  h.check(FT_Select_Charmap(h.face, FT_ENCODING_UNICODE), "one without a table of Unicode characters");
  h.require(height_em() > 0.1 && height_em() <= largest_shape_em && ascent_em() >= 0 &&
                ascent_em() <= largest_shape_em,
            "one whose lines have no height");
}

OutlineFont::~OutlineFont() = default;
OutlineFont::OutlineFont(OutlineFont&&) noexcept = default;
OutlineFont& OutlineFont::operator=(OutlineFont&&) noexcept = default;

double OutlineFont::ascent_em() const {
  return double{1} * handles_->face->ascender / handles_->face->units_per_EM;
}

double OutlineFont::height_em() const {
  return double{1} * (handles_->face->ascender - handles_->face->descender) / handles_->face->units_per_EM;
}

Coverage OutlineFont::frame(std::uint32_t number, double em_px, double right_px) const {
  FT_BBox box = handles_->load(number, em_px, right_px);
  const auto whole = [](FT_Pos place) { return static_cast<int>(place / units(1)); };
  box.xMin = box.xMin & -units(1);
  box.yMin = box.yMin & -units(1);
  box.xMax = (box.xMax + units(1) - 1) & -units(1);
  box.yMax = (box.yMax + units(1) - 1) & -units(1);
  return {.left_px = whole(box.xMin),
          .top_px = -whole(box.yMax),
          .width_px = whole(box.xMax - box.xMin),
          .height_px = whole(box.yMax - box.yMin)};
}

Coverage OutlineFont::glyph(std::uint32_t number, double em_px, double right_px) const {
  const Handles& h = *handles_;
  (void)handles_->load(number, em_px, right_px);
  FT_GlyphSlot slot = h.face->glyph;
  const std::string shape = shape_name(number);
  h.check(FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL), "damage in " + shape);
  Coverage glyph{.left_px = slot->bitmap_left, .top_px = -slot->bitmap_top};
  h.copy(slot->bitmap, shape, glyph);
  return glyph;
}

}  // namespace seamline::inline window
