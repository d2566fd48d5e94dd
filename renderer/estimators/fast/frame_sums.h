#pragma once
#include <vector>

#include "renderer/estimators/estimator_choices.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "renderer/picture/scene_sums.h"
#include "renderer/transport/omissions.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// The truth of one frame of a clip, beside which its other frames need few samples. A sample has the same
/// path in both frames until it meets what moved, so what they differ by has far less noise than either.
struct FrameBase {
  SceneDefinition definition;
  EstimatorChoices choices;
  std::vector<int> spp;          ///< of each block
  std::vector<SceneSums> steps;  ///< its sums after `samples_of_step`, without guides
  SceneSums whole;               ///< and after all
};

/// In how many steps a frame is compared with another one.
inline constexpr int frame_steps = 2;

/// Samples of a block after a step (from 0), of `spp` in all: a twelfth, a quarter. Every half of them has as
/// many tails of paths as the others.
[[nodiscard]] int samples_of_step(int step, int spp);

/// Whether a frame differs from a base by nothing but where its objects stand.
[[nodiscard]] bool may_be_base(const FrameBase& base, const SceneDefinition& frame,
                               const EstimatorChoices& choices);

[[nodiscard]] FrameBase make_frame_base(const TruthScene& scene, const SceneGeometry& geometry,
                                        const EstimatorChoices& choices, const std::vector<int>& spp,
                                        const ScenePassOptions& options);

/// Gives empty sums of a frame what as many samples as the base has find: the base's sums and, times the
/// inverse of its share, what a step's samples change in them (control variates: not biased by how few these
/// are). All samples are taken in blocks where an object that moved is or was seen, in those around them, and
/// where the change's noise would be above `most_change_noise` of the base's.
[[nodiscard]] FrameBlocks add_samples_beside(const FrameBase& base, const TruthScene& scene,
                                             const SceneGeometry& geometry, const ScenePassOptions& options,
                                             SceneSums& sums);

}  // namespace seamline::renderer
