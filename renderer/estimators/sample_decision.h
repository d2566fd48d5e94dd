#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "raytracer/common/tiles.h"

namespace seamline::renderer {

/// How a photograph is sampled and filtered, once that is decided: what the frames of a clip share, so that
/// where nothing moves their noise is the same and does not flicker.
struct PhotographDecision {
  std::vector<int> spp;      ///< samples of each block (16 x 16 px), even
  std::size_t strength = 0;  ///< in `EstimatorChoices::filters`
};

/// The same of what a stimulus asks of the depth mesh.
struct StimulusDecision {
  std::vector<int> uncovered, object;  ///< samples of each block, off and on the object; 0: none
  TileSet filtered;                    ///< tiles where light of the depth mesh is filtered
};

/// Makes a decision one that is good enough for another picture too: of each block the most samples, and the
/// filter only where both have it. An empty one becomes the other.
inline void join_decisions(const PhotographDecision& other, PhotographDecision& decision) {
  decision.strength = decision.spp.empty() ? other.strength : std::min(decision.strength, other.strength);
  decision.spp.resize(other.spp.size(), 0);
  for (std::size_t b = 0; b < other.spp.size(); ++b)
    decision.spp[b] = std::max(decision.spp[b], other.spp[b]);
}

inline void join_decisions(const StimulusDecision& other, StimulusDecision& decision) {
  decision.uncovered.resize(other.uncovered.size(), 0);
  decision.object.resize(other.object.size(), 0);
  decision.filtered.resize(other.filtered.size(), 1);
  for (std::size_t b = 0; b < other.uncovered.size(); ++b) {
    decision.uncovered[b] = std::max(decision.uncovered[b], other.uncovered[b]);
    decision.object[b] = std::max(decision.object[b], other.object[b]);
  }
  for (std::size_t t = 0; t < other.filtered.size(); ++t)
    if (other.filtered[t] == 0) decision.filtered[t] = 0;
}

}  // namespace seamline::renderer
