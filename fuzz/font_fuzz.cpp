// A font of a study, as the window opens it. The first byte of the input chooses the size of the type.
#include "fuzz/fuzz_target.h"
#include "window/glyphs.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  if (size == 0) return -1;
  const std::string_view bytes = fuzz::text_of(data + 1, size - 1);
  const int size_px = 4 + data[0] % 128;
  std::u32string characters;
  for (char32_t character = 0x20; character < 0x180; ++character) characters += character;
  return fuzz::only_input_errors([&] {
    for (const Glyph& glyph : glyphs_of(bytes, "font.ttf", characters, size_px)) {
      const auto area = static_cast<std::size_t>(glyph.width_px) * static_cast<std::size_t>(glyph.height_px);
      const int most = (2 * largest_shape_em + 1) * size_px;
      if (glyph.coverage.size() != area || glyph.width_px > most || glyph.height_px > most ||
          glyph.advance_px < 0 || glyph.advance_px > most || std::abs(glyph.left_px) > most ||
          std::abs(glyph.top_px) > most)
        abort();
    }
  });
}
