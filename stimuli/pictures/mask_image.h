#pragma once
#include <cstdint>

#include "stimuli/definition/parts/task_definition.h"
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// What covers a picture's place after it (`TaskMask`), as sRGB codes of 3 channels in the size of the
/// reference. Noise: squares of 4 pixels, each of a grey from 0 to 255, all equally likely. Scrambled: the
/// reference's squares of 16 pixels in a random order; at the edges, where whole squares do not fit, those of
/// the same size change places with each other. The same seed and stream give the same bytes everywhere.
/// `mask` is not `none`.
[[nodiscard]] ByteImage mask_image(const ByteImage& reference, TaskMask mask, std::uint64_t seed,
                                   std::uint64_t stream);

}  // namespace seamline::inline stimuli
