#pragma once
#include <vector>

#include "renderer/error_estimate.h"

namespace seamline {

/// When sampling ends: the error over the image, and three times that in the worst tile (`--error`).
struct ErrorTarget {
  double rmse = 0;  ///< display units, 0 to 1
  [[nodiscard]] bool met_by(const ErrorEstimate& estimate) const {
    return estimate.rmse() <= rmse && estimate.worst_tile() <= 3 * rmse;
  }
};

/// What more samples can do in a block: `noise` falls with them.
struct BlockState {
  double noise = 0;  ///< squared
  int spp = 0;       ///< even
  int most_spp = 0;  ///< the block never gets more
};

/// Where a picture stands between two rounds.
struct SamplingState {
  BlockGrid grid;
  std::vector<BlockState> blocks;
  /// Of each tile, squared: bias, and noise that more samples do not touch.
  std::vector<double> tile_rest;
  /// Squared error of the whole picture, without rounding: not the tiles' mean, because a bias below 0 in a
  /// tile only means that it is not known.
  double image_square = 0;
};

/// The number of samples each block should have next: steps go to the blocks that gain most for a sample,
/// until the target is expected to be met (noise, squared, is taken to fall like samples^-1.1: -1 for
/// independent numbers, up to -1.5 for Sobol'), over the image and in every tile. Estimates from few samples
/// are rough, so none gets more than four times what it has at once; what others would have to do for it is
/// not asked of them, but left to the next round. When the image is not good enough at least a sixteenth of
/// the samples is planned, so that there are few rounds. Equal to what the blocks have when none can grow.
[[nodiscard]] std::vector<int> next_samples(const SamplingState& state, const ErrorTarget& target);

}  // namespace seamline
