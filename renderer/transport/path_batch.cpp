#include "renderer/transport/path_batch.h"

#include <algorithm>
#include <bit>

#include "raytracer/light/light_sample.h"
#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {

void PathBatch::begin(const Worlds& worlds, const Light& light) {
  worlds_ = &worlds;
  light_ = &light;
  emits_ = worlds.emits() || light.photographed != nullptr;
  glossy_ = worlds.room->is_glossy() || worlds.objects->is_glossy();
  starts_.clear();
}

std::span<const PathLight> PathBatch::trace() {
  const std::size_t worlds = worlds_->count();
  lights_.assign(starts_.size() * worlds, {});
  found_.assign(starts_.size(), {});
  for (std::size_t path = 0; path < found_.size(); ++path)
    found_[path].light = std::span(lights_).subspan(path * worlds, worlds);
  const bool has_skies = std::any_of(starts_.begin(), starts_.end(), [](const PathStart& start) {
    return start.rules.first_sky == FirstSky::apart;
  });
  skies_.assign(has_skies ? lights_.size() : 0, Rgb::Zero());
  for (std::size_t path = 0; has_skies && path < found_.size(); ++path)
    found_[path].sky = std::span(skies_).subspan(path * worlds, worlds);
  mirrors_ = false;
  mirrored_shares_.clear();
  vertices_.clear();
  for (std::size_t path = 0; path < starts_.size(); ++path) {
    const PathStart& start = starts_[path];
    add(path, start.set, {.as = As::direct, .radiance = start.point.emission});
    vertices_.push_back({path, start.set, start.point, Rgb::Ones()});
  }
  std::int64_t rays_before_tails = 0;
  for (int vertex = 0; !vertices_.empty(); ++vertex) {
    for (int number = 0; number < light_samples(*light_); ++number) add_light_sample(number, vertex);
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

PathBatch::As PathBatch::sky_of_first(const Vertex& vertex) const {
  if (light_->environment) return As::direct;
  switch (starts_[vertex.path].rules.first_sky) {
    case FirstSky::direct:
      return As::direct;
    case FirstSky::bounce:
      return As::bounce;
    case FirstSky::apart:
      return As::sky;
  }
  return As::direct;
}

/// Suns in the first surface: highlights, which are direct light.
Rgb PathBatch::first_suns(const Vertex& vertex, const Eigen::Vector3f& direction) const {
  return starts_[vertex.path].rules.without_first_suns ? Rgb::Zero()
                                                       : suns_found(*light_, vertex.point, direction);
}

/// A point of [0, 1)^2 for each vertex.
void PathBatch::find_points(int dimension) {
  points_.clear();
  for (const Vertex& vertex : vertices_) points_.push_back(starts_[vertex.path].sampler.point(dimension));
}

/// One kind of light at all vertices: rays to a sun lie together.
void PathBatch::add_light_sample(int number, int vertex) {
  const EmissionHits hits = worlds_->room->emits() ? EmissionHits::found : EmissionHits::unknown;
  for (const Vertex& at : vertices_) {
    if (asks_sun_elsewhere(at, number, vertex)) continue;
    if (const auto from_light = light_sample(*light_, number, at.point, at.throughput,
                                             starts_[at.path].sampler, vertex, hits, SunHits::found))
      ask(at, leaving_ray(at.point, from_light->direction, from_light->far_m),
          vertex == 0 ? FoundLight{As::direct, from_light->radiance, from_light->mirrored}
                      : sorted(at.path, As::bounce, from_light->total()));
  }
  const bool together = vertex == 0 && number < static_cast<int>(light_->suns.size());
  add_what_arrives(together ? Coherence::together : Coherence::scattered);
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
    const As as = sky_of_first(vertex);
    const int rays = as == As::direct ? light_->sky_rays : 1;
    const auto share = static_cast<float>(rays);
    if (!goes_on) {
      if (const auto next = scatter(*light_, vertex.point, points_[i])) {
        const Rgb sky = vertex.throughput * sky_found(*light_, vertex.point, next->direction);
        ask(vertex, leaving_ray(vertex.point, next->direction, light_->sky_distance_m),
            {.as = as, .radiance = sky * next->diffuse() / share, .mirrored = sky * next->specular});
        const Rgb suns = first_suns(vertex, next->direction);
        if ((suns > 0.0F).any())
          ask(vertex, leaving_ray(vertex.point, next->direction, light_->sky_distance_m),
              {.as = As::direct, .radiance = vertex.throughput * next->weight * suns});
      }
    }
    for (int number = 1; number < rays; ++number) {
      const Eigen::Vector3f chosen = turned_direction(vertex.point.normal, points_[i], number, rays);
      const Eigen::Vector3f direction = leaving_direction(vertex.point, chosen);
      if (above_horizon(vertex.point, direction))
        ask(vertex, leaving_ray(vertex.point, direction, light_->sky_distance_m),
            {.as = as,
             .radiance =
                 vertex.throughput * diffuse_weight(vertex.point, chosen) * light_->sky(direction) / share});
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
    Vertex& from = vertices_[i];
    const auto next = scatter(*light_, from.point, points_[i]);
    if (!next) continue;
    from.throughput *= next->weight;
    from.spread = next->spread;
    if (glossy_ && vertex == 0 && (next->specular > 0.0F).any()) {
      mirrors_ = true;
      mirrored_shares_.resize(starts_.size(), Rgb::Zero());
      mirrored_shares_[from.path] = next->mirrored_share();
    }
    const Ray ray = leaving_ray(from.point, next->direction, light_->sky_distance_m);
    if (only_sky) {
      ask(from, ray,
          sorted(from.path, As::bounce,
                 from.throughput * (sky_found(*light_, from.point, next->direction) +
                                    suns_found(*light_, from.point, next->direction))));
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
          [&](WorldSet set, const std::optional<SurfacePoint>& hit) {
            meet(from, set, rays_[i].direction, hit, vertex);
          },
          &counts_);
    }
    rays_.clear();
  }
  std::swap(vertices_, next_vertices_);
}

/// What a path finds at the end of a ray that left its vertex, whose throughput is now the ray's.
void PathBatch::meet(const Vertex& from, WorldSet set, const Eigen::Vector3f& direction,
                     const std::optional<SurfacePoint>& hit, int vertex) {
  const PathRules& rules = starts_[from.path].rules;
  if (!hit) {
    const As as = vertex == 0 ? sky_of_first(from) : As::bounce;
    const float rays = as == As::direct ? static_cast<float>(light_->sky_rays) : 1.0F;
    FoundLight sky = sorted(from.path, as, from.throughput * sky_found(*light_, from.point, direction));
    sky.radiance /= rays;
    add(from.path, set, sky);
    if (!finds_suns(*light_, from.point)) return;
    add(from.path, set,
        vertex == 0
            ? FoundLight{.as = As::direct, .radiance = from.throughput * first_suns(from, direction)}
            : sorted(from.path, As::bounce, from.throughput * suns_found(*light_, from.point, direction)));
    return;
  }
  if (vertex == 0 && (set & rules.reach_of) != 0)
    found_[from.path].reach_m = std::min(found_[from.path].reach_m, hit->distance_m);
  if (emits_) {
    const FoundEmission emission = emission_found(*light_, from.point, direction, *hit);
    add(from.path, set,
        sorted(from.path, emission.is_lamp && vertex == 0 ? As::direct : As::bounce,
               from.throughput * emission.radiance));
  }
  if (vertex >= light_->bounces) return;
  if (sends_photograph(*light_, *hit)) {
    if ((set & only_world(0)) != 0)
      add(from.path, only_world(0),
          sorted(from.path, As::bounce,
                 from.throughput * change_of_sent(*worlds_->room, *worlds_->objects, *hit, *light_,
                                                  starts_[from.path].sampler, vertex, &counts_)));
    return;
  }
  next_vertices_.push_back({from.path, set, *hit, from.throughput});
  if (glossy_) blur_after(from.spread, next_vertices_.back().point);
}

/// Light that a path found, by how it left its first surface.
PathBatch::FoundLight PathBatch::sorted(std::size_t path, As as, const Rgb& light) const {
  if (!mirrors_) return {.as = as, .radiance = light};
  const Rgb mirrored = mirrored_shares_[path] * light;
  return {.as = as, .radiance = light - mirrored, .mirrored = mirrored};
}

void PathBatch::ask(const Vertex& vertex, const Ray& ray, const FoundLight& light) {
  rays_.push_back(ray);
  arriving_.push_back({vertex.path, vertex.set, light});
}

/// Asks the rays that only look for light, and begins anew.
void PathBatch::add_what_arrives(Coherence coherence) {
  blocked_.resize(rays_.size());
  worlds_->room->occluded(rays_, blocked_, coherence, &counts_);
  for (std::size_t i = 0; i < rays_.size(); ++i)
    if (blocked_[i] == 0)
      add(arriving_[i].path, worlds_->reached_past_room(rays_[i], arriving_[i].set, &counts_),
          arriving_[i].light);
  rays_.clear();
  arriving_.clear();
}

void PathBatch::add(std::size_t path, WorldSet set, const FoundLight& found) {
  for (unsigned left = set; left != 0; left &= left - 1) {
    const auto world = static_cast<std::size_t>(std::countr_zero(left));
    Split& light = found_[path].light[world];
    switch (found.as) {
      case As::direct:
        light.direct += found.radiance;
        break;
      case As::bounce:
        light.bounce += found.radiance;
        break;
      case As::sky:
        found_[path].sky[world] += found.radiance;
        break;
    }
    if (glossy_) light.mirrored += found.mirrored;
  }
}

}  // namespace seamline::renderer
