#include "support/codec/exr_header.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline {
namespace {

constexpr std::int64_t fixed_part_bytes = 8;  ///< magic number, version and flags
constexpr std::uint32_t multi_part_flag = 0x1000;
constexpr std::size_t longest_name_bytes = 255;
constexpr std::int64_t farthest_corner_px = 1 << 29;  // differences of two fit an int

/// The headers as a run of little-endian numbers and of texts that end with 0.
class HeaderBytes {
 public:
  explicit HeaderBytes(const std::filesystem::path& path)
      : path_(path),
        in_(path, std::ios::binary),
        size_(static_cast<std::int64_t>(std::filesystem::file_size(path))) {}

  std::uint32_t number() {
    std::uint32_t value = 0;
    for (unsigned byte = 0; byte < 4; ++byte) value |= std::uint32_t{next()} << 8 * byte;
    return value;
  }
  std::string name() {
    std::string text;
    for (unsigned char letter = next(); letter != 0; letter = next()) {
      text += static_cast<char>(letter);
      if (text.size() > longest_name_bytes) throw damaged("a name without end");
    }
    return text;
  }
  void skip(std::int64_t bytes) {
    if (bytes > size_ - at_)
      throw damaged("an attribute of " + std::to_string(bytes) + " bytes that leads out of it");
    at_ += bytes;
    in_.seekg(at_);
  }
  [[nodiscard]] std::int64_t at() const { return at_; }
  [[nodiscard]] InputError damaged(const std::string& found) const {
    return input_error({.file = path_.string(), .wanted = "a whole EXR file", .found = found});
  }

 private:
  unsigned char next() {
    const int byte = in_.get();
    if (byte < 0) throw damaged("one that ends in its header");
    ++at_;
    return static_cast<unsigned char>(byte);
  }

  std::filesystem::path path_;
  std::ifstream in_;
  std::int64_t at_ = 0, size_ = 0;
};

/// Types whose values have one size. The library reads that many bytes whatever the header says, and takes
/// what follows for the next attribute.
constexpr std::array<std::pair<std::string_view, std::int64_t>, 23> fixed_sizes = {{
    {"box2i", 16},
    {"box2f", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33f", 36},
    {"m33d", 72},
    {"m44f", 64},
    {"m44d", 128},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2i", 8},
    {"v2f", 8},
    {"v2d", 16},
    {"v3i", 12},
    {"v3f", 12},
}};

/// A list of channels ends where its attribute does: names, with 16 bytes each, until an empty one.
void skip_channels(HeaderBytes& header, std::int64_t bytes) {
  constexpr std::int64_t channel_bytes = 16;
  const std::int64_t end = header.at() + bytes;
  while (!header.name().empty()) header.skip(channel_bytes);
  if (header.at() != end) throw header.damaged("a list of channels of another length than it says");
}

void skip_value(HeaderBytes& header, const std::string& type, std::int64_t bytes) {
  if (type == "chlist") return skip_channels(header, bytes);
  for (const auto& [name, size] : fixed_sizes)
    if (type == name && bytes != size)
      throw header.damaged("a value of type " + type + " with " + std::to_string(bytes) + " bytes");
  header.skip(bytes);
}

/// The library takes memory for lines of this width before anybody can ask how wide they are.
void check_window(HeaderBytes& header) {
  std::array<std::int64_t, 4> corner{};  // least x, y, most x, y
  for (std::int64_t& place : corner) {
    place = static_cast<std::int32_t>(header.number());
    if (std::abs(place) > farthest_corner_px)
      throw header.damaged("a window with a corner at " + std::to_string(place));
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (const std::int64_t side = corner[axis + 2] - corner[axis] + 1;
        side < 1 || side > limits::largest_picture_side_px)
      throw header.damaged("a picture with a side of " + std::to_string(side) + " pixels");
}

/// One part's attributes; whether there were any.
bool check_part(HeaderBytes& header) {
  bool any = false;
  for (std::string name = header.name(); !name.empty(); name = header.name()) {
    const std::string type = header.name();
    const std::int64_t bytes = header.number();
    if ((name == "dataWindow" || name == "displayWindow") && type == "box2i" && bytes == 16)
      check_window(header);
    else
      skip_value(header, type, bytes);
    any = true;
  }
  return any;
}

}  // namespace

void check_exr_header(const std::filesystem::path& path) {
  HeaderBytes header(path);
  header.skip(fixed_part_bytes - 4);
  const bool many = (header.number() & multi_part_flag) != 0;
  while (check_part(header) && many) {
  }
}

}  // namespace seamline
