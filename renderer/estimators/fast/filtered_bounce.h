#pragma once
#include "renderer/estimators/fast/fast_depth_pass.h"
#include "renderer/estimators/fast/object_truth.h"
#include "renderer/picture/bounce_filter.h"

namespace seamline::renderer {

/// Bounce light after filtering, row by row; empty where nothing was filtered.
struct FilteredBounce {
  std::vector<Surface> surfaces;
  std::vector<BounceTexel> texels;
  [[nodiscard]] const Surface* surface(std::size_t i) const {
    return surfaces.empty() ? nullptr : &surfaces[i];
  }
  [[nodiscard]] const BounceTexel* texel(std::size_t i) const {
    return texels.empty() ? nullptr : &texels[i];
  }
};

/// Light off the object that the depth mesh has a part in; empty for a strength of no levels. `guides` become
/// its surfaces.
[[nodiscard]] FilteredBounce filtered_uncovered(const ObjectTruth& truth, const DepthAnswers& depth,
                                                const FilterStrength& strength, int threads,
                                                std::vector<Guide>& guides);
/// Bounce light of the depth mesh on the object.
[[nodiscard]] FilteredBounce filtered_object(const ObjectTruth& truth, const DepthAnswers& depth,
                                             const FilterStrength& strength, int threads);

}  // namespace seamline::renderer
