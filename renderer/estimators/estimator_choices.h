#pragma once
#include <optional>
#include <vector>

#include "renderer/picture/bounce_filter.h"
#include "renderer/transport/answers.h"
#include "renderer/transport/light_facts.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// What is asked of an estimator in one scene.
struct EstimateOptions {
  int spp = 64;                      ///< samples a pixel, when there is no error to reach
  std::optional<double> error = {};  ///< display units: sample until the picture's estimated error is below
  std::uint64_t seed = 1;
  int threads = 1;
  bool who_is_in_front = false;   ///< some stimulus asks the depth mesh what hides the object
  bool depth_bounces = false;     ///< some stimulus asks the depth mesh for bounce light
  double most_mesh_albedo = 0;    ///< of depth meshes that are painted from a photograph; 0: there are none
  Omissions omit = {};            ///< what the fast estimator leaves out
  bool keeps_error_maps = false;  ///< with each stimulus of the fast estimator, for the error of changes
  /// One geometry answers for all light of each stimulus; none takes bounce light of one and sky of the
  /// other.
  bool light_of_one_geometry = false;
  /// Whether errors are estimated where samples are decided beforehand (`SceneEstimator::hold_to`).
  bool judges_decided = true;
};

/// Everything that an estimator decides about a scene before it has seen a sample: how many samples, which
/// rays, which filters, and what it leaves out. The estimators read it from here, and `--explain` prints it.
struct EstimatorChoices {
  Estimator estimator = Estimator::fast;
  std::optional<double> error = {};  ///< that the pictures may have, display units; none: `first_spp` is all

  // Rays of a sample.
  int bounces = 0;         ///< that are followed
  bool skips_sky = false;  ///< no ray is traced only to reach an environment without light
  int sky_rays = 1;        ///< from the first surface
  int tail_every = 1;      ///< every how many samples the tail of a path is followed (see PathRules)

  // Samples of the photograph.
  int first_spp = 64;           ///< a pixel, in the first round
  int most_spp = 64;            ///< a pixel
  double photograph_share = 1;  ///< of `error`, what the photograph may have
  /// Whether the photograph has to be good enough as the stimuli of each object filter it. Else the stimuli
  /// of the others have samples of their own to make up for it.
  bool photograph_for_each_object = false;

  // Samples of the depth mesh, by the fast estimator.
  std::optional<int> first_ratio_spp = {};       ///< for a ratio; none: as many as the photograph has
  std::optional<int> first_difference_spp = {};  ///< for what it adds to light on the object; none: likewise
  int most_times_photograph_spp = 1;  ///< of a block: this many times the samples of the photograph
  double most_object_variance = 1;    ///< of light on the object, times that in the photograph
  bool asks_untouched_tiles = true;   ///< also where nothing uses the answer

  // Filters of bounce light.
  /// From none (the first) to the strongest, with which sampling begins.
  std::vector<FilterStrength> filters = {no_filter};
  FilterStrength ratio_filter = no_filter;  ///< of light that only decides a ratio
  /// A bias is taken for one where it is more than this share of a tile's unfiltered noise.
  double surely_biased = 0;

  bool keeps_who_is_in_front = false;  ///< what an object hides, and whether it is hidden, of every sample
  /// The photograph's sky is looked for by the rays of bounce light and filtered with it.
  bool filters_sky = false;
  bool keeps_sky_apart =
      false;  ///< then: some stimulus takes sky of one geometry and bounce light of another

  bool operator==(const EstimatorChoices&) const = default;
};

/// The light of a scene, with what its depth meshes may reflect.
[[nodiscard]] LightFacts with_mesh_albedo(LightFacts light, const EstimateOptions& options);

/// The choices for a scene of this light and exposure. Depends on nothing measured.
[[nodiscard]] EstimatorChoices estimator_choices(Estimator estimator, const LightFacts& light,
                                                 double exposure_ev, const EstimateOptions& options);

/// The scene with as much light as the choices follow.
[[nodiscard]] TruthScene with_chosen_light(TruthScene scene, const EstimatorChoices& choices);

}  // namespace seamline::renderer
