#include "renderer/worlds.h"

#include "renderer/leaving_ray.h"
#include "renderer/omissions.h"

namespace seamline {

WorldSet Worlds::reached(const Ray& ray, WorldSet set) const {
  if (room->occluded(ray)) return 0;
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

/// One path through several worlds at once.
class Path {
 public:
  Path(const Worlds& worlds, const Light& light, const Sampler& sampler, const PathPlan& plan,
       WorldLight& out)
      : worlds_(worlds), light_(light), sampler_(sampler), plan_(plan), emits_(worlds.emits()), out_(out) {}

  /// Light scattered by the path's vertex number `vertex` and all later ones.
  void scatter(WorldSet set, const SurfacePoint& point, Rgb throughput, int vertex) {
    throughput *= point.albedo;
    add_suns(set, point, throughput, vertex);
    if (vertex == 0) add_more_sky(set, point, throughput);
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

  /// How far the first ray got; the nearest where worlds differ.
  [[nodiscard]] float reach_m() const { return reach_m_; }

 private:
  /// The ray that leaves a vertex, and what it meets.
  void go_on(WorldSet set, const SurfacePoint& point, const Rgb& throughput, int vertex) {
    const Eigen::Vector3f direction =
        cosine_direction(point.normal, sampler_.point(dimension::direction(vertex)));
    if (!above_horizon(point, direction)) return;
    const Ray ray = leaving_ray(point, direction, light_.sky_distance_m);
    const bool sky_is_direct = vertex == 0 && !plan_.sky_joins_bounce;
    const Rgb sky = throughput * light_.environment_radiance / (sky_is_direct ? sky_rays() : 1.0F);
    if (vertex >= light_.bounces && !emits_) {
      if (light_.skips_sky) {
        ++omitted_rays.dark_sky_rays;
        return;
      }
      add(worlds_.reached(ray, set), sky_is_direct, sky);
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

  [[nodiscard]] float sky_rays() const { return static_cast<float>(light_.sky_rays); }

  /// The sky at the first surface by more rays than the one that goes on.
  void add_more_sky(WorldSet set, const SurfacePoint& point, const Rgb& throughput) {
    if (plan_.sky_joins_bounce) return;
    for (int ray = 1; ray < light_.sky_rays; ++ray) {
      const Eigen::Vector3f direction =
          turned_direction(point.normal, sampler_.point(dimension::direction(0)), ray, light_.sky_rays);
      if (above_horizon(point, direction))
        add(worlds_.reached(leaving_ray(point, direction, light_.sky_distance_m), set), true,
            throughput * light_.environment_radiance / sky_rays());
    }
  }

  void add_suns(WorldSet set, const SurfacePoint& point, const Rgb& throughput, int vertex) {
    for (const Sun& sun : light_.suns) {
      const Eigen::Vector3f to_sun = direction_to_sun(sun, sampler_.point(dimension::sun(vertex)));
      const float cosine = sun_cosine(point, to_sun);
      if (cosine > 0.0F)
        add(worlds_.reached(leaving_ray(point, to_sun, endless), set), vertex == 0,
            throughput * sun.irradiance_w_m2 * (inverse_pi * cosine));
    }
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

float add_leaving(const Worlds& worlds, WorldSet set, const SurfacePoint& point, const Light& light,
                  const Sampler& sampler, const PathPlan& plan, WorldLight& out) {
  for (unsigned left = set; left != 0; left &= left - 1)
    out[static_cast<std::size_t>(std::countr_zero(left))].direct += point.emission;
  Path path(worlds, light, sampler, plan, out);
  path.scatter(set, point, Rgb::Ones(), 0);
  return path.reach_m();
}

}  // namespace seamline
