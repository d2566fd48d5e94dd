// A depth map of another person: of which kind its first bytes say, of which size the camera is the input's
// last byte.
#include "fuzz/fuzz_target.h"
#include "sensors/files/depth_file.h"
#include "sensors/files/pgm.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  using namespace seamline::sensors;
  if (size == 0) return -1;
  const std::filesystem::path file = fuzz::file_of("depth", fuzz::text_of(data, size));
  if (size % 2 == 0 && is_pgm(file)) return fuzz::only_input_errors([&] { (void)read_pgm(file); });
  DepthFileForm form;
  form.camera = pinhole_of_field_of_view(2 + data[size - 1] % 14, 2 + data[size - 1] / 16, 60);
  form.metres_per_step = 0.001;
  if (size % 3 == 0) form.packing = DepthPacking::red_green;
  return fuzz::only_input_errors([&] {
    const DepthFile depth = read_depth_file(file, form);
    for (const float depth_m : depth.frame.depth_m)
      if (!(depth_m > 0)) abort();
  });
}
