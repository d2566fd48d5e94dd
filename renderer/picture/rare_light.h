#pragma once
#include "renderer/picture/pixel_sums.h"

namespace seamline::renderer {

/// On how few pixels a stimulus' estimated noise hangs: the share of it that one pixel in five hundred (at
/// least four) has. Noise of sampled light lies all over a picture; light that only a few paths find, as what
/// a mirror casts or a lamp lights beside it, is in a few pixels that are far too bright, and other pixels
/// have not met it yet. Then the estimated error is itself a guess, and more often too low than too high.
[[nodiscard]] double rare_light_share(const StimulusSums& sums, const Image& whole, double exposure_ev,
                                      int threads = 1);

/// Above this share a set says that a stimulus' estimated error is not to be relied on.
inline constexpr double much_rare_light = 0.2;

}  // namespace seamline::renderer
