#pragma once
#include <string>

#include "support/files/image.h"

namespace seamline::renderer {

/// A 32 x 32 tile of a picture, the same tile of its reference, and eight times their difference about mid
/// grey, side by side and each enlarged eight times, with a line of text under them. Both pictures are 8-bit
/// sRGB of the same size.
[[nodiscard]] ByteImage worst_tile_picture(const ByteImage& shown, const ByteImage& reference, int tile,
                                           const std::string& caption);

}  // namespace seamline::renderer
