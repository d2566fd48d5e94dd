#include "window/type/open_fonts.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "window/type/characters.h"

namespace seamline::inline window {

std::vector<FontFiles> files_for(const FontFiles& wanted, std::span<const std::string> texts) {
  std::set<Script> scripts;
  for (const std::string& text : texts)
    for (const Script script : scripts_of(characters_of(text))) scripts.insert(script);
  std::vector<FontFiles> files = {wanted};
  for (const Script script : scripts)
    for (const FontFiles& font : fonts_of_script(script))
      if (std::none_of(files.begin(), files.end(), [&](const FontFiles& f) { return f.text == font.text; }))
        files.push_back(font);
  return files;
}

FontStack open_fonts(std::span<const FontFiles> files, std::filesystem::path FontFiles::*which) {
  FontStack fonts;
  for (const FontFiles& file : files) {
    const std::filesystem::path& path = file.*which;
    fonts.emplace_back(
        FontBytes{.bytes = std::make_shared<const std::string>(read_file(path, largest_font_bytes)),
                  .file = path.string(),
                  .emboldened = which == &FontFiles::heading && file.bold_is_drawn});
  }
  return fonts;
}

void require_shapes(const TypeStyle& style, std::string_view text) {
  for (const std::u32string& line : lines_of(text))
    if (const std::u32string missing = missing_characters(*style.fonts, line); !missing.empty()) {
      const auto [name, package] = font_to_install(scripts_of(line).at(line.find(missing.front())));
      throw input_error({.field = "session.font",
                         .wanted = fmt::format(
                             "a font with every character of the study's texts (with {} letters: Debian's "
                             "{}, or a file that the study names)",
                             name, package),
                         .found = fmt::format("none with U+{:04X}", static_cast<unsigned>(missing.front()))});
    }
  std::set<std::pair<std::size_t, std::uint32_t>> seen;
  for (const TextLine& line : arrange(style, text, 0).lines)
    for (const PlacedGlyph& glyph : line.glyphs)
      if (seen.emplace(glyph.font, glyph.number).second)
        (void)(*style.fonts)[glyph.font].outlines.frame(glyph.number, style.em_px(), 0);
}

}  // namespace seamline::inline window
