#include "renderer/estimators/rig_photograph.h"

#include "renderer/common/parallel.h"
#include "renderer/common/sampler.h"
#include "renderer/transport/transport.h"

namespace seamline::renderer {

Image photograph_scene(const Geometry& scene, const Light& light, const sensors::PinholeCamera& camera,
                       const Eigen::Isometry3d& world_from_camera, const PhotographOptions& options) {
  Image picture(camera.width_px, camera.height_px, 3);
  const Eigen::Vector3f origin_m = world_from_camera.translation().cast<float>();
  const auto radiance = [&](int x, int y, const Sampler& sampler) -> Rgb {
    const Eigen::Array2f within = sampler.point(dimension::pixel);
    const auto direction = sensors::direction_through(
        camera, {x + static_cast<double>(within[0]), y + static_cast<double>(within[1])});
    if (!direction) return Rgb::Zero();
    const Ray ray{origin_m, (world_from_camera.linear() * *direction).normalized().cast<float>()};
    const auto point = scene.nearest(ray);
    if (!point) return light.sky(ray.direction);
    return leaving_pair(scene, nullptr, *point, light, sampler).without_object.total();
  };
  parallel_for(
      camera.height_px, options.threads,
      [&](int y) {
        for (int x = 0; x < camera.width_px; ++x) {
          Rgb sum = Rgb::Zero();
          for (int i = 0; i < options.spp; ++i) sum += radiance(x, y, Sampler(options.seed, x, y, i));
          picture.set_rgb(x, y, sum / static_cast<float>(options.spp));
        }
      },
      [&](int rows) {
        if (options.progress) options.progress(static_cast<double>(rows) / camera.height_px);
      });
  return picture;
}

}  // namespace seamline::renderer
