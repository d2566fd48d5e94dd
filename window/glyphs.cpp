// The only file that includes FreeType.
#include "window/glyphs.h"

#include <fmt/core.h>
#include <ft2build.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "support/text/error.h"

namespace seamline::inline window {
namespace {

constexpr int smallest_size_px = 4, largest_size_px = 1024;
constexpr FT_Pos units_in_pixel = 64;

using Library = std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)>;
using Face = std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)>;

/// A font of somebody else, opened.
class OpenFont {
 public:
  OpenFont(std::string_view bytes, const std::string& file, int size_px)
      : file_(file), size_px_(std::clamp(size_px, smallest_size_px, largest_size_px)) {
    require(is_sfnt(bytes), "another kind of file");
    require(static_cast<std::int64_t>(bytes.size()) <= largest_font_bytes, "a larger one");
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();
    library_.reset(library);
    FT_Face face = nullptr;
    check(FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                             static_cast<FT_Long>(bytes.size()), 0, &face),
          "a damaged one");
    face_.reset(face);
    require(FT_IS_SCALABLE(face), "one without outlines");
    check(FT_Select_Charmap(face, FT_ENCODING_UNICODE), "one without a table of Unicode characters");
    FT_Size_RequestRec request{.type = FT_SIZE_REQUEST_TYPE_REAL_DIM,
                               .width = 0,
                               .height = size_px_ * units_in_pixel,
                               .horiResolution = 0,
                               .vertResolution = 0};
    check(FT_Request_Size(face, &request), "one without a size");
    ascent_px_ = pixels(face->size->metrics.ascender, "its line");
  }

  /// Nothing is added where the font lacks the character.
  void add(char32_t character, std::vector<Glyph>& glyphs) const {
    const FT_UInt index = FT_Get_Char_Index(face_.get(), character);
    if (index == 0) return;
    const std::string shape = fmt::format("the shape of U+{:04X}", static_cast<unsigned>(character));
    check(FT_Load_Glyph(face_.get(), index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP), "damage in " + shape);
    FT_GlyphSlot slot = face_->glyph;
    require(slot->format == FT_GLYPH_FORMAT_OUTLINE, shape + " without an outline");
    Glyph glyph{.character = character, .coverage = {}};
    glyph.advance_px = pixels(slot->advance.x, shape);
    require(glyph.advance_px >= 0, shape + " running backwards");
    FT_BBox box;
    FT_Outline_Get_CBox(&slot->outline, &box);
    for (const FT_Pos side : {box.xMin, box.xMax, box.yMin, box.yMax}) (void)pixels(side, shape);
    check(FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL), "damage in " + shape);
    copy(slot->bitmap, shape, glyph);
    glyph.left_px = slot->bitmap_left;
    glyph.top_px = ascent_px_ - slot->bitmap_top;
    glyphs.push_back(std::move(glyph));
  }

 private:
  static bool is_sfnt(std::string_view bytes) {
    using namespace std::string_view_literals;
    return bytes.starts_with("\0\1\0\0"sv) || bytes.starts_with("OTTO") || bytes.starts_with("true") ||
           bytes.starts_with("ttcf");
  }

  void require(bool good, const std::string& found) const {
    if (!good)
      throw input_error(
          {.file = file_, .field = "font", .wanted = "a TrueType or OpenType font", .found = found});
  }

  void check(FT_Error error, const std::string& found) const {
    if ((error & 0xff) == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    require(error == 0, found);
  }

  /// Rounded, and never farther than any letter reaches.
  [[nodiscard]] int pixels(FT_Pos units, const std::string& of) const {
    const FT_Pos most = FT_Pos{largest_shape_em} * size_px_ * units_in_pixel;
    require(units >= -most && units <= most, of + fmt::format(" reaching over {} sizes", largest_shape_em));
    return static_cast<int>((units + (units < 0 ? -units_in_pixel : units_in_pixel) / 2) / units_in_pixel);
  }

  void copy(const FT_Bitmap& bitmap, const std::string& shape, Glyph& glyph) const {
    if (bitmap.width == 0 || bitmap.rows == 0) return;
    const auto most = static_cast<unsigned>(2 * largest_shape_em * size_px_ + 2);
    require(bitmap.pixel_mode == FT_PIXEL_MODE_GRAY && bitmap.buffer != nullptr && bitmap.width <= most &&
                bitmap.rows <= most && static_cast<unsigned>(std::abs(bitmap.pitch)) >= bitmap.width,
            "damage in " + shape);
    glyph.width_px = static_cast<int>(bitmap.width);
    glyph.height_px = static_cast<int>(bitmap.rows);
    // A negative pitch: the buffer begins with the lowest row.
    const unsigned char* row = bitmap.buffer;
    if (bitmap.pitch < 0) row -= std::ptrdiff_t{bitmap.pitch} * (glyph.height_px - 1);
    for (int y = 0; y < glyph.height_px; ++y, row += bitmap.pitch)
      glyph.coverage.insert(glyph.coverage.end(), row, row + bitmap.width);
  }

  const std::string& file_;
  int size_px_;
  int ascent_px_ = 0;
  Library library_{nullptr, &FT_Done_FreeType};
  Face face_{nullptr, &FT_Done_Face};
};

}  // namespace

std::vector<Glyph> glyphs_of(std::string_view bytes, const std::string& file, std::u32string characters,
                             int size_px) {
  std::sort(characters.begin(), characters.end());
  characters.erase(std::unique(characters.begin(), characters.end()), characters.end());
  const OpenFont font(bytes, file, size_px);
  std::vector<Glyph> glyphs;
  for (const char32_t character : characters) font.add(character, glyphs);
  return glyphs;
}

}  // namespace seamline::inline window
