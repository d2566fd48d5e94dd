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
  fuzz::only_input_errors([&] {
    const Image image = read_image(file);
    if (image.values.size() != image.index(0, image.height_px)) abort();
  });
  fuzz::only_input_errors([&] { (void)read_depth_map(file); });
  return fuzz::only_input_errors([&] { (void)read_bytes_image(file); });
}
