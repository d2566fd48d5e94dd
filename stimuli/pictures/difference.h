#pragma once
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// Root mean square difference of two linear pictures in display units (0 to 1, after exposure and the sRGB
/// curve), over the pixels where `mask` is above 0.5, or over all when `mask` is null. Sizes must agree.
[[nodiscard]] double display_rmse(const Image& a, const Image& b, double exposure_ev,
                                  const Image* mask = nullptr);

/// Share of channel values that display white cannot show (linear * 2^exposure_ev above 1).
[[nodiscard]] double clipped_share(const Image& linear, double exposure_ev);

}  // namespace seamline::inline stimuli
