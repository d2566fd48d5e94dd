#include "renderer/worlds.h"

#include "renderer/leaving_ray.h"
#include "renderer/omissions.h"

namespace seamline {

WorldSet Worlds::reached_past_room(const Ray& ray, WorldSet set) const {
  if (!objects->occluded(ray)) return set;
  WorldSet reached = 0;
  for (int world = 1; world <= object_count; ++world) {
    if ((set & only_world(world)) == 0) continue;
    const Geometry* there = others[static_cast<std::size_t>(world - 1)];
    if (there == nullptr || !there->occluded(ray)) reached |= only_world(world);
  }
  return reached;
}

namespace {

/// Whether the ray that leaves a path's vertex only asks for the sky.
bool ends_at_sky(int vertex, const Light& light, bool emits) {
  return vertex >= light.bounces && !emits;
}

/// One path through several worlds at once.
class Path {
 public:
  Path(const Worlds& worlds, const Light& light, const Sampler& sampler, const PathPlan& plan,
       WorldLight& out)
      : worlds_(worlds), light_(light), sampler_(sampler), plan_(plan), emits_(worlds.emits()), out_(out) {}

  /// Light that the first vertex scatters, and all later ones.
  void start(WorldSet set, const SurfacePoint& point, std::span<const ShadowRay> shadow_rays) {
    for (const ShadowRay& asked : shadow_rays)
      if (!asked.room_blocks) add(worlds_.reached_past_room(asked.ray, set), asked.direct, asked.radiance);
    if (!ends_at_sky(0, light_, emits_)) go_on(set, point, point.albedo, 0);
  }

  /// How far the first ray got; the nearest where worlds differ.
  [[nodiscard]] float reach_m() const { return reach_m_; }

 private:
  /// Light scattered by a later vertex and all that follow.
  void scatter(WorldSet set, const SurfacePoint& point, Rgb throughput, int vertex) {
    throughput *= point.albedo;
    for (const Sun& sun : light_.suns) {
      const Eigen::Vector3f to_sun = direction_to_sun(sun, sampler_.point(dimension::sun(vertex)));
      const float cosine = sun_cosine(point, to_sun);
      if (cosine > 0.0F)
        add(worlds_.reached(leaving_ray(point, to_sun, endless), set), false,
            throughput * sun.irradiance_w_m2 * (inverse_pi * cosine));
    }
    if (vertex != 1) {
      go_on(set, point, throughput, vertex);
    } else if (plan_.has_tail) {
      const std::int64_t before = rays_traced_by_this_thread();
      go_on(set, point, throughput * plan_.tail_weight, vertex);
      omitted_rays.tail_rays += rays_traced_by_this_thread() - before;
      ++omitted_rays.tails_traced;
    } else {
      ++omitted_rays.tails_left_out;
    }
  }

  /// The ray that leaves a vertex, and what it meets.
  void go_on(WorldSet set, const SurfacePoint& point, const Rgb& throughput, int vertex) {
    const Eigen::Vector3f direction =
        cosine_direction(point.normal, sampler_.point(dimension::direction(vertex)));
    if (!above_horizon(point, direction)) return;
    const Ray ray = leaving_ray(point, direction, light_.sky_distance_m);
    const bool sky_is_direct = vertex == 0 && !plan_.sky_joins_bounce;
    const Rgb sky = throughput * light_.environment_radiance /
                    (sky_is_direct ? static_cast<float>(light_.sky_rays) : 1.0F);
    if (ends_at_sky(vertex, light_, emits_)) {
      if (light_.skips_sky)
        ++omitted_rays.dark_sky_rays;
      else
        add(worlds_.reached(ray, set), false, sky);
      return;
    }
    worlds_.nearest(ray, set, [&](WorldSet subset, const std::optional<SurfacePoint>& hit) {
      if (vertex == 0 && hit && (subset & plan_.reach_of) != 0)
        reach_m_ = std::min(reach_m_, hit->distance_m);
      if (!hit) {
        add(subset, sky_is_direct, sky);
        return;
      }
      if (emits_) add(subset, false, throughput * hit->emission);
      if (vertex < light_.bounces) scatter(subset, *hit, throughput, vertex + 1);
    });
  }

  void add(WorldSet set, bool direct, const Rgb& radiance) {
    for (unsigned left = set; left != 0; left &= left - 1) {
      Split& light = out_[static_cast<std::size_t>(std::countr_zero(left))];
      (direct ? light.direct : light.bounce) += radiance;
    }
  }

  const Worlds& worlds_;
  const Light& light_;
  const Sampler& sampler_;
  const PathPlan& plan_;
  const bool emits_;
  WorldLight& out_;
  float reach_m_ = endless;
};

}  // namespace

void append_shadow_rays(const Worlds& worlds, const SurfacePoint& point, const Light& light,
                        const Sampler& sampler, const PathPlan& plan, std::vector<ShadowRay>& out) {
  for (const Sun& sun : light.suns) {
    const Eigen::Vector3f to_sun = direction_to_sun(sun, sampler.point(dimension::sun(0)));
    if (const float cosine = sun_cosine(point, to_sun); cosine > 0.0F)
      out.push_back({.ray = leaving_ray(point, to_sun, endless),
                     .radiance = point.albedo * sun.irradiance_w_m2 * (inverse_pi * cosine),
                     .to_sun = true});
  }
  // The first sky ray goes on as the path, unless there is nothing but the sky to look for.
  const bool first_is_shadow_ray = ends_at_sky(0, light, worlds.emits());
  if (first_is_shadow_ray && light.skips_sky) ++omitted_rays.dark_sky_rays;
  const int rays = plan.sky_joins_bounce ? 1 : light.sky_rays;
  const int last = light.skips_sky ? 0 : rays;
  if (last <= 1 && !first_is_shadow_ray) return;
  const Eigen::Array2f sky_point = sampler.point(dimension::direction(0));
  const Rgb sky = point.albedo * light.environment_radiance / static_cast<float>(rays);
  for (int number = first_is_shadow_ray ? 0 : 1; number < last; ++number) {
    const Eigen::Vector3f direction = turned_direction(point.normal, sky_point, number, rays);
    if (above_horizon(point, direction))
      out.push_back({.ray = leaving_ray(point, direction, light.sky_distance_m),
                     .radiance = sky,
                     .direct = !plan.sky_joins_bounce});
  }
}

float add_leaving(const Worlds& worlds, WorldSet set, const SurfacePoint& point, const Light& light,
                  const Sampler& sampler, const PathPlan& plan, std::span<const ShadowRay> shadow_rays,
                  WorldLight& out) {
  for (unsigned left = set; left != 0; left &= left - 1)
    out[static_cast<std::size_t>(std::countr_zero(left))].direct += point.emission;
  Path path(worlds, light, sampler, plan, out);
  path.start(set, point, shadow_rays);
  return path.reach_m();
}

float add_leaving(const Worlds& worlds, WorldSet set, const SurfacePoint& point, const Light& light,
                  const Sampler& sampler, const PathPlan& plan, WorldLight& out) {
  thread_local std::vector<ShadowRay> shadow_rays;
  shadow_rays.clear();
  append_shadow_rays(worlds, point, light, sampler, plan, shadow_rays);
  for (ShadowRay& asked : shadow_rays) asked.room_blocks = worlds.room->occluded(asked.ray);
  return add_leaving(worlds, set, point, light, sampler, plan, shadow_rays, out);
}

}  // namespace seamline
