#pragma once
#include "renderer/estimators/fast/fast_depth_pass.h"
#include "renderer/estimators/fast/object_truth.h"
#include "renderer/picture/bounce_filter.h"

namespace seamline::renderer {

/// Bounce light after filtering, row by row; empty where nothing was filtered. It is right in the tiles that
/// were asked for.
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

/// What share of its samples each block lends to the filter; empty: each lends all it has. A tile that goes
/// without the filter was asked dozens of times as often as those beside it. It lends no more samples than
/// the least asked of the others have, or pixels beside it would take nearly all of their light from it, be
/// wrong by it, and their tiles would lose the filter next.
[[nodiscard]] std::vector<float> sample_shares_of_tiles(const DepthAnswers& depth, const TileSet& filtered);

/// Light off the object that the depth mesh has a part in; empty for a strength of no levels. `guides` become
/// its surfaces. `filtered`: the tiles that are shown filtered; empty: all are, or all lend what they have.
/// `tiles`: those asked for.
[[nodiscard]] FilteredBounce filtered_uncovered(const ObjectTruth& truth, const DepthAnswers& depth,
                                                const FilterStrength& strength, const TileSet& filtered,
                                                const TileSet& tiles, int threads,
                                                std::vector<Guide>& guides);
/// Bounce light of the depth mesh on the object.
[[nodiscard]] FilteredBounce filtered_object(const ObjectTruth& truth, const DepthAnswers& depth,
                                             const FilterStrength& strength, const TileSet& tiles,
                                             int threads);

}  // namespace seamline::renderer
