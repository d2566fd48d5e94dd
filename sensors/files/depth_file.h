#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {

/// How the whole numbers of a PNG stand for depths.
enum class DepthPacking {
  whole,     ///< one channel of 16 bits
  red_green  ///< 8-bit colour: 256 red + green, as paper 002 (section 6) stores them; blue is not looked at
};

/// What a depth file does not say of itself and its reader must state.
struct DepthFileForm {
  PinholeCamera camera;  ///< of the file's own size
  DepthConvention convention = DepthConvention::planar;
  std::optional<double>
      metres_per_step;  ///< of whole numbers required; of EXR: metres per unit, 1 if not given
  DepthPacking packing = DepthPacking::whole;
  double nearest_m = 0, farthest_m = 1e9;  ///< what lies outside reads as holes
  bool unusual_distances = false;          ///< a median below 0.05 m or above 500 m is meant
};

struct DepthFile {
  DepthFrame frame;
  std::int64_t holes = 0;  ///< pixels without a depth: 0, negative, no number, out of range
};

/// Reads a depth map: EXR with one channel of float; PNG or binary PGM with 16 bits; 16 bits in two channels
/// of an 8-bit PNG. Whole numbers are read raw, never through a display curve.
///
/// Throws InputError, one sentence each: no such file, another kind of file, damaged or cut; another size or
/// aspect than the camera's; 8 bits where 16 are wanted; several channels where one is wanted; no
/// `metres_per_step` for whole numbers; nothing but holes; a median depth below 0.05 m or above 500 m, which
/// says what to give instead, unless `unusual_distances` is set.
[[nodiscard]] DepthFile read_depth_file(const std::filesystem::path& path, const DepthFileForm& form);

}  // namespace seamline::sensors
