#pragma once
#include <optional>

#include "renderer/picture/pixel_sums.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// A finished stimulus, in linear radiance.
struct Composite {
  Image picture;
  Image ratio;  ///< the factor on the background, 1 where nothing is multiplied
  TinyDenominators tiny_denominators;
};

/// The pixel formula of documentation/developers/design.md, section 2:
///   I = (1/N) [ sum_unc B_s * (sum_unc L_with / sum_unc L_no) + sum_cov L_obj ]
/// The ratio is of pixel sums, written 1 + (S_with - S_no) / S_no, clamped to 0..4, and 1 where S_no is under
/// 1e-6 of the frame's median. Where the depth mesh decides the light (questions 2 and 5) and S_no is poorly
/// lit (under 4 / N of the median, at least 2 % and at most 25 %: pockets that depth sheets seal, which only
/// a few paths find) both sums are taken from a filter along depth and normals. Elsewhere nothing is
/// filtered: with and without share their noise there, and the division cancels it. And where the depth mesh
/// is more than ten times darker than the photograph (against the frame's usual), the ratio is faded towards
/// 1 in proportion: sheets have sealed that surface in. How dark it is there is asked of the light before any
/// filter of bounce light (`light_as_sampled`), which carries light over a well's edge. Medians of large
/// pictures are taken over every few pixels.
[[nodiscard]] Composite compose(const StimulusSums& sums, Compositing compositing, int threads = 1);
/// As the sums say.
[[nodiscard]] inline Composite compose(const StimulusSums& sums) {
  return compose(sums, sums.compositing);
}

/// The same from one half of the samples only (0 or 1): what errors are estimated from.
[[nodiscard]] Composite compose_half(const StimulusSums& sums, std::size_t half, int threads = 1);

/// Estimated noise of the composite: half the difference of the pictures of its two halves of samples, root
/// mean square in display units (0 to 1). None when there is only one sample a pixel.
[[nodiscard]] std::optional<double> estimated_noise(const StimulusSums& sums, double exposure_ev);

/// The pictures that `--layers` writes for looking into a composite (paper Fig. 2).
struct LayerImages {
  Image with_object, without_object, object;
};
[[nodiscard]] LayerImages layer_images(const StimulusSums& sums);

}  // namespace seamline::renderer
