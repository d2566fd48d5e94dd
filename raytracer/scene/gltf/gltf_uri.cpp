#include "raytracer/scene/gltf/gltf_uri.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace seamline::renderer {
namespace {

constexpr std::string_view data_scheme = "data:";

int hexadecimal_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string without_percent_codes(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hexadecimal_digit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexadecimal_digit(text[i + 2]) : -1;
    out += low >= 0 ? static_cast<char>(high * 16 + low) : text[i];
    if (low >= 0) i += 2;
  }
  return out;
}

bool starts_with_any_case(std::string_view text, std::string_view lower_case) {
  return text.size() >= lower_case.size() &&
         std::equal(lower_case.begin(), lower_case.end(), text.begin(),
                    [](char wanted, char c) { return wanted == (c >= 'A' && c <= 'Z' ? c + 32 : c); });
}

/// Six bits of base64; -1 for what is no letter of it.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::optional<std::string> base64_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '=') continue;
    const int digit = base64_digit(c);
    if (digit < 0) return std::nullopt;
    bits = (bits << 6U) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    out += static_cast<char>((bits >> static_cast<unsigned>(count)) & 0xFFU);
  }
  return out;
}

}  // namespace

std::string file_of_uri(const std::string& uri) {
  std::string name = without_percent_codes(uri);
  std::replace(name.begin(), name.end(), '\\', '/');
  if (name.find('\0') != std::string::npos) return name;
  return std::filesystem::path(name).lexically_normal().string();
}

bool is_data_uri(std::string_view uri) {
  return starts_with_any_case(uri, data_scheme);
}

std::optional<std::string> data_of_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
  const std::string_view kind = uri.substr(0, comma), data = uri.substr(comma + 1);
  const std::size_t last_part = kind.rfind(';');
  const bool is_base64 =
      last_part != std::string_view::npos && starts_with_any_case(kind.substr(last_part), ";base64");
  const bool is_coded = data.find('%') != std::string_view::npos;
  if (!is_base64) return without_percent_codes(data);
  return is_coded ? base64_decoded(without_percent_codes(data)) : base64_decoded(data);
}

}  // namespace seamline::renderer
