#pragma once
#include <cstdint>
#include <string>
#include <string_view>

/// The parts that PNG files are made of, as they are written down in ISO/IEC 15948.
namespace seamline::test {

inline std::uint32_t png_sum(std::string_view bytes) {
  std::uint32_t sum = 0xffffffffU;
  for (const char letter : bytes) {
    sum ^= static_cast<unsigned char>(letter);
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? sum >> 1 ^ 0xedb88320U : sum >> 1;
  }
  return ~sum;
}

inline std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

inline std::string png_part(const std::string& kind, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + kind + data + big_endian(png_sum(kind + data));
}

inline const std::string png_signature = "\x89PNG\r\n\x1a\n";

/// `header`: bits, colour, and whether it is interlaced.
inline std::string png_head(std::uint32_t width_px, std::uint32_t height_px, const std::string& header) {
  return png_signature + png_part("IHDR", big_endian(width_px) + big_endian(height_px) + header.substr(0, 2) +
                                              std::string(2, '\0') + header.substr(2));
}

}  // namespace seamline::test
