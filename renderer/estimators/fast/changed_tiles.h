#pragma once
#include <vector>

#include "renderer/estimators/fast/filtered_bounce.h"

namespace seamline::renderer {

/// Which tiles of a stimulus a round of samples changes.
class ChangedTiles {
 public:
  /// Remembers the answers that a stimulus was put together from.
  void take(const DepthAnswers& depth, const TileSet& filtered) {
    uncovered_ = depth.spp.uncovered;
    object_ = depth.spp.object;
    filtered_ = filtered;
    lent_ = sample_shares_of_tiles(depth, filtered);
  }
  /// The tiles with other answers, another filter, or that lend another share of their samples.
  [[nodiscard]] TileSet since(const DepthAnswers& depth, const TileSet& filtered) const {
    TileSet changed(filtered.size(), 0);
    const std::vector<float> lent = sample_shares_of_tiles(depth, filtered);
    const auto share = [](const std::vector<float>& shares, std::size_t block) {
      return shares.empty() ? 1.0F : shares[block];
    };
    for (std::size_t b = 0; b < uncovered_.size(); ++b)
      if (depth.spp.uncovered[b] != uncovered_[b] || depth.spp.object[b] != object_[b] ||
          share(lent, b) != share(lent_, b))
        changed[static_cast<std::size_t>(tile_of_block(depth.grid, static_cast<int>(b)))] = 1;
    for (std::size_t t = 0; t < filtered.size(); ++t)
      if (filtered[t] != filtered_[t]) changed[t] = 1;
    return changed;
  }

 private:
  std::vector<int> uncovered_, object_;
  TileSet filtered_;
  std::vector<float> lent_;
};

}  // namespace seamline::renderer
