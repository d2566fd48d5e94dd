#include "laboratory/convergence/convergence_pictures.h"

#include <fmt/core.h>

#include <algorithm>

#include "laboratory/convergence/estimates/estimates.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "renderer/estimators/fast/truth_sums.h"
#include "renderer/estimators/path/path_truth_pass.h"
#include "renderer/picture/composite.h"
#include "sets/stimulus_scene.h"
#include "stimuli/pictures/difference.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

/// The picture's camera rays, one a pixel, by bare Embree: no picture is made without them.
EstimateLimit camera_rays(const ConvergenceSubject& subject) {
  constexpr int repeats = 8;
  const Camera& camera = subject.scene.camera;
  std::vector<Ray> rays;
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) rays.push_back(centre_ray(camera, x, y));
  std::vector<float> distance_m(rays.size());
  const double before = processor_seconds();
  for (int i = 0; i < repeats; ++i) subject.geometry.truth.distances(rays, distance_m);
  return {.what = "a camera ray a pixel", .seconds_each = (processor_seconds() - before) / repeats};
}

/// What stands in for the depth mesh, in words.
std::vector<std::pair<std::string, Mitigation>> mitigations() {
  return {{"depth mesh", {}},
          {"edges and shadows of the photograph",
           {.occlusion = Occlusion::edges, .shadow = ShadowMitigation::detected}},
          {"painted mask and matte", {.occlusion = Occlusion::mask, .shadow = ShadowMitigation::matte}}};
}

}  // namespace

EstimateResult measure_mitigation(const ConvergenceSubject& subject) {
  EstimateResult result{
      .part = "mitigation",
      .amount = "width_px",
      .unit = "display units",
      .truth = "the picture with the object truly there, with the same sample points",
      .rows = {},
      .limit = camera_rays(subject),
      .expected = -0.5,
      .why =
          "an edge that is wrong by d pixels changes d of them along its length: the root of d, below a pixel "
          "d itself; nothing is learnt from the depth map where a mask answers everything"};
  const auto estimator = make_path_estimator(
      subject.scene, {.spp = subject.spp, .seed = subject.study.seed, .threads = subject.threads});
  estimator->take_object(subject.stimulus.object_index, {});
  const Image reference = reference_image(estimator->truth());
  constexpr int narrowest_px = 32, widest_px = 1024;
  Progress progress(stimulus_id(subject.stimulus) + " mitigation", 6);
  for (int width_px = narrowest_px; width_px <= widest_px; width_px *= 2) {
    for (const auto& [name, mitigation] : mitigations()) {
      DepthSettings settings = subject.stimulus.depth;
      settings.width_px = width_px;
      settings.mitigation = mitigation;
      settings.mitigation.mask_width_px = settings.mitigation.matte_width_px = width_px;
      const double before = processor_seconds();
      const LocalScene local = stimulus_scene(subject.scene, *estimator, settings, true, subject.threads);
      const Image picture = compose(estimator->stimulus(subject.recipe, local.world(), {}).sums).picture;
      result.rows.push_back({name, static_cast<double>(width_px), processor_seconds() - before,
                             display_rmse(picture, reference, subject.exposure_ev())});
    }
    progress.advance(1, "widths");
  }
  std::stable_sort(result.rows.begin(), result.rows.end(),
                   [](const EstimateRow& a, const EstimateRow& b) { return a.series < b.series; });
  return result;
}

namespace {

std::string series_name(const FilterStrength& filter) {
  if (filter.levels == 0) return "no filter";
  return fmt::format("{} level{}, reach 1/{:g}", filter.levels, filter.levels == 1 ? "" : "s",
                     filter.reach_divisor);
}

}  // namespace

EstimateResult measure_filter(const ConvergenceSubject& subject) {
  constexpr int fewest_spp = 4, most_spp = 64, reference_spp = 1024;
  EstimateResult result{
      .part = "filter",
      .amount = "samples a pixel",
      .unit = "display units",
      .truth = "a rendering by paths with 1,024 samples of another seed and no filter",
      .rows = {},
      .limit = camera_rays(subject),
      .expected = -0.5,
      .why =
          "independent samples; what a filter blurs away stays, and is the bias that renderings to a "
          "wanted error look for"};
  const TruthSums long_truth =
      render_truth(subject.scene, subject.geometry, subject.pass(reference_spp, subject.study.seed + 1));
  const Image reference = reference_image(long_truth);
  const EstimatorChoices choices = estimator_choices(
      Estimator::fast, light_facts(subject.scene), subject.exposure_ev(),
      {.spp = most_spp, .error = 0.01, .seed = subject.study.seed, .threads = subject.threads});
  const TruthScene scene = with_chosen_light(subject.scene, choices);
  const SceneGeometry geometry(scene);
  Progress progress(stimulus_id(subject.stimulus) + " filter", 5);
  for (int spp = fewest_spp; spp <= most_spp; spp *= 2) {
    const double before = processor_seconds();
    SceneSums sums = empty_sums(scene.camera, scene.objects.size());
    add_samples(scene, geometry, std::vector<int>(sums.spp.size(), spp),
                {.seed = subject.study.seed, .threads = subject.threads, .tail_every = choices.tail_every},
                sums);
    const double sampled = processor_seconds();
    for (const FilterStrength& filter : choices.filters) {
      const double filters = processor_seconds();
      const Image picture =
          reference_image(truth_sums(sums, scene.camera, scene.light, subject.stimulus.object_index,
                                     {.filter = filter, .threads = subject.threads}));
      result.rows.push_back({series_name(filter), static_cast<double>(spp),
                             sampled - before + processor_seconds() - filters,
                             display_rmse(picture, reference, subject.exposure_ev())});
    }
    progress.advance(1, "samples");
  }
  std::stable_sort(result.rows.begin(), result.rows.end(),
                   [](const EstimateRow& a, const EstimateRow& b) { return a.series < b.series; });
  return result;
}

}  // namespace seamline::renderer
