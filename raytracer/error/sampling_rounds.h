#pragma once
#include <vector>

#include "raytracer/error/error_estimate.h"

namespace seamline::renderer {

/// When sampling ends: the error over the image, and three times that in the worst tile (`--error`).
struct ErrorTarget {
  double rmse = 0;  ///< display units, 0 to 1
  [[nodiscard]] double square_in_a_tile() const { return 9 * rmse * rmse; }
  [[nodiscard]] bool met_by(const ErrorEstimate& estimate) const {
    return estimate.rmse() <= rmse && estimate.worst_tile() <= 3 * rmse;
  }
};

/// What more samples can do in a block: `noise` falls with them.
struct BlockState {
  double noise = 0;   ///< squared
  int spp = 0;        ///< even
  int least_spp = 0;  ///< what it gets in any case
  int most_spp = 0;   ///< the block never gets more
};

/// Where a picture stands between two rounds.
struct SamplingState {
  BlockGrid grid;
  std::vector<BlockState> blocks;
  /// Of each tile, squared: bias, and noise that more samples do not touch.
  std::vector<double> tile_residual;
  /// Squared error of the whole picture, without rounding: not the tiles' mean, because a bias below 0 in a
  /// tile only means that it is not known.
  double image_square = 0;
  /// Of the samples that there are, what is added at least when the image is not good enough.
  double least_growth = 1.0 / 16;
};

struct NextSamples {
  /// The number of samples each block should have next; what they have when none can grow.
  std::vector<int> next;
  double samples = 0;     ///< added until the target is expected to be met, over all pixels
  bool suffices = false;  ///< whether it is expected to be met then
};

/// Gives samples, step by step, to the block where a sample lowers the error most, until the target is
/// expected to be met over the image and in every tile. Squared noise is taken to fall like samples^-1.1 (-1
/// for independent numbers, up to -1.5 for Sobol'). Estimates from few samples are rough, so a block gets at
/// most four times what it has; what it would need beyond that is left to the next round. When the image is
/// not good enough, at least `least_growth` is added, and one sample for every other pixel, so that there are
/// few rounds.
[[nodiscard]] NextSamples next_samples(const SamplingState& state, const ErrorTarget& target);

}  // namespace seamline::renderer
