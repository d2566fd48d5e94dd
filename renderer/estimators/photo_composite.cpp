#include "renderer/estimators/photo_composite.h"

#include "renderer/common/parallel.h"

namespace seamline::renderer {
namespace {

void add_sample(const Geometry& depth, const Geometry& object, const Light& light, const Ray& ray,
                const Sampler& sampler, const Rgb& photograph, StimulusPixel& out) {
  const std::optional<SurfacePoint> real = depth.nearest(ray);
  if (const auto hit = object.nearest({ray.origin_m, ray.direction, real ? real->distance_m : ray.far_m})) {
    const RealQuestion question{&depth, &*hit};
    out.object += leaving_object(question, question, object, *hit, light, sampler).total();
  } else if (real) {
    const RadiancePair pair = leaving_pair(depth, &object, *real, light, sampler);
    out.without_object += pair.without_object.total();
    out.with_object += pair.with_object.total();
    out.background += photograph;
    ++out.uncovered_surfaces;
  } else {
    out.sky += photograph;
  }
}

}  // namespace

StimulusSums render_onto_photograph(const Image& photograph, const Geometry& depth, const Geometry& object,
                                    const Camera& camera, const Light& light, const PassOptions& options) {
  StimulusSums sums{.width_px = camera.width_px, .height_px = camera.height_px, .spp = options.spp};
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : sums.halves) half.resize(pixels);
  sums.guides.resize(pixels);
  sums.depth_lights_uncovered = true;
  parallel_for(
      camera.height_px, options.threads,
      [&](int y) {
        for (int x = 0; x < camera.width_px; ++x) {
          const std::size_t pixel = photograph.index(x, y) / static_cast<std::size_t>(photograph.channels);
          for (int i = 0; i < options.spp; ++i) {
            const Sampler sampler(options.seed, x, y, i);
            add_sample(depth, object, light, camera_ray(camera, x, y, sampler), sampler, photograph.rgb(x, y),
                       sums.halves[static_cast<std::size_t>(i % 2)][pixel]);
          }
          const auto seen = depth.nearest(centre_ray(camera, x, y));
          if (seen) sums.guides[pixel] = {seen->geometric_normal, seen->distance_m};
        }
      },
      [&](int rows) {
        if (options.progress) options.progress(static_cast<double>(rows) / camera.height_px);
      });
  return sums;
}

}  // namespace seamline::renderer
