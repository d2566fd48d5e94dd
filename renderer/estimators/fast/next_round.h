#pragma once
#include <optional>
#include <vector>

#include "raytracer/error/sampling_rounds.h"
#include "renderer/estimators/estimator_choices.h"

namespace seamline::renderer {

/// A stimulus' error as it is, and as it would be if no light of the depth mesh were filtered (none: nothing
/// is filtered, or it has not been looked at).
struct StimulusJudgement {
  ErrorEstimate error;
  std::optional<ErrorEstimate> unfiltered;
};

/// Where a stimulus stands between two rounds.
struct StimulusState {
  TileGrid grid;
  const ErrorEstimate& photograph;         ///< its error is in the stimulus, whatever the depth mesh is asked
  const std::vector<int>& photograph_spp;  ///< samples of each block
  const std::vector<int>& asked_spp;       ///< of the depth mesh, of each block
  const TileSet& filtered;                 ///< tiles where light of the depth mesh is filtered
  const StimulusJudgement& judged;
  const ErrorTarget& target;
  const EstimatorChoices& choices;
  int round = 0;  ///< those before it
  /// Of each block: squared noise beyond the photograph's that samples do not lower; null: not known.
  const std::vector<double>* stays = nullptr;
};

struct NextRound {
  std::vector<int> next_spp;            ///< that each block should have
  std::vector<std::size_t> unfiltered;  ///< tiles that go without the filter from now on
};

/// Samples as `next_samples` gives them, and tiles that are filtered no longer. These are first the tiles
/// that are not good enough because of their bias, then those where it takes the fewest samples to replace
/// the filter; as many tiles as make the round cheapest. A tile without filter gets as many samples as the
/// photograph has, or its noise would show as a patch. Where the photograph's own error takes nearly all that
/// is allowed, samples gain little: what a round adds at least doubles from one to the next.
[[nodiscard]] NextRound next_round(const StimulusState& state);

}  // namespace seamline::renderer
