#pragma once
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// FLIP as a picture for people: from black (0) over violet and orange to pale yellow (1), evenly brighter.
/// `flip` has one channel.
[[nodiscard]] ByteImage flip_map(const Image& flip);

}  // namespace seamline::inline stimuli
