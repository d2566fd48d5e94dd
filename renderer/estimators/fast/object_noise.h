#pragma once
#include "renderer/estimators/fast/object_truth.h"

namespace seamline::renderer {

/// How many samples each block should have of what the depth mesh adds to the light on the object, so that
/// noise does not give the object away: in every block that shows it, the variance of its light in the
/// stimulus is at most `most_variance` times that in the photograph; never more samples than the photograph
/// has, unless they are there already. `asked_spp`: those each block has had, 0 where nothing is asked.
[[nodiscard]] std::vector<int> samples_on_object(const ObjectTruth& truth, const StimulusSums& stimulus,
                                                 const std::vector<int>& asked_spp, double most_variance,
                                                 int threads);

}  // namespace seamline::renderer
