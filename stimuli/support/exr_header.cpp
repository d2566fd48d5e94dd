#include "stimuli/support/exr_header.h"

#include <cstdint>
#include <fstream>
#include <string>

#include "stimuli/support/error.h"

namespace seamline {
namespace {

constexpr std::int64_t fixed_part_bytes = 8;  ///< magic number, version and flags
constexpr std::uint32_t multi_part_flag = 0x1000;
constexpr std::size_t longest_name_bytes = 255;

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

/// One part's attributes; whether there were any.
bool check_part(HeaderBytes& header) {
  bool any = false;
  while (!header.name().empty()) {
    (void)header.name();  // its type
    header.skip(header.number());
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
