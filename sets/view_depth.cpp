#include "sets/view_depth.h"

#include <algorithm>

#include "renderer/views/depth_image.h"
#include "renderer/views/depth_parallax.h"

namespace seamline::renderer {
namespace {

std::optional<float> along(const Geometry& geometry, const Ray& ray) {
  const std::optional<SurfacePoint> hit = geometry.nearest(ray);
  return hit ? std::optional(hit->distance_m) : std::nullopt;
}

}  // namespace

Image reference_depth(const TruthScene& scene) {
  if (scene.definition.view.kind != ViewKind::depth_image) return {};
  const Geometry everything = scene.geometry(true, scene.object_indices());
  return planar_depth_m(scene.camera, [&](const Ray& ray) { return along(everything, ray); });
}

Image stimulus_depth(const TruthScene& scene, const ObjectGeometry& truth, const Recipe& recipe,
                     const Geometry* mesh) {
  if (scene.definition.view.kind != ViewKind::depth_image) return {};
  const bool by_mesh = recipe.answers.occlusion == Who::depth && mesh != nullptr;
  const Geometry& real = by_mesh ? *mesh : truth.truth;
  return planar_depth_m(scene.camera, [&](const Ray& ray) {
    const std::optional<float> real_m = along(real, ray), object_m = along(truth.object, ray);
    if (!real_m || !object_m) return real_m ? real_m : object_m;
    return std::optional(std::min(*real_m, *object_m));
  });
}

void give_depth_parallax(const TruthScene& scene, const TruthSums& truth, const Geometry* mesh,
                         const StimulusSums& sums, int threads, Composite& composite) {
  if (scene.definition.view.parallax != Parallax::depth || mesh == nullptr) return;
  const Image photographs = background_image(truth);
  take_depth_parallax({.view = scene.definition.view,
                       .camera = scene.camera,
                       .photographs = photographs,
                       .mesh = *mesh,
                       .sums = sums,
                       .threads = threads},
                      composite);
}

}  // namespace seamline::renderer
