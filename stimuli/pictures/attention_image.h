#pragma once
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// The picture of an attention trial: the reference with one object's pixels changed so that nobody who looks
/// can miss it, as if its insertion had gone wrong. Needs no rendering.
///
/// `reference`: sRGB codes, 3 channels; `object_ids`: 1 channel of the same size, 0 background,
/// objects from 1. Everything outside the object keeps its bytes. Throws InputError when the sizes differ
/// or the object has no pixel.
[[nodiscard]] ByteImage attention_image(const ByteImage& reference, const ByteImage& object_ids,
                                        int object_index);

}  // namespace seamline::inline stimuli
