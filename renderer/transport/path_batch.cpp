#include "renderer/transport/path_batch.h"

#include <algorithm>
#include <bit>

#include "renderer/tracing/surface_point.h"

namespace seamline::renderer {

void PathBatch::begin(const Worlds& worlds, const Light& light) {
  worlds_ = &worlds;
  light_ = &light;
  emits_ = worlds.emits();
  starts_.clear();
}

std::span<const PathLight> PathBatch::trace() {
  found_.assign(starts_.size(), {});
  vertices_.clear();
  for (std::size_t path = 0; path < starts_.size(); ++path) {
    const PathStart& start = starts_[path];
    add(path, start.set, true, start.point.emission);
    vertices_.push_back({path, start.set, start.point, start.point.albedo});
  }
  std::int64_t rays_before_tails = 0;
  for (int vertex = 0; !vertices_.empty(); ++vertex) {
    for (const Sun& sun : light_->suns) add_sun(sun, vertex);
    if (vertex == 1) {
      thin_tails();
      rays_before_tails = counts_.traced;
    }
    if (vertex == 0) add_sky_of_first();
    if (vertex == 0 && ends_at_sky(0)) return found_;
    go_on(vertex);
    if (vertex > 0 && vertices_.empty()) counts_.tail_rays += counts_.traced - rays_before_tails;
  }
  return found_;
}

/// A point of [0, 1)^2 for each vertex.
void PathBatch::find_points(int dimension) {
  points_.clear();
  for (const Vertex& vertex : vertices_) points_.push_back(starts_[vertex.path].sampler.point(dimension));
}

void PathBatch::add_sun(const Sun& sun, int vertex) {
  if (sun.angular_radius_rad > 0.0F)
    find_points(dimension::sun(vertex));
  else
    points_.assign(vertices_.size(), Eigen::Array2f::Zero());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Eigen::Vector3f to_sun = direction_to_sun(sun, points_[i]);
    if (const float cosine = sun_cosine(vertices_[i].point, to_sun); cosine > 0.0F)
      ask(vertices_[i], leaving_ray(vertices_[i].point, to_sun, endless),
          vertices_[i].throughput * sun.irradiance_w_m2 * (inverse_pi * cosine), vertex == 0);
  }
  add_what_arrives(vertex == 0 ? Coherence::together : Coherence::scattered);
}

/// The sky that first vertices see beside the ray on which their path goes on; that one too, when there is
/// nothing but the sky to look for.
void PathBatch::add_sky_of_first() {
  const bool goes_on = !ends_at_sky(0);
  if (light_->skips_sky) {
    if (!goes_on) counts_.dark_sky_rays += static_cast<std::int64_t>(vertices_.size());
    return;
  }
  if (goes_on && light_->sky_rays <= 1) return;
  find_points(dimension::direction(0));
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vertex& vertex = vertices_[i];
    const bool joins_bounce = starts_[vertex.path].rules.sky_joins_bounce;
    const int rays = joins_bounce ? 1 : light_->sky_rays;
    const Rgb sky = vertex.throughput * light_->environment_radiance / static_cast<float>(rays);
    for (int number = goes_on ? 1 : 0; number < rays; ++number) {
      const Eigen::Vector3f direction = turned_direction(vertex.point.normal, points_[i], number, rays);
      if (above_horizon(vertex.point, direction))
        ask(vertex, leaving_ray(vertex.point, direction, light_->sky_distance_m), sky, !joins_bounce);
    }
  }
  add_what_arrives(Coherence::scattered);
}

/// Leaves only the paths with a tail.
void PathBatch::thin_tails() {
  std::size_t left = 0;
  for (const Vertex& vertex : vertices_) {
    const PathRules& rules = starts_[vertex.path].rules;
    if (!rules.has_tail) continue;
    vertices_[left] = vertex;
    vertices_[left++].throughput *= rules.tail_weight;
  }
  counts_.tails_traced += static_cast<std::int64_t>(left);
  counts_.tails_left_out += static_cast<std::int64_t>(vertices_.size() - left);
  vertices_.resize(left);
}

/// From every vertex to the surface that its path meets next, or to the sky.
void PathBatch::go_on(int vertex) {
  find_points(dimension::direction(vertex));
  const bool only_sky = ends_at_sky(vertex);
  if (only_sky && light_->skips_sky) {
    counts_.dark_sky_rays += static_cast<std::int64_t>(vertices_.size());
    vertices_.clear();
    return;
  }
  rays_.clear();
  vertex_of_ray_.clear();
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vertex& from = vertices_[i];
    const Eigen::Vector3f direction = cosine_direction(from.point.normal, points_[i]);
    if (!above_horizon(from.point, direction)) continue;
    const Ray ray = leaving_ray(from.point, direction, light_->sky_distance_m);
    if (only_sky) {
      ask(from, ray, from.throughput * light_->environment_radiance, false);
    } else {
      rays_.push_back(ray);
      vertex_of_ray_.push_back(i);
    }
  }
  next_vertices_.clear();
  if (only_sky) {
    add_what_arrives(Coherence::scattered);
  } else {
    hits_.resize(rays_.size());
    worlds_->room->nearest(rays_, hits_, Coherence::scattered, &counts_);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const Vertex& from = vertices_[vertex_of_ray_[i]];
      worlds_->nearest_past_room(
          rays_[i], hits_[i], from.set,
          [&](WorldSet set, const std::optional<SurfacePoint>& hit) { meet(from, set, hit, vertex); },
          &counts_);
    }
    rays_.clear();
  }
  std::swap(vertices_, next_vertices_);
}

/// What a path finds at the end of a ray that left its vertex.
void PathBatch::meet(const Vertex& from, WorldSet set, const std::optional<SurfacePoint>& hit, int vertex) {
  const PathRules& rules = starts_[from.path].rules;
  if (!hit) {
    const bool direct = vertex == 0 && !rules.sky_joins_bounce;
    const float rays = direct ? static_cast<float>(light_->sky_rays) : 1.0F;
    add(from.path, set, direct, from.throughput * light_->environment_radiance / rays);
    return;
  }
  if (vertex == 0 && (set & rules.reach_of) != 0)
    found_[from.path].reach_m = std::min(found_[from.path].reach_m, hit->distance_m);
  if (emits_) add(from.path, set, false, from.throughput * hit->emission);
  if (vertex < light_->bounces)
    next_vertices_.push_back({from.path, set, *hit, from.throughput * hit->albedo});
}

void PathBatch::ask(const Vertex& vertex, const Ray& ray, const Rgb& radiance, bool direct) {
  rays_.push_back(ray);
  arriving_.push_back({vertex.path, vertex.set, radiance, direct});
}

/// Asks the rays that only look for light, and begins anew.
void PathBatch::add_what_arrives(Coherence coherence) {
  blocked_.resize(rays_.size());
  worlds_->room->occluded(rays_, blocked_, coherence, &counts_);
  for (std::size_t i = 0; i < rays_.size(); ++i)
    if (blocked_[i] == 0)
      add(arriving_[i].path, worlds_->reached_past_room(rays_[i], arriving_[i].set, &counts_),
          arriving_[i].direct, arriving_[i].radiance);
  rays_.clear();
  arriving_.clear();
}

void PathBatch::add(std::size_t path, WorldSet set, bool direct, const Rgb& radiance) {
  for (unsigned left = set; left != 0; left &= left - 1) {
    Split& light = found_[path].light[static_cast<std::size_t>(std::countr_zero(left))];
    (direct ? light.direct : light.bounce) += radiance;
  }
}

}  // namespace seamline::renderer
