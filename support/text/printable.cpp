#include "support/text/printable.h"

#include <fmt/format.h>

namespace seamline {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// What stands at one place of a text: a character, or one byte that belongs to none.
struct Letter {
  char32_t code = 0;
  std::string_view bytes;
  bool is_utf8 = true;
};

/// RFC 3629, table 3-7 of the Unicode Standard: how long a character is, and what its second byte may be.
Letter letter_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const Letter broken{.code = first, .bytes = text.substr(at, 1), .is_utf8 = false};
  if (first < 0x80) return {.code = first, .bytes = text.substr(at, 1)};
  if (first < 0xC2 || first > 0xF4) return broken;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() - at < length) return broken;
  const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(at + 1) < least || byte(at + 1) > most) return broken;
  char32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) return broken;
    code = code << 6 | (byte(at + i) & 0x3FU);
  }
  return {.code = code, .bytes = text.substr(at, length)};
}

/// Control characters, line and paragraph separators, marks that turn the direction of whatever follows, and
/// codes that are no characters. Joiners and plain direction marks, which scripts need, are none of them.
bool is_shown(const Letter& letter) {
  const char32_t c = letter.code;
  if (!letter.is_utf8 || c < 0x20 || (c >= 0x7F && c < 0xA0)) return false;
  if (c == 0x2028 || c == 0x2029 || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069))
    return false;
  return c != 0xFEFF && (c < 0xFFF9 || c > 0xFFFB) && (c & 0xFFFEU) != 0xFFFE && (c < 0xFDD0 || c > 0xFDEF);
}

std::string written_out(const Letter& letter) {
  if (letter.code == '\n') return "\\n";
  if (letter.code == '\t') return "\\t";
  if (letter.code == '\r') return "\\r";
  if (!letter.is_utf8 || letter.code < 0x80)
    return fmt::format("\\x{:02X}", static_cast<unsigned>(letter.code));
  return fmt::format("\\u{{{:04X}}}", static_cast<unsigned>(letter.code));
}

std::string in_a_line(const Letter& letter) {
  return is_shown(letter) ? std::string(letter.bytes) : written_out(letter);
}

std::string in_a_document(const Letter& letter) {
  const bool stays = is_shown(letter) || letter.code == '\n' || letter.code == '\t' || letter.code == '\r';
  return std::string(stays ? letter.bytes : replacement);
}

/// Where `letters` characters before the end begin; at least `begin`.
std::size_t start_of_last(std::string_view text, std::size_t letters, std::size_t begin) {
  std::size_t at = text.size();
  for (; letters > 0 && at > begin; --letters) {
    --at;
    for (int i = 0; i < 3 && at > begin && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; ++i) --at;
  }
  return at;
}

template <class Write>
std::string shown(std::string_view text, std::size_t most_letters, const Write& write) {
  // Where the first two thirds of what may stay end is known when the text turns out to be too long.
  const std::size_t first_letters = most_letters - most_letters / 3;
  std::size_t letters = 0, at = 0, first_end = 0, first_written = 0;
  std::string out;
  while (at < text.size() && letters <= most_letters) {
    if (letters == first_letters) first_end = at, first_written = out.size();
    const Letter letter = letter_at(text, at);
    out += write(letter);
    at += letter.bytes.size();
    ++letters;
  }
  if (letters <= most_letters) return out;
  out.resize(first_written);
  const std::size_t last = start_of_last(text, most_letters / 3, first_end);
  out += fmt::format("[... {} bytes ...]", last - first_end);
  for (at = last; at < text.size();) {
    const Letter letter = letter_at(text, at);
    out += write(letter);
    at += letter.bytes.size();
  }
  return out;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most_letters) {
  return shown(text, most_letters, in_a_line);
}

std::string clean_text(std::string_view text, std::size_t most_letters) {
  return shown(text, most_letters, in_a_document);
}

bool is_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Letter letter = letter_at(text, at);
    if (!letter.is_utf8) return false;
    at += letter.bytes.size();
  }
  return true;
}

}  // namespace seamline
