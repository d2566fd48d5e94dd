#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace seamline::sensors {

/// A greyscale picture of whole numbers as its file has them.
struct Pgm {
  int width_px = 0;
  int height_px = 0;
  int largest = 0;                    ///< the file's own maximum; above 255 a value has 16 bits
  std::vector<std::uint16_t> values;  ///< rows from the top
};

/// Whether a file begins like a binary PGM ("P5").
[[nodiscard]] bool is_pgm(const std::filesystem::path& path);

/// Reads a binary PGM (netpbm's P5; 16 bits are big-endian), raw. `accept` sees the header first and throws
/// InputError at a picture that is not wanted. Throws InputError naming the file where it is damaged, has
/// fewer or more bytes than its header says, or a value above its own maximum.
[[nodiscard]] Pgm read_pgm(const std::filesystem::path& path,
                           const std::function<void(const Pgm&)>& accept = {});

}  // namespace seamline::sensors
