#include "sets/stimulus_scene.h"

#include "raytracer/scene/eyes.h"
#include "renderer/depth/budget/budgeted_panorama.h"
#include "renderer/estimators/mesh_albedo.h"
#include "renderer/estimators/mitigation_masks.h"
#include "renderer/estimators/realtime_methods.h"

namespace seamline::renderer {

namespace {

bool looks_at_photograph(const DepthSettings& settings) {
  return (settings.chain && guided_by_photograph(*settings.chain)) ||
         settings.albedo == MeshAlbedo::photograph || settings.mitigation.occlusion == Occlusion::edges ||
         settings.mitigation.shadow == ShadowMitigation::detected;
}

/// What answers in place of the mesh. `photograph` is empty where nothing looks at it.
void add_masks(const TruthScene& scene, const ObjectGeometry& geometry, const DepthSettings& settings,
               const Image& photograph, int threads, LocalScene& local) {
  const Mitigation& mitigation = settings.mitigation;
  const Camera camera = centre_camera(scene.camera);
  const DetectedFrom detected_from{photograph, camera, threads};
  if (mitigation.occlusion != Occlusion::mesh) {
    const MaskedObject object(geometry.object);
    local.occlusion.emplace();
    local.occlusion->mask = mitigation.occlusion == Occlusion::mask
                                ? occlusion_mask(geometry.truth, object, mitigation.mask_width_px, threads)
                                : detected_mask(local.geometry, object, settings.width_px,
                                                mitigation.mask_width_px, detected_from);
  }
  if (mitigation.shadow != ShadowMitigation::none)
    local.matte = mitigation.shadow == ShadowMitigation::matte
                      ? shadow_matte(geometry.truth, scene.light, camera, mitigation.matte_width_px, threads)
                      : detected_matte(local.geometry, scene.light, mitigation.matte_width_px, detected_from);
}

}  // namespace

LocalScene stimulus_scene(const TruthScene& scene, const SceneEstimator& estimator,
                          const DepthSettings& settings, bool traces_rays, int threads,
                          const Geometry* captured, StereoMemory* stereo) {
  const Geometry& truth = captured != nullptr ? *captured : estimator.geometry().truth;
  Image photograph;
  if (looks_at_photograph(settings)) photograph = background_image(estimator.truth());
  const bool tests_depth = settings.pipeline.occlusion == Occlusion::depth_test;
  std::optional<MeasuredPanorama> budgeted;
  if (settings.chain && is_budgeted(*settings.chain))
    budgeted = budgeted_panorama(
        {truth, estimator.geometry().object, scene.light, centre_camera(scene.camera), threads}, settings,
        tests_depth || tests_pixels(settings.chain->occlusion));
  std::map<std::size_t, sensors::DepthFrame> matched;
  if (settings.chain && has_stereo(*settings.chain)) {
    StereoMemory once;
    matched = (stereo != nullptr ? *stereo : once)
                  .frames({truth, scene.light, centre_camera(scene.camera), scene.definition.exposure_ev},
                          *settings.chain, threads);
  }
  LocalScene local = make_local_scene(truth, settings,
                                      {.albedo = scene.definition.albedo,
                                       .traces_rays = traces_rays,
                                       .threads = threads,
                                       .photograph = centre_camera(scene.camera),
                                       .picture = photograph.values.empty() ? nullptr : &photograph,
                                       .stereo = &matched,
                                       .keeps_triangles = looks_at_triangles(settings.pipeline),
                                       .tests_depth = tests_depth,
                                       .budgeted = budgeted ? &*budgeted : nullptr});
  if (settings.albedo != MeshAlbedo::constant)
    paint_mesh(local.geometry, truth, settings,
               {photograph, scene.camera, scene.light, scene.definition.albedo, threads});
  if (settings.mitigation != Mitigation{})
    add_masks(scene, estimator.geometry(), settings, photograph, threads, local);
  if (settings.pipeline != Pipeline{})
    add_realtime_methods(scene, estimator.geometry(), settings.pipeline, threads, local);
  return local;
}

}  // namespace seamline::renderer
