// A TrueType font of our own: squares for the letters A, B and C, nothing for the space.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace seamline::test {

/// Bytes of a font file, most significant first.
struct FontBytes {
  std::string text;

  FontBytes& u8(unsigned value) {
    text += static_cast<char>(value);
    return *this;
  }
  FontBytes& u16(unsigned value) { return u8(value >> 8U & 255U).u8(value & 255U); }
  FontBytes& s16(int value) { return u16(static_cast<unsigned>(value) & 0xffffU); }
  FontBytes& u32(std::uint32_t value) { return u16(value >> 16U).u16(value & 0xffffU); }
  FontBytes& zeros(int count) {
    text.append(static_cast<std::size_t>(count), '\0');
    return *this;
  }
};

inline constexpr int small_font_em = 1000, small_font_glyphs = 5;  // none, space, A, B, C

/// The outline of a square from (0, 0) to (side, side).
inline std::string square_outline(int side) {
  FontBytes out;
  out.s16(1).s16(0).s16(0).s16(side).s16(side);  // contours, box
  out.u16(3).u16(0);                             // last point, no instructions
  for (int i = 0; i < 4; ++i) out.u8(1);         // points on the curve, with 16-bit steps
  for (const int step : {0, 0, side, 0}) out.s16(step);
  for (const int step : {0, side, 0, -side}) out.s16(step);
  return out.text;
}

/// The whole file. A's square has 700 units, B's 500, C is A and B together.
inline std::string small_font() {
  const std::string a = square_outline(700), b = square_outline(500);
  FontBytes composite;
  composite.s16(-1).s16(0).s16(0).s16(700).s16(700);
  composite.u16(0x0023).u16(2).s16(0).s16(0);      // word offsets, they are offsets, more: A
  composite.u16(0x0003).u16(3).s16(100).s16(100);  // B
  const std::vector<std::string> shapes = {a, "", a, b, composite.text};
  FontBytes loca, glyf, hmtx;
  for (const std::string& shape : shapes) {
    loca.u32(static_cast<std::uint32_t>(glyf.text.size()));
    glyf.text += shape;
    while (glyf.text.size() % 4 != 0) glyf.u8(0);
    hmtx.u16(800).s16(0);
  }
  loca.u32(static_cast<std::uint32_t>(glyf.text.size()));
  FontBytes head, hhea, maxp, cmap, name, post;
  head.u32(0x00010000).u32(0x00010000).u32(0).u32(0x5F0F3CF5).u16(3).u16(small_font_em).zeros(16);
  head.s16(0).s16(0).s16(700).s16(700).u16(0).u16(8).s16(2).s16(1).s16(0);  // long offsets
  hhea.u32(0x00010000).s16(800).s16(-200).s16(0).u16(800).s16(0).s16(0).s16(700).s16(1).zeros(14);
  hhea.u16(small_font_glyphs);
  maxp.u32(0x00010000).u16(small_font_glyphs).u16(16).u16(4).u16(16).u16(4).u16(2).zeros(14).u16(2).u16(2);
  cmap.u16(0).u16(1).u16(3).u16(1).u32(12);  // Windows, Unicode
  cmap.u16(4).u16(40).u16(0).u16(6).u16(4).u16(1).u16(2);
  cmap.u16(0x20).u16(0x43).u16(0xFFFF).u16(0);
  cmap.u16(0x20).u16(0x41).u16(0xFFFF);
  cmap.s16(1 - 0x20).s16(2 - 0x41).s16(1).u16(0).u16(0).u16(0);
  name.u16(0).u16(0).u16(6);
  post.u32(0x00030000).zeros(28);
  const std::vector<std::pair<std::string, std::string>> tables = {
      {"cmap", cmap.text}, {"glyf", glyf.text}, {"head", head.text}, {"hhea", hhea.text}, {"hmtx", hmtx.text},
      {"loca", loca.text}, {"maxp", maxp.text}, {"name", name.text}, {"post", post.text}};
  FontBytes file, body;
  file.u32(0x00010000).u16(static_cast<unsigned>(tables.size())).u16(128).u16(3).u16(16);
  const std::size_t begin = 12 + 16 * tables.size();
  for (const auto& [tag, text] : tables) {
    file.text += tag;
    file.u32(0).u32(static_cast<std::uint32_t>(begin + body.text.size()));
    file.u32(static_cast<std::uint32_t>(text.size()));
    body.text += text;
    while (body.text.size() % 4 != 0) body.u8(0);
  }
  return file.text + body.text;
}

}  // namespace seamline::test
