#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sensors/files/depth_file.h"

namespace seamline::sensors {

/// A depth map's values as its file has them; which metres they stand for the file does not say.
struct RawDepth {
  int width_px = 0, height_px = 0;
  std::vector<float> values;  ///< rows from the top
  bool whole = false;         ///< whole numbers
  int bits = 0;               ///< of each
  std::size_t beyond = 0;     ///< pixels outside of an EXR file's data window: no number
  std::vector<std::string> notes;
};

/// What of a file is depth, where it does not say it itself.
struct RawDepthForm {
  std::string channel = {};  ///< empty: by its name
  DepthPacking packing = DepthPacking::whole;
  bool eight_bits = false;  ///< are enough: estimates are often written so
};

/// Reads EXR, PNG, binary PGM, TIFF, PFM, NPY or DPT, by the first bytes. `accept` sees size and kind before
/// memory is taken and throws InputError at what is not wanted. Throws InputError naming the file: no such
/// file, another kind, damaged or cut; several channels none of which is depth by its name, or colours whose
/// red, green and blue differ; 8 bits where they are not enough.
[[nodiscard]] RawDepth read_raw_depth(const std::filesystem::path& path, const RawDepthForm& form,
                                      const std::function<void(const RawDepth&)>& accept = {});

}  // namespace seamline::sensors
