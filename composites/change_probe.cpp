#include "composites/change_probe.h"

#include <algorithm>
#include <cmath>

namespace seamline::renderer {
namespace {

constexpr int change_probe_width_px = 128, change_probe_spp = 4;
constexpr double least_probed_change = 1e-4;  ///< of the picture's light

/// Whether a corner of an object that no pixel's middle shows is seen: a thing thinner than a pixel.
bool shows_object_corner(const PhotoScene& scene) {
  const Camera& camera = scene.camera;
  const bool asks_mesh = scene.occlusion.test == nullptr && !scene.occlusion.nothing_hides;
  const float tan_half_vertical =
      camera.tan_half_horizontal * static_cast<float>(camera.height_px) / static_cast<float>(camera.width_px);
  for (const auto& mesh : scene.objects.meshes())
    for (const Eigen::Vector3f& corner_m : mesh->positions_m) {
      const Eigen::Vector3f local = camera.axes.transpose() * corner_m;
      const bool in_view =
          camera.directions ||
          (local.z() < 0.0F && std::abs(local.x()) <= -local.z() * camera.tan_half_horizontal &&
           std::abs(local.y()) <= -local.z() * tan_half_vertical);
      const float distance_m = corner_m.norm();
      if (in_view && distance_m > 0.0F &&
          !(asks_mesh &&
            scene.depth.occluded({Eigen::Vector3f::Zero(), corner_m / distance_m, 0.999F * distance_m})))
        return true;
    }
  return false;
}

}  // namespace

Camera preview_sized(const Camera& camera, int width_px) {
  Camera small = camera;
  small.width_px = std::min(width_px, camera.width_px);
  small.height_px = std::max(
      1, static_cast<int>(std::lround(double{1} * small.width_px * camera.height_px / camera.width_px)));
  if (camera.directions) {
    const float across = static_cast<float>(camera.width_px) / static_cast<float>(small.width_px);
    const float down = static_cast<float>(camera.height_px) / static_cast<float>(small.height_px);
    small.directions =
        std::make_shared<const ImageDirections>([large = camera.directions, across, down](float x, float y) {
          return (*large)(x * across, y * down);
        });
  }
  return small;
}

bool may_change(const PhotoScene& scene, const ObjectSight& sight, int threads) {
  const bool mesh_hides = scene.occlusion.test == nullptr && !scene.occlusion.nothing_hides;
  if ((mesh_hides ? sight.visible_pixels : sight.pixels) > 0 || shows_object_corner(scene)) return true;
  if (!scene.shadows) return false;
  const Camera camera = preview_sized(scene.camera, change_probe_width_px);
  const Image photograph(camera.width_px, camera.height_px, 3, 1.0F);
  const PhotoScene small{.photograph = photograph,
                         .camera = camera,
                         .depth = scene.depth,
                         .objects = scene.objects,
                         .light = scene.light,
                         .occlusion = scene.occlusion,
                         .shadow_matte = scene.shadow_matte,
                         .added = scene.added};
  PhotoSums sums = empty_photo_sums(small, threads);
  add_photo_samples(small, 0, {.spp = change_probe_spp, .seed = 1, .threads = threads, .progress = {}}, sums);
  double light = 0, change = 0;
  for (std::size_t half = 0; half < 2; ++half)
    for (std::size_t i = 0; i < sums.halves[half].size(); ++i) {
      const StimulusPixel& pixel = sums.halves[half][i];
      light += double{pixel.without_object.mean()};
      change += double{pixel.object.mean()} + double{(pixel.with_object - pixel.without_object).abs().mean()};
      if (!sums.added[half].empty()) change += double{sums.added[half][i].sent.mean()};
    }
  return change > least_probed_change * light;
}

}  // namespace seamline::renderer
