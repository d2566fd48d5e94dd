// A picture of one format, which is what the input becomes if it is not: SEAMLINE_FUZZ_MAGIC are the bytes
// that files of the format begin with.
#include <cstring>

#include "fuzz/fuzz_target.h"
#include "renderer/depth_map.h"
#include "stimuli/support/image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  constexpr std::string_view magic = SEAMLINE_FUZZ_MAGIC;
  std::string bytes(fuzz::text_of(data, size));
  if (bytes.size() < magic.size()) return -1;
  std::memcpy(bytes.data(), magic.data(), magic.size());
  const std::filesystem::path file = fuzz::file_of("picture.exr", bytes);
  // One reader an input: the library takes 64 MB for each, and the sanitizer marks them all.
  return fuzz::only_input_errors([&] {
    if (size % 4 == 0) return void(read_bytes_image(file));
    if (size % 4 == 1) return void(read_depth_map(file));
    const Image image = read_image(file);
    if (image.values.size() != image.index(0, image.height_px)) abort();
  });
}
