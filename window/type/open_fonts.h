#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "window/type/find_font.h"
#include "window/type/paragraph.h"

namespace seamline::inline window {

/// The font that is wanted, then those installed here of every script of the texts.
[[nodiscard]] std::vector<FontFiles> files_for(const FontFiles& wanted, std::span<const std::string> texts);

/// Opens those that stand at one place of each family. Throws InputError when a file is no font.
[[nodiscard]] FontStack open_fonts(std::span<const FontFiles> files, std::filesystem::path FontFiles::*which);

/// Throws InputError when no font has a character of the text, naming its script and a package with a font,
/// or when a shape of the text is damaged.
void require_shapes(const TypeStyle& style, std::string_view text);

}  // namespace seamline::inline window
