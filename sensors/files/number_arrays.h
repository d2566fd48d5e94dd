#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

#include "sensors/files/raw_depth.h"

namespace seamline::sensors {

/// Arrays of numbers without a picture's packing, by the bytes that a file begins with.
enum class ArrayKind { none, pfm, npy, dpt };
[[nodiscard]] ArrayKind array_kind(std::string_view start);

/// Reads an array raw: PFM ("Pf", or "PF" with three equal channels; rows from the bottom; the sign of its
/// scale is the byte order), NumPy's NPY (versions 1 to 3; real numbers of 1 to 8 bytes in either order; two
/// axes that are longer than 1, rows first), or Sintel's DPT. `accept` sees everything but the values first.
/// Throws InputError naming the file where it is cut, is longer than it says, or holds something else.
[[nodiscard]] RawDepth read_array(const std::filesystem::path& path, ArrayKind kind,
                                  const std::function<void(const RawDepth&)>& accept);

}  // namespace seamline::sensors
