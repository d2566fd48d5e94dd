#include "renderer/estimators/photo_composite.h"

#include "renderer/common/parallel.h"

namespace seamline::renderer {
namespace {

/// Where a sample of a pixel is in the picture, and its ray.
struct Sight {
  Eigen::Array2f position_px;
  Ray ray;
};

Sight sight_of(const PhotographCamera& camera, int x, int y, const Eigen::Array2f& within) {
  const Eigen::Array2f at(static_cast<float>(x) + within[0], static_cast<float>(y) + within[1]);
  return {at, {Eigen::Vector3f::Zero(), camera.direction(at[0], at[1])}};
}

/// The object where it is seen: nearer than the mesh, or not hidden by what else decides.
std::optional<SurfacePoint> seen_object(const Geometry& object, const Sight& sight,
                                        const std::optional<SurfacePoint>& real, const Occlusion& occlusion) {
  const Ray& ray = sight.ray;
  const bool mesh_hides = !occlusion.hides && real;
  const auto hit = object.nearest({ray.origin_m, ray.direction, mesh_hides ? real->distance_m : ray.far_m});
  if (hit && occlusion.hides &&
      occlusion.hides(sight.position_px[0], sight.position_px[1],
                      ray.origin_m + hit->distance_m * ray.direction))
    return std::nullopt;
  return hit;
}

void add_sample(const Geometry& depth, const Geometry& object, const Light& light, const Sight& sight,
                const Sampler& sampler, const Rgb& photograph, const Occlusion& occlusion,
                StimulusPixel& out) {
  if (sight.ray.direction.isZero()) {
    out.sky += photograph;
    return;
  }
  const std::optional<SurfacePoint> real = depth.nearest(sight.ray);
  if (const auto hit = seen_object(object, sight, real, occlusion)) {
    const RealQuestion question{occlusion.real_shades_object ? &depth : &object, &*hit};
    out.object += leaving_object(ObjectQuestions::all_of(question), object, *hit, light, sampler).total();
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

PhotographCamera photograph_camera(const Camera& camera) {
  return {camera.width_px, camera.height_px, [camera](float x, float y) { return camera.direction(x, y); }};
}

StimulusSums render_onto_photograph(const Image& photograph, const Geometry& depth, const Geometry& object,
                                    const PhotographCamera& camera, const Light& light,
                                    const PassOptions& options, const Occlusion& occlusion) {
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
            add_sample(depth, object, light, sight_of(camera, x, y, sampler.point(dimension::pixel)), sampler,
                       photograph.rgb(x, y), occlusion, sums.halves[static_cast<std::size_t>(i % 2)][pixel]);
          }
          const Ray centre = sight_of(camera, x, y, Eigen::Array2f(0.5F, 0.5F)).ray;
          const auto seen = centre.direction.isZero() ? std::nullopt : depth.nearest(centre);
          if (seen) sums.guides[pixel] = {seen->geometric_normal, seen->distance_m};
        }
      },
      [&](int rows) {
        if (options.progress) options.progress(static_cast<double>(rows) / camera.height_px);
      });
  return sums;
}

}  // namespace seamline::renderer
