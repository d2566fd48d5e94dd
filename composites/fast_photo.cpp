#include "composites/fast_photo.h"

#include <algorithm>
#include <cmath>

#include "composites/objects/photo_objects.h"
#include "renderer/estimators/fast/fast_stimulus.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "renderer/estimators/seen_emission.h"

namespace seamline::renderer {
namespace {

constexpr int coverage_spp = 64;  // of who covers what, which costs two rays a sample
constexpr int lax_coverage_spp = 16;
constexpr double lax_error = 0.02;

TruthScene scene_of(const PhotoScene& photo, const PhotoMeshes& meshes, double exposure_ev,
                    const Light& light) {
  TruthScene scene;
  scene.definition.exposure_ev = exposure_ev;
  scene.definition.albedo = double{meshes.local_scene->albedo.maxCoeff()};
  scene.camera = photo.camera;
  scene.light = light;
  scene.background = {meshes.local_scene};
  scene.objects[photo_object_index - 1] = meshes.objects;
  return scene;
}

/// Who covers what, without any light. `occlusion`: decides who is in front; null: who is nearer.
SceneSums coverage(const TruthScene& scene, const OcclusionTest* occlusion, int spp,
                   const PassOptions& options) {
  TruthScene dark = scene;
  dark.light = {.bounces = 0, .skips_sky = true};
  SceneSums sums = empty_sums(scene.camera);
  add_samples(dark, SceneGeometry(dark), std::vector<int>(sums.spp.size(), spp),
              {.seed = options.seed, .threads = options.threads, .occlusion = occlusion}, sums);
  return sums;
}

/// The truth's sums of that, with the photograph's light.
TruthSums photographed_truth(const PhotoScene& photo, const TruthScene& scene, const SceneSums& sums,
                             int threads) {
  TruthSums truth = truth_sums(sums, scene.camera, {.skips_sky = true}, photo_object_index,
                               {.filter = no_filter, .threads = threads});
  for (auto& half : truth.halves)
    for (int y = 0; y < truth.height_px; ++y)
      for (int x = 0; x < truth.width_px; ++x) {
        TruthPixel& pixel = half[truth.index(x, y)];
        const Rgb seen = photo.photograph.rgb(x, y);
        const float samples = 0.5F * static_cast<float>(truth.spp);
        pixel.without_object = {.direct = seen * pixel.uncovered_surfaces};
        pixel.with_object = pixel.without_object;
        pixel.sky = seen * std::max(0.0F, samples - pixel.covered - pixel.uncovered_surfaces);
      }
  return truth;
}

/// How far off the share is that the objects cover, by half the difference of both halves: a root mean square
/// over the picture.
double coverage_error(const TruthSums& truth) {
  double squares = 0;
  for (std::size_t pixel = 0; pixel < truth.halves[0].size(); ++pixel) {
    const double difference = double{truth.halves[0][pixel].covered} - double{truth.halves[1][pixel].covered};
    squares += difference * difference;
  }
  return std::sqrt(squares / static_cast<double>(truth.halves[0].size())) / truth.spp;
}

/// Who covers what in a photograph, and the truth's sums of that.
struct Covered {
  SceneSums sums;
  TruthSums truth;
};

Covered covered(const PhotoScene& photo, const TruthScene& scene, int spp, const PassOptions& options) {
  Covered out{.sums = coverage(scene, photo.occlusion.test, spp, options), .truth = {}};
  out.truth = photographed_truth(photo, scene, out.sums, options.threads);
  return out;
}

/// By 64 samples a pixel; beside a large error by 16, unless many edges make that too few.
Covered covered_within(const PhotoScene& photo, const TruthScene& scene, double error,
                       const PassOptions& options) {
  if (error >= lax_error)
    if (Covered few = covered(photo, scene, lax_coverage_spp, options); coverage_error(few.truth) < error / 2)
      return few;
  return covered(photo, scene, coverage_spp, options);
}

}  // namespace

std::shared_ptr<const SurfaceMesh> surface_of_depth(const DepthMesh& mesh, double albedo) {
  auto surface = std::make_shared<SurfaceMesh>();
  surface->name = "local scene";
  surface->positions_m = mesh.vertices_m;
  surface->triangles = mesh.triangles;
  surface->albedo = Rgb::Constant(static_cast<float>(albedo));
  return surface;
}

bool fast_can_render(const PhotoScene& scene) {
  if (scene.occlusion.nothing_hides || !scene.shadows || scene.added != nullptr) return false;
  const Camera& camera = scene.camera;
  if (!camera.directions) return true;
  const auto right = static_cast<float>(camera.width_px), lower = static_cast<float>(camera.height_px);
  for (const auto& [x, y] : {std::pair{0.0F, 0.0F}, {right, 0.0F}, {0.0F, lower}, {right, lower}})
    if (camera.direction(x, y).isZero()) return false;
  return true;
}

std::shared_ptr<const SeenEmission> seen_objects(const PhotoScene& photo, const PhotoMeshes& meshes,
                                                 int threads) {
  if (photo.occlusion.test != nullptr) return nullptr;
  TruthScene scene = scene_of(photo, meshes, 0, photo.light);
  if (photo.occlusion.nothing_hides) scene.background.clear();
  return find_seen_emission(scene, threads);
}

PhotoEstimate photo_by_fast(const PhotoScene& photo, const PhotoMeshes& meshes,
                            const std::optional<double>& error, double exposure_ev,
                            const PassOptions& options) {
  TruthScene scene = scene_of(photo, meshes, exposure_ev, photo.light);
  const Covered shown = error ? covered_within(photo, scene, *error, options)
                              : covered(photo, scene, std::max(2, options.spp / 2 * 2), options);
  const SceneSums& sums = shown.sums;
  const TruthSums& truth = shown.truth;
  const int spp = truth.spp;
  EstimatorChoices choices = estimator_choices(
      Estimator::fast, light_facts(scene), exposure_ev,
      {.spp = spp, .error = error, .seed = options.seed, .threads = options.threads, .depth_bounces = true});
  // Coverage is no photograph that bounds what a picture can need.
  if (error) choices.most_times_photograph_spp = choices.most_spp / spp;
  scene = with_chosen_light(std::move(scene), choices);
  const ObjectGeometry geometry = object_geometry(scene, photo_object_index);
  const OcclusionTest* test = photo.occlusion.test;
  ErrorEstimate no_error;
  no_error.tiles.resize(static_cast<std::size_t>(sums.grid.count()));
  no_error.blocks.resize(static_cast<std::size_t>(sums.blocks().count()));
  const auto seen = find_seen_emission(scene, options.threads);
  const ObjectTruth object{scene, sums, geometry, photo_object_index, truth, no_error, true, seen.get()};
  Recipe recipe = renderer::recipe(Artifact::all, Isolation::query);
  if (test == nullptr) recipe.answers.occlusion = Who::truth;  // it is the same mesh
  const ShadowMatte matte{.of_all_suns = photo.shadow_matte};
  const DepthWorld world(&photo.depth, test, photo.shadow_matte != nullptr ? &matte : nullptr);
  FastStimulus made =
      render_fast_stimulus(object, world, recipe, choices,
                           {.seed = options.seed,
                            .threads = options.threads,
                            .target = error ? std::optional(ErrorTarget{*error}) : std::nullopt,
                            .filter = choices.filters.size() > 1 ? choices.filters[1] : no_filter,
                            .compositing = photo.compositing,
                            .progress = options.progress});
  return {{std::move(made.sums)}, std::move(made.error), made.taken};
}

}  // namespace seamline::renderer
