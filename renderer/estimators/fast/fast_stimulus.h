#pragma once
#include <optional>

#include "raytracer/error/samples_taken.h"
#include "raytracer/error/sampling_rounds.h"
#include "renderer/estimators/estimator_choices.h"
#include "renderer/estimators/fast/fast_depth_pass.h"
#include "renderer/estimators/fast/object_truth.h"
#include "renderer/estimators/fast/truth_sums.h"
#include "renderer/estimators/sample_decision.h"

namespace seamline::renderer {

struct FastStimulusOptions {
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<ErrorTarget> target = {};       ///< none: as many samples as the photograph has
  FilterStrength filter = no_filter;            ///< of bounce light on the object: the photograph's
  std::optional<Compositing> compositing = {};  ///< none: as the world of depth says
  const StimulusDecision* decision = nullptr;   ///< in place of a target: how it is sampled
  bool judges = true;                           ///< else nothing is said of its error, where that is decided
  bool keeps_pictures = false;                  ///< those that its error is estimated from
  std::function<void(double share_done)> progress = {};
};

struct FastStimulus {
  StimulusSums sums;
  ErrorEstimate error;
  Savings saved;              ///< what concerns this stimulus alone
  SamplesTaken taken;         ///< of the depth mesh, by the samples of a block's pixels that had most
  StimulusDecision decision;  ///< how it was sampled
  HalfPictures pictures;      ///< where they are kept
};

/// Renders one stimulus from the truth's sums and what the depth mesh answers. The photograph and what the
/// truth answers are shared by all widths and artifacts; the depth mesh is asked for a few samples a pixel
/// first and for more where the picture is not good enough, because the ratio is the same light with and
/// without the object and needs far fewer samples than the photograph.
[[nodiscard]] FastStimulus render_fast_stimulus(const ObjectTruth& truth, const DepthWorld& depth,
                                                const Recipe& recipe, const EstimatorChoices& choices,
                                                const FastStimulusOptions& options);

}  // namespace seamline::renderer
