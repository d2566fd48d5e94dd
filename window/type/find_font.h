#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "window/type/shaping.h"

namespace seamline::inline window {

/// A font, and the one that headings are set in.
struct FontFiles {
  std::filesystem::path text, heading;
  bool bold_is_drawn = false;  ///< there is no bold one: headings are drawn so
};

/// The type that texts are set in.
struct FontRequest {
  FontFiles files;
  double body_px = 22;                  ///< from the lowest to the highest letter
  std::string language = "en";          ///< of the texts, a tag of BCP 47: says in which direction they run
  std::vector<std::string> texts = {};  ///< UTF-8: what will be shown, apart from numbers
};

/// A TrueType file for the study's texts: `wanted` when it is not empty, else the first of Debian's that is
/// there. Throws InputError when there is none.
[[nodiscard]] FontRequest find_font(const std::filesystem::path& wanted);

/// The fonts of a writing system that are installed here, and may have letters that `find_font`'s lacks.
[[nodiscard]] std::vector<FontFiles> fonts_of_script(Script script);

/// What a writing system is called, and the Debian package of a font with its letters.
struct ScriptFont {
  std::string name, package;
};
[[nodiscard]] ScriptFont font_to_install(Script script);

}  // namespace seamline::inline window
