#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace seamline {

// Text that came from outside (a file, a log, the command line, a library) and is shown to somebody. Letters
// of every script stay as they are.

/// For one line of a terminal: what cannot be printed is written out (`\x1B`, `\n`, `\u{202E}`): control
/// characters, marks that turn the direction of what follows, and bytes that are no UTF-8. Of a text longer
/// than `most_letters` the beginning and the end stay, with the number of bytes left out between them.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most_letters = 300);

/// For documents (HTML, CSV, SVG): line ends and tabs stay; whatever else `printable` writes out becomes
/// U+FFFD. Shortened as by `printable`.
[[nodiscard]] std::string clean_text(std::string_view text, std::size_t most_letters = 10'000);

/// Whether `text` is UTF-8 (no surrogates, nothing longer than it needs to be).
[[nodiscard]] bool is_utf8(std::string_view text);

}  // namespace seamline
