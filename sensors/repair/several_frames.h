#pragma once
#include <span>
#include <string>

#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {

/// One frame of several moments in which nothing moved: each pixel the mean of the middle half of its values
/// (a quarter of them, rounded down, is left out at either end), so that single wild ones do not count. Noise
/// falls with the root of their number. A pixel that fewer than half of the frames measured is a hole. One
/// frame alone stays as it is, bit for bit; amplitudes and confidences are the first one's. The same bytes
/// for any number of threads (0: one for each core) and any order of the frames.
///
/// Throws InputError naming `where` for none, and for frames of other cameras or conventions than the first.
[[nodiscard]] DepthFrame mean_of_frames(std::span<const DepthFrame> frames, const std::string& where,
                                        int threads = 0);

}  // namespace seamline::sensors
