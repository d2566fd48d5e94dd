#include "renderer/estimators/rig_photograph.h"

#include "raytracer/common/parallel.h"
#include "raytracer/common/sampler.h"
#include "renderer/transport/transport.h"
#include "support/running/interrupt.h"

namespace seamline::renderer {

namespace {

/// `ray_of`: of a pixel and a sample within it; none: the lens shows nothing there.
template <class RayOf>
Image photograph_along(const Geometry& scene, const Light& light, int width_px, int height_px,
                       const PhotographOptions& options, const RayOf& ray_of) {
  Image picture(width_px, height_px, 3);
  const auto radiance = [&](int x, int y, const Sampler& sampler) -> Rgb {
    const std::optional<Ray> found = ray_of(x, y, sampler);
    if (!found) return Rgb::Zero();
    const Ray& ray = *found;
    const auto point = scene.nearest(ray);
    if (!point) return light.sky(ray.direction);
    return radiance_with_and_without(scene, nullptr, *point, light, sampler).without_object.total();
  };
  parallel_for(
      height_px, options.threads,
      [&](int y) {
        for (int x = 0; x < width_px; ++x) {
          stop_if_interrupted();  // a row of thousands of samples takes seconds
          Rgb sum = Rgb::Zero();
          for (int i = 0; i < options.spp; ++i) sum += radiance(x, y, Sampler(options.seed, x, y, i));
          picture.set_rgb(x, y, sum / static_cast<float>(options.spp));
        }
      },
      [&](int rows) {
        if (options.progress) options.progress(static_cast<double>(rows) / height_px);
      });
  return picture;
}

}  // namespace

Image photograph_scene(const Geometry& scene, const Light& light, const sensors::PinholeCamera& camera,
                       const Eigen::Isometry3d& world_from_camera, const PhotographOptions& options) {
  const Eigen::Vector3f origin_m = world_from_camera.translation().cast<float>();
  const auto ray_of = [&](int x, int y, const Sampler& sampler) -> std::optional<Ray> {
    const Eigen::Array2f within = sampler.point(dimension::pixel);
    const auto direction = sensors::direction_through(
        camera, {x + static_cast<double>(within[0]), y + static_cast<double>(within[1])});
    if (!direction) return std::nullopt;
    return Ray{origin_m, (world_from_camera.linear() * *direction).normalized().cast<float>()};
  };
  return photograph_along(scene, light, camera.width_px, camera.height_px, options, ray_of);
}

Image photograph_scene(const Geometry& scene, const Light& light, const Camera& camera,
                       const PhotographOptions& options) {
  const auto ray_of = [&](int x, int y, const Sampler& sampler) -> std::optional<Ray> {
    return camera_ray(camera, x, y, sampler);
  };
  return photograph_along(scene, light, camera.width_px, camera.height_px, options, ray_of);
}

}  // namespace seamline::renderer
