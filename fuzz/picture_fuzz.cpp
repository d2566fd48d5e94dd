// A picture of one format, which is what the input becomes if it is not: SEAMLINE_FUZZ_MAGIC are the bytes
// that files of the format begin with.
#include <zlib.h>

#include <cstring>

#include "fuzz/fuzz_target.h"
#include "renderer/depth/depth_map.h"
#include "support/files/image.h"

namespace {

/// The sums of a PNG's parts put right in every other input, so that what comes after them is reached too.
void mend_png_sums(std::string& bytes) {
  const auto number_at = [&](std::size_t at) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
  };
  for (std::size_t at = 8; at + 12 <= bytes.size(); at += 12 + number_at(at)) {
    const std::size_t length = number_at(at);
    if (length > bytes.size() - at - 12) return;
    const auto* begin = reinterpret_cast<const unsigned char*>(bytes.data()) + at + 4;
    const auto sum = static_cast<std::uint32_t>(crc32(0, begin, static_cast<unsigned>(length + 4)));
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  using namespace seamline::renderer;
  constexpr std::string_view magic = SEAMLINE_FUZZ_MAGIC;
  std::string bytes(fuzz::text_of(data, size));
  if (bytes.size() < magic.size()) return -1;
  std::memcpy(bytes.data(), magic.data(), magic.size());
  if (magic.starts_with("\x89PNG") && size % 8 < 4) mend_png_sums(bytes);
  const std::filesystem::path file = fuzz::file_of("picture.exr", bytes);
  // One reader an input: the library takes 64 MB for each, and the sanitizer marks them all.
  return fuzz::only_input_errors([&] {
    if (size % 4 == 0) return void(read_bytes_image(file));
    if (size % 4 == 1) return void(read_depth_map(file));
    const Image image = read_image(file);
    if (image.values.size() != image.index(0, image.height_px)) abort();
  });
}
