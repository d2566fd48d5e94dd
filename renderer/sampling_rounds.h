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

/// What more samples can do in a tile: `noise` falls with them, the rest does not.
struct TileState {
  double noise = 0;  ///< squared
  double rest = 0;   ///< squared: bias, and noise that sampling here does not touch
  int spp = 0;
  double share = 0;  ///< of the picture
  bool can_grow = true;
};

/// Which tiles to double: those that gain most for a sample, until the target is expected to be met (samples
/// double, so that their points stay well distributed; noise is expected to halve), and every tile that is
/// over three times the target. Returns the new number of samples of each tile. At least a tenth of the tiles
/// that can grow do, so that there are few rounds.
[[nodiscard]] std::vector<int> next_samples(const std::vector<TileState>& tiles, const ErrorTarget& target);

}  // namespace seamline
