#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace seamline {

/// A PNG's integers as they lie in the file: no display curve, no scaling, no alpha multiplied in.
struct WordImage {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  int bits = 0;                       ///< of each value: 8 or 16 (fewer are spread to 8)
  std::vector<std::uint16_t> values;  ///< height_px * width_px * channels, rows from the top
};

/// Reads a PNG raw: what is measured and not looked at. `accept` sees everything but the values first and
/// throws InputError at a picture that is not wanted, so that no memory is taken for it. Throws InputError
/// naming the file, also where it is no PNG.
[[nodiscard]] WordImage read_word_image(const std::filesystem::path& path,
                                        const std::function<void(const WordImage&)>& accept = {});

}  // namespace seamline
