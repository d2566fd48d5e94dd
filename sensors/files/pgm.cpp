#include "sensors/files/pgm.h"

#include <fmt/core.h>

#include <array>
#include <fstream>
#include <string>

#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::sensors {
namespace {

constexpr std::int64_t longest_header_bytes = 65536;

class PgmBytes {
 public:
  explicit PgmBytes(const std::filesystem::path& path) : path_(path), in_(path, std::ios::binary) {}

  [[nodiscard]] InputError damaged(const std::string& found) const {
    return input_error({.file = path_.string(), .wanted = "a whole PGM file (P5)", .found = found});
  }

  void signature() {
    if (next() != 'P' || next() != '5') throw damaged("another kind of file");
  }

  /// The next number of the header: after white space and comments, which run from # to the line's end.
  int number(const char* what, int largest) {
    int letter = next();
    while (is_space(letter) || letter == '#') {
      if (letter == '#')
        while (letter != '\n' && letter != '\r') letter = next();
      letter = next();
    }
    int value = 0;
    int digits = 0;
    for (; letter >= '0' && letter <= '9'; letter = next(), ++digits) {
      value = value * 10 + (letter - '0');
      if (value > largest) throw damaged(fmt::format("one whose {} is above {}", what, largest));
    }
    if (digits == 0 || !is_space(letter)) throw damaged(fmt::format("one without a {}", what));
    if (value < 1) throw damaged(fmt::format("one whose {} is 0", what));
    return value;
  }

  std::string pixels(std::int64_t wanted_bytes) {
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path_));
    if (size - at_ != wanted_bytes)
      throw damaged(
          fmt::format("one with {} bytes of pixels where its header says {}", size - at_, wanted_bytes));
    std::string bytes(wanted_bytes, '\0');
    in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!in_) throw damaged("one that cannot be read");
    return bytes;
  }

 private:
  static bool is_space(int letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }
  int next() {
    const int letter = at_ < longest_header_bytes ? in_.get() : -1;
    if (letter < 0) throw damaged("one that ends in its header");
    ++at_;
    return letter;
  }

  std::filesystem::path path_;
  std::ifstream in_;
  std::int64_t at_ = 0;
};

}  // namespace

bool is_pgm(const std::filesystem::path& path) {
  std::array<char, 2> start{};
  std::ifstream in(path, std::ios::binary);
  in.read(start.data(), start.size());
  return in && start[0] == 'P' && start[1] == '5';
}

Pgm read_pgm(const std::filesystem::path& path, const std::function<void(const Pgm&)>& accept) {
  if (!std::filesystem::is_regular_file(path))
    throw input_error({.file = path.string(), .wanted = "a PGM file (P5)", .found = "no such file"});
  PgmBytes file(path);
  file.signature();
  Pgm pgm;
  pgm.width_px = file.number("width", limits::largest_picture_side_px);
  pgm.height_px = file.number("height", limits::largest_picture_side_px);
  pgm.largest = file.number("maximum", 65535);
  if (accept) accept(pgm);
  const std::size_t count = static_cast<std::size_t>(pgm.width_px) * static_cast<std::size_t>(pgm.height_px);
  const std::size_t each = pgm.largest > 255 ? 2 : 1;
  const std::string bytes = file.pixels(static_cast<std::int64_t>(count * each));
  pgm.values.resize(count);
  const auto byte = [&](std::size_t at) {
    return static_cast<unsigned>(static_cast<unsigned char>(bytes[at]));
  };
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned value = each == 2 ? byte(2 * i) << 8 | byte(2 * i + 1) : byte(i);
    if (value > static_cast<unsigned>(pgm.largest))
      throw file.damaged(fmt::format("one with a value of {} above its own maximum, {}", value, pgm.largest));
    pgm.values[i] = static_cast<std::uint16_t>(value);
  }
  return pgm;
}

}  // namespace seamline::sensors
