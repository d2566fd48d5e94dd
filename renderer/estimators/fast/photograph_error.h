#pragma once
#include <array>

#include "raytracer/error/error_estimate.h"
#include "renderer/picture/pixel_sums.h"
#include "stimuli/definition/views/view.h"

namespace seamline::renderer {

/// The photograph with an object in it, from each half of the samples; and the same without what the object
/// does to the light around it, which is what a stimulus multiplies by its ratio. As a view shows it.
struct PhotographHalves {
  std::array<Image, 2> with_object, without_object;
};
[[nodiscard]] PhotographHalves photograph_halves(const TruthSums& truth, const View& view);

/// The error of the photograph as the stimuli of its object need it: that of the picture with the object,
/// and half of the noise without it where that is more. A rare bright path that the object blocks is not in
/// the picture with it, and the ratio of a depth mesh whose own light has no such path takes it away in part
/// only: no sample of the depth mesh lowers what is left. `filtered` and `sampled` are of the same samples.
[[nodiscard]] ErrorEstimate photograph_error(const PhotographHalves& filtered,
                                             const PhotographHalves& sampled, double exposure_ev, int threads,
                                             bool panorama);

}  // namespace seamline::renderer
