#include "renderer/set/stimulus_scene.h"

#include "renderer/estimators/mesh_albedo.h"

namespace seamline::renderer {

LocalScene stimulus_scene(const TruthScene& scene, const SceneEstimator& estimator,
                          const DepthSettings& settings, bool traces_rays, int threads) {
  const Geometry& truth = estimator.geometry().truth;
  Image photograph;
  if ((settings.chain && guided_by_photograph(*settings.chain)) || settings.albedo == MeshAlbedo::photograph)
    photograph = background_image(estimator.truth());
  LocalScene local = make_local_scene(truth, settings,
                                      {.albedo = scene.definition.albedo,
                                       .traces_rays = traces_rays,
                                       .threads = threads,
                                       .photograph = scene.camera,
                                       .picture = photograph.values.empty() ? nullptr : &photograph});
  if (settings.albedo != MeshAlbedo::constant)
    paint_mesh(local.geometry, truth, settings,
               {photograph, scene.camera, scene.light, scene.definition.albedo, threads});
  return local;
}

}  // namespace seamline::renderer
