#pragma once
#include <vector>

#include "support/files/image.h"

namespace seamline::registration {

struct StereoMatching {
  int disparities_px = 64;  ///< searched from 0; a multiple of 16
  int block_px = 5;         ///< side of the compared blocks; odd
};

/// How far each pixel of the left picture lies to the left in the right one, in pixels to a sixteenth, by
/// semi-global matching along eight ways (Hirschmueller 2008, with the block costs of Birchfield and Tomasi:
/// OpenCV's StereoSGBM). Checked from the right, and without specks; no number where nothing was found. Both
/// pictures are rectified, of one size and three channels. The same for any number of threads.
///
/// Throws InputError where the program was built without OpenCV.
[[nodiscard]] std::vector<float> match_stereo(const ByteImage& left, const ByteImage& right,
                                              const StereoMatching& matching);

}  // namespace seamline::registration
