// A font of a study: texts of several scripts are shaped and drawn with it, as the window does. The first
// byte of the input chooses the size of the type.
#include "fuzz/fuzz_target.h"
#include "window/type/paragraph.h"
#include "window/type/text_direction.h"

namespace {

using namespace seamline;

void set_and_draw(const FontStack& fonts, double size_px, const char* language, std::string_view text) {
  const TypeStyle style{.fonts = &fonts,
                        .size_px = size_px,
                        .language = language,
                        .right_to_left = runs_right_to_left(language)};
  constexpr int most_width_px = 600;
  const double highest_px = 8 * largest_shape_em * style.em_px() + 8;
  for (const TextLine& line : arrange(style, text, 300).lines) {
    const Coverage drawn = draw_line(style, line, most_width_px);
    const auto area = static_cast<std::size_t>(drawn.width_px) * static_cast<std::size_t>(drawn.height_px);
    if (drawn.values.size() != area || drawn.width_px > most_width_px + size_px + 1 ||
        drawn.height_px > highest_px || !(line.width_px >= 0))
      abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return -1;
  const auto bytes = std::make_shared<const std::string>(fuzz::text_of(data + 1, size - 1));
  const double size_px = 4 + data[0] % 64;
  return fuzz::only_input_errors([&] {
    FontStack fonts;
    fonts.emplace_back(FontBytes{bytes, "font.ttf", data[0] >= 128});
    std::string latin;
    for (char letter = ' '; letter <= '~'; ++letter) latin += letter;
    set_and_draw(fonts, size_px, "en", latin + " Größe Ωμέγα Привет fi ffl ABC");
    set_and_draw(fonts, size_px, "ar", "أوافق على المشاركة (1) Esc לא");
    set_and_draw(fonts, size_px, "hi", "हिन्दी क्षत्रिय में");
    set_and_draw(fonts, size_px, "th", "ที่นี่น้ำ 日本");
  });
}
