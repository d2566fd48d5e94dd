#pragma once
#include "renderer/estimators/fast/fast_depth_pass.h"
#include "renderer/estimators/fast/object_truth.h"
#include "renderer/picture/bounce_filter.h"

namespace seamline::renderer {

/// What a stimulus is put together from.
struct StimulusSources {
  const ObjectTruth& truth;
  const Recipe& recipe;
  const DepthAnswers& depth;
  const ObjectOrder& order;  ///< empty: truth and depth mesh agree on who is in front
  bool dark_layer = false;   ///< what the depth mesh answers off the object is all there is of its shadow
  Compositing compositing = Compositing::ratio;
};

/// How light that the depth mesh answers is filtered.
struct DepthFilters {
  FilterStrength ratio = {};   ///< light that only decides a ratio
  FilterStrength object = {};  ///< bounce light on the object
  TileSet tiles = {};          ///< where; empty: everywhere
};

/// Puts a stimulus together from the truth's sums and the depth mesh's answers, pixel by pixel: the
/// formula of documentation/developers/design.md, section 2, with sums of samples that truth and depth mesh
/// sort alike.
[[nodiscard]] StimulusSums assemble_stimulus(const StimulusSources& sources, const DepthFilters& filters,
                                             int threads);

/// Makes of an earlier round's sums what `assemble_stimulus` would make anew, bit for bit. `changed`: the
/// tiles whose answers, whose filter or whose lent samples (`sample_shares_of_tiles`) are not what they were.
void assemble_again(const StimulusSources& sources, const DepthFilters& filters, const TileSet& changed,
                    int threads, StimulusSums& sums);

/// One half (0 or 1) of `made` without any filter; the other half is empty.
[[nodiscard]] StimulusSums assemble_half_as_sampled(const StimulusSources& sources, const StimulusSums& made,
                                                    std::size_t half, int threads);

}  // namespace seamline::renderer
