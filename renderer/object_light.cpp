#include "renderer/object_light.h"

#include "renderer/leaving_ray.h"
#include "renderer/omissions.h"

namespace seamline {
namespace {

/// Rays that ask whether light from outside reaches points of the object: past the object itself, and past
/// the real world.
class LightRays {
 public:
  LightRays(const Geometry& object, std::span<Rgb> direct) : object_(object), direct_(direct) {}

  void add(std::size_t index, const ObjectPoint& asked, const Eigen::Vector3f& direction, float far_m,
           const Rgb& radiance) {
    if (!above_horizon(*asked.lit_past.start, direction)) return;
    own_.push_back(leaving_ray(*asked.point, direction, far_m));
    real_.push_back(leaving_ray(*asked.lit_past.start, direction, far_m));
    arriving_.push_back({index, radiance});
  }

  /// Adds the light of the rays that nothing blocks, and begins anew.
  void trace(const Geometry& real, Coherence coherence) {
    drop_blocked(object_, own_, coherence);
    drop_blocked(real, real_, coherence);
    for (const Arriving& light : arriving_) direct_[light.index] += light.radiance;
    own_.clear(), real_.clear(), arriving_.clear();
  }

 private:
  struct Arriving {
    std::size_t index;
    Rgb radiance;
  };

  void drop_blocked(const Geometry& geometry, const std::vector<Ray>& rays, Coherence coherence) {
    blocked_.resize(rays.size());
    geometry.occluded(rays, blocked_, coherence);
    std::size_t left = 0;
    for (std::size_t i = 0; i < blocked_.size(); ++i) {
      if (blocked_[i] != 0) continue;
      own_[left] = own_[i], real_[left] = real_[i], arriving_[left] = arriving_[i];
      ++left;
    }
    own_.resize(left), real_.resize(left), arriving_.resize(left);
  }

  const Geometry& object_;
  std::span<Rgb> direct_;
  std::vector<Ray> own_, real_;
  std::vector<Arriving> arriving_;
  std::vector<std::uint8_t> blocked_;
};

}  // namespace

void direct_on_object(std::span<const ObjectPoint> points, const Geometry& object, const Light& light,
                      std::span<Rgb> direct) {
  std::fill(direct.begin(), direct.end(), Rgb::Zero());
  if (points.empty()) return;
  const Geometry& real = *points.front().lit_past.geometry;
  LightRays rays(object, direct);
  for (const Sun& sun : light.suns)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SurfacePoint& point = *points[i].point;
      const Eigen::Vector3f to_sun = direction_to_sun(sun, points[i].sampler.point(dimension::sun(0)));
      if (const float cosine = sun_cosine(point, to_sun); cosine > 0.0F)
        rays.add(i, points[i], to_sun, endless, point.albedo * sun.irradiance_w_m2 * (inverse_pi * cosine));
    }
  rays.trace(real, Coherence::together);
  if (light.skips_sky) {
    omitted_rays.dark_sky_rays += static_cast<std::int64_t>(points.size());
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = *points[i].point;
    const Eigen::Array2f sky_point = points[i].sampler.point(dimension::direction(0));
    const Rgb sky = point.albedo * light.environment_radiance / static_cast<float>(light.sky_rays);
    for (int number = 0; number < light.sky_rays; ++number) {
      const Eigen::Vector3f direction = turned_direction(point.normal, sky_point, number, light.sky_rays);
      if (above_horizon(point, direction)) rays.add(i, points[i], direction, light.sky_distance_m, sky);
    }
  }
  rays.trace(real, Coherence::scattered);
}

}  // namespace seamline
