#include "renderer/estimators/estimator_choices.h"

#include <algorithm>

namespace seamline::renderer {
namespace {

EstimatorChoices path_choices(const LightFacts& light, const EstimateOptions& options) {
  EstimatorChoices choices{.estimator = Estimator::path, .error = options.error, .bounces = light.bounces};
  choices.first_spp = options.error ? 16 : options.spp;
  choices.most_spp = options.error ? 1 << 16 : options.spp;
  choices.photograph_share = 0.85;
  return choices;
}

/// Sky rays a sample. Beside bounce light, which costs several rays a sample, a second one is worth its
/// price and a third is not; where there is nothing but sky, the camera ray is what they share. A map has
/// light samples of its own.
int sky_rays(const LightFacts& light, int bounces) {
  if (light.sky_is_dark || light.sky_is_mapped) return 1;
  return bounces > 0 ? 2 : 8;
}

/// What is left of the error is for the noise of the stimuli. Where the photograph's noise is the sky's they
/// add next to none. Where bounce light is traced for each of them, 0.9 needs the fewest rays for the paper's
/// set (of 0.8, 0.85, 0.9 and 0.94). Where the sky is filtered and stimuli are isolated by questions, 0.94
/// does: 0.985 needs 1.43 times the rays in the gazebo, with seven widths, 0.965 1.07 and 0.91 as many.
double photograph_share(const EstimatorChoices& choices, const EstimateOptions& options) {
  if (options.depth_bounces) return 0.9;
  return choices.keeps_sky_apart ? 0.94 : 0.985;
}

EstimatorChoices fast_choices(const LightFacts& light, double exposure_ev, const EstimateOptions& options) {
  const Omissions& omit = options.omit;
  EstimatorChoices choices{.estimator = Estimator::fast, .error = options.error, .bounces = light.bounces};
  if (omit.late_bounces) choices.bounces = needed_bounces(light, exposure_ev, options.error).bounces;
  choices.skips_sky = omit.dark_sky && light.sky_is_dark;
  choices.sky_rays = sky_rays(light, choices.bounces);
  if (omit.path_tails && choices.bounces > 0) choices.tail_every = 4;

  choices.first_spp = options.error ? 16 : std::max(2, options.spp / 2 * 2);
  choices.most_spp = options.error ? 1 << 14 : choices.first_spp;
  choices.photograph_for_each_object = !options.depth_bounces;

  if (options.error && omit.ratio_samples) {
    choices.first_ratio_spp = 2;
    choices.first_difference_spp = 8;
  }
  choices.most_times_photograph_spp = 16;
  choices.most_object_variance = 1.4;  // a fifth in standard deviation
  choices.asks_untouched_tiles = !omit.untouched_tiles;

  if (omit.bounce_filter && (choices.bounces > 0 || light.emits))
    choices.filters = {no_filter, {1, 5.0F}, {2, 5.0F}, {2, 3.0F}, {2, 2.0F}};
  // What the sky lights is as smooth as what bounces. A map's light has edges.
  choices.filters_sky =
      choices.bounces > 0 && !light.sky_is_dark && !light.sky_is_mapped && choices.filters.size() > 1;
  choices.keeps_sky_apart = choices.filters_sky && !options.light_of_one_geometry;
  choices.photograph_share = photograph_share(choices, options);
  // Few samples, filtered more. Where there is nothing but sky a ratio of few samples is noisiest and its
  // light smoothest: a weaker filter would leave blotches.
  if (omit.bounce_filter)
    choices.ratio_filter =
        choices.bounces > 0 ? FilterStrength{2, 3.0F, false} : FilterStrength{3, 2.0F, false};
  // A tile's bias is known to a fifteenth of its unfiltered noise (it is the product of two halves' changes,
  // over a thousand pixels). What is less than three times that may be none.
  choices.surely_biased = 0.2;

  choices.keeps_who_is_in_front = options.who_is_in_front || !omit.who_is_in_front;
  return choices;
}

}  // namespace

LightFacts with_mesh_albedo(LightFacts light, const EstimateOptions& options) {
  light.brightest_albedo = std::max(light.brightest_albedo, options.most_mesh_albedo);
  return light;
}

EstimatorChoices estimator_choices(Estimator estimator, const LightFacts& scene_light, double exposure_ev,
                                   const EstimateOptions& options) {
  const LightFacts light = with_mesh_albedo(scene_light, options);
  switch (estimator) {
    case Estimator::path:
      return path_choices(light, options);
    case Estimator::fast:
      return fast_choices(light, exposure_ev, options);
  }
  return {};
}

TruthScene with_chosen_light(TruthScene scene, const EstimatorChoices& choices) {
  scene.light.bounces = choices.bounces;
  scene.light.skips_sky = choices.skips_sky;
  scene.light.sky_rays = choices.sky_rays;
  return scene;
}

}  // namespace seamline::renderer
