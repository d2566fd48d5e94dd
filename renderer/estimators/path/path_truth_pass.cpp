#include "renderer/estimators/path/path_truth_pass.h"

#include <atomic>

#include "raytracer/common/parallel.h"
#include "renderer/estimators/path/path_emission.h"
#include "renderer/estimators/seen_emission.h"
#include "support/running/interrupt.h"

namespace seamline::renderer {
namespace {

/// Adds one sample of the truth to its pixel's sums. `even_out(front, point)` is called with the surfaces
/// that the sample sees.
template <class EvenOut>
void add_sample(const TruthScene& scene, const ObjectGeometry& geometry, const Ray& ray,
                const Sampler& sampler, const EvenOut& even_out, TruthPixel& sums, RayCounts& counts) {
  std::optional<SurfacePoint> real = geometry.truth.nearest(ray, &counts);
  std::optional<SurfacePoint> object =
      geometry.object.nearest({ray.origin_m, ray.direction, real ? real->distance_m : ray.far_m}, &counts);
  const int front = object ? object->object_index : real ? real->object_index : 0;
  if (real) even_out(front, *real);
  if (object) even_out(front, *object);
  if (object) {
    ++sums.covered;
    const RealQuestion truth{&geometry.truth, &*object};
    sums.object += leaving_object(ObjectQuestions::all_of(truth), geometry.object, *object, scene.light,
                                  sampler, &counts);
    sums.behind +=
        real ? radiance_with_and_without(geometry.truth, nullptr, *real, scene.light, sampler, &counts)
                   .without_object.total()
             : scene.light.sky(ray.direction);
  } else if (real) {
    const RadiancePair pair =
        radiance_with_and_without(geometry.truth, &geometry.object, *real, scene.light, sampler, &counts);
    ++sums.uncovered_surfaces;
    sums.without_object += pair.without_object;
    sums.with_object += pair.with_object;
  } else {
    sums.sky += scene.light.sky(ray.direction);
  }
}

std::uint8_t id_at_centre(const ObjectGeometry& geometry, const Ray& ray, Guide& guide, RayCounts& counts) {
  const std::optional<SurfacePoint> real = geometry.truth.nearest(ray, &counts);
  if (real) guide = {real->geometric_normal, real->distance_m};
  const std::optional<SurfacePoint> object =
      geometry.object.nearest({ray.origin_m, ray.direction, real ? real->distance_m : ray.far_m}, &counts);
  return static_cast<std::uint8_t>(object ? object->object_index : (real ? real->object_index : 0));
}

}  // namespace

TruthSums render_truth(const TruthScene& scene, const ObjectGeometry& geometry, const PassOptions& options) {
  return render_truth(scene, geometry, options, nullptr);
}

TruthSums render_truth(const TruthScene& scene, const ObjectGeometry& geometry, const PassOptions& options,
                       const SeenEmission* seen) {
  const Camera& camera = scene.camera;
  TruthSums sums{.width_px = camera.width_px, .height_px = camera.height_px, .spp = options.spp};
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : sums.halves) half.resize(pixels);
  sums.guides.resize(pixels);
  sums.object_ids.resize(pixels);
  std::atomic<std::int64_t> rays = 0;
  const auto row = [&](int y) {
    RayCounts counts;
    for (int x = 0; x < camera.width_px; ++x) {
      stop_if_interrupted();
      const std::size_t pixel = sums.index(x, y);
      sums.object_ids[pixel] = id_at_centre(geometry, centre_ray(camera, x, y), sums.guides[pixel], counts);
      const auto even_out = [&](int front, SurfacePoint& point) {
        if (seen != nullptr) seen->even_out(x, y, front, point);
      };
      for (int sample = 0; sample < options.spp; ++sample) {
        const Sampler sampler(options.seed, x, y, sample);
        add_sample(scene, geometry, camera_ray(camera, x, y, sampler), sampler, even_out,
                   sums.halves[sample % 2][pixel], counts);
      }
    }
    rays += counts.traced;
  };
  parallel_for(camera.height_px, options.threads, row, [&](int rows) {
    if (options.progress) options.progress(static_cast<double>(rows) / camera.height_px);
  });
  sums.rays = rays;
  return sums;
}

SceneReference render_reference(const TruthScene& scene, const PassOptions& options) {
  return render_reference(scene, options, nullptr);
}

SceneReference render_reference(const TruthScene& scene, const PassOptions& options,
                                const SeenEmission* seen) {
  const Camera& camera = scene.camera;
  const Geometry everything = scene.geometry(true, scene.object_indices());
  SceneReference reference{Image(camera.width_px, camera.height_px, 3), click_map(scene), 0};
  std::atomic<std::int64_t> rays = 0;
  const auto row = [&](int y) {
    RayCounts counts;
    for (int x = 0; x < camera.width_px; ++x) {
      stop_if_interrupted();
      Rgb sum = Rgb::Zero();
      for (int sample = 0; sample < options.spp; ++sample) {
        const Sampler sampler(options.seed, x, y, sample);
        const Ray ray = camera_ray(camera, x, y, sampler);
        std::optional<SurfacePoint> point = everything.nearest(ray, &counts);
        if (point && seen != nullptr) seen->even_out(x, y, point->object_index, *point);
        sum += point ? radiance_with_and_without(everything, nullptr, *point, scene.light, sampler, &counts)
                           .without_object.total()
                     : scene.light.sky(ray.direction);
      }
      reference.radiance.set_rgb(x, y, sum / static_cast<float>(options.spp));
    }
    rays += counts.traced;
  };
  parallel_for(camera.height_px, options.threads, row, [&](int rows) {
    if (options.progress) options.progress(static_cast<double>(rows) / camera.height_px);
  });
  reference.rays = rays;
  return reference;
}

}  // namespace seamline::renderer
