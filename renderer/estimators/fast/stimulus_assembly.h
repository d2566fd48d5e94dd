#pragma once
#include <optional>

#include "renderer/estimators/fast/depth_pass.h"
#include "renderer/estimators/fast/object_truth.h"
#include "renderer/picture/bounce_filter.h"

namespace seamline::renderer {

/// What a stimulus is put together from.
struct StimulusParts {
  const ObjectTruth& truth;
  const Recipe& recipe;
  const DepthAnswers& depth;
  const ObjectOrder& order;  ///< empty: truth and depth mesh agree on who is in front
};

/// How light that the depth mesh answers is filtered.
struct DepthFilters {
  FilterStrength ratio = {};   ///< light that only decides a ratio
  FilterStrength object = {};  ///< bounce light on the object
  TileSet tiles = {};          ///< where; empty: everywhere
};

/// Puts a stimulus together from the truth's sums and the depth mesh's answers, pixel by pixel: DESIGN
/// section 3's formula with sums of samples that truth and depth mesh sort alike. With `only_half` (0 or 1)
/// the other half stays empty.
[[nodiscard]] StimulusLayers assemble_stimulus(const StimulusParts& parts, const DepthFilters& filters,
                                               int threads, std::optional<std::size_t> only_half = {});

}  // namespace seamline::renderer
