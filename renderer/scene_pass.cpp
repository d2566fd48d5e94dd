#include "renderer/scene_pass.h"

#include <mutex>

#include "renderer/camera_ray.h"
#include "renderer/parallel.h"

namespace seamline {
namespace {

using Hits = std::array<std::optional<SurfacePoint>, rays_a_call>;

/// Samples one tile.
class TileSampler {
 public:
  TileSampler(const TruthScene& scene, const SceneGeometry& geometry, const ScenePassOptions& options,
              SceneSums& sums, int tile)
      : scene_(scene), geometry_(geometry), options_(options), sums_(sums), tile_(tile) {}

  void add(int from, int to) {
    const TileGrid::Rectangle tile = sums_.grid.rectangle(tile_);
    for (int y = tile.top; y < tile.bottom; ++y)
      for (int x = tile.left; x < tile.right; ++x)
        for (int first = from; first < to; first += static_cast<int>(rays_a_call))
          add_packet(x, y, first, std::min(to, first + static_cast<int>(rays_a_call)));
    if (options_.who_is_in_front)
      for (auto& object : sums_.objects) {
        ObjectTile* there = object[static_cast<std::size_t>(tile_)].get();
        if (there != nullptr) extend_distances(*there, to);
      }
  }

 private:
  void add_packet(int x, int y, int from, int to) {
    const auto count = static_cast<std::size_t>(to - from);
    std::array<Ray, rays_a_call> rays;
    for (std::size_t i = 0; i < count; ++i)
      rays[i] = camera_ray(scene_.camera, x, y, Sampler(options_.seed, x, y, from + static_cast<int>(i)));
    const std::span<const Ray> asked(rays.data(), count);
    geometry_.room.nearest_from_centre(asked, std::span(room_.data(), count));
    find_objects(asked);
    ask_shadow_rays(x, y, from, count);
    for (std::size_t i = 0; i < count; ++i) add_sample(x, y, from + static_cast<int>(i), i);
  }

  /// The shadow rays of what the packet's samples see: those to the sun together, those to the sky together.
  void ask_shadow_rays(int x, int y, int from, std::size_t count) {
    shadow_rays_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const int sample = from + static_cast<int>(i);
      if (const SurfacePoint* front = seen_without(i, 0))
        append_shadow_rays(geometry_.worlds, *front, scene_.light, Sampler(options_.seed, x, y, sample),
                           path_plan(sample, options_.tail_every), shadow_rays_);
      end_of_shadow_rays_[i] = shadow_rays_.size();
    }
    ask_room(true, Coherence::together);
    ask_room(false, Coherence::scattered);
  }

  void ask_room(bool to_sun, Coherence coherence) {
    asked_.clear();
    for (const ShadowRay& shadow_ray : shadow_rays_)
      if (shadow_ray.to_sun == to_sun) asked_.push_back(shadow_ray.ray);
    blocked_.resize(asked_.size());
    geometry_.room.occluded(asked_, blocked_, coherence);
    std::size_t next = 0;
    for (ShadowRay& shadow_ray : shadow_rays_)
      if (shadow_ray.to_sun == to_sun) shadow_ray.room_blocks = blocked_[next++] != 0;
  }

  [[nodiscard]] std::span<const ShadowRay> shadow_rays_of(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : end_of_shadow_rays_[i - 1];
    return std::span(shadow_rays_).subspan(begin, end_of_shadow_rays_[i] - begin);
  }

  /// Most packets meet no object: one question for all three.
  void find_objects(std::span<const Ray> rays) {
    const std::span any(objects_[0].data(), rays.size());
    geometry_.objects.nearest_from_centre(rays, any);
    const bool none = std::none_of(any.begin(), any.end(), [](const auto& hit) { return hit.has_value(); });
    for (std::size_t k = 0; k < 3; ++k) {
      const std::span hits(objects_[k].data(), rays.size());
      if (none)
        std::fill(hits.begin(), hits.end(), std::nullopt);
      else
        geometry_.alone[k].nearest_from_centre(rays, hits);
    }
  }

  /// The nearest surface of sample `i` when `left_out` (0 to 3, 0: none) is not there.
  const SurfacePoint* seen_without(std::size_t i, int left_out) const {
    const SurfacePoint* nearest = room_[i] ? &*room_[i] : nullptr;
    for (int k = 1; k <= 3; ++k) {
      const auto& hit = objects_[static_cast<std::size_t>(k - 1)][i];
      if (k != left_out && hit && (nearest == nullptr || hit->distance_m < nearest->distance_m))
        nearest = &*hit;
    }
    return nearest;
  }

  void add_sample(int x, int y, int sample, std::size_t i) {
    const std::size_t pixel = sums_.index(x, y);
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const auto half = static_cast<std::size_t>(sample % 2);
    const Sampler sampler(options_.seed, x, y, sample);
    const PathPlan plan = path_plan(sample, options_.tail_every);
    WorldSums& world = sums_.halves[half][pixel];
    const SurfacePoint* front = seen_without(i, 0);
    const int object = front == nullptr ? 0 : front->object_index;
    if (front != nullptr) {
      const WorldSet set = geometry_.worlds.all() & ~(object == 0 ? 0 : only_world(object));
      Shaded seen;
      seen.reach_m = add_leaving(geometry_.worlds, set, *front, scene_.light, sampler, plan,
                                 shadow_rays_of(i), seen.light);
      for (int v = 0; v <= 3; ++v)
        if (object == 0 || v != object) see(world, v, seen, pixel, *front);
      if (object != 0) {
        ObjectTile& there = object_tile(object);
        ObjectSums& own = there.halves[half][place];
        own.object += seen.light[0];
        own.covered += 1.0F;
        there.guides[place].add(*front, seen.reach_m);
        add_behind(world, own, object, pixel, i, sampler, plan);
      }
    }
    if (options_.who_is_in_front) add_order(place, sample, half, i, object, sampler, plan);
  }

  /// What an object in front covers.
  void add_behind(WorldSums& world, ObjectSums& own, int object, std::size_t pixel, std::size_t i,
                  const Sampler& sampler, const PathPlan& plan) {
    const SurfacePoint* behind = seen_without(i, object);
    if (behind == nullptr) return;
    const WorldSet set = only_world(object) | (options_.who_is_in_front ? only_world(0) : 0);
    PathPlan own_reach = plan;  // what else is kept must not change what guides the filter
    own_reach.reach_of = only_world(object);
    const Shaded seen = shade(set, *behind, sampler, own_reach);
    see(world, object, seen, pixel, *behind);
    own.behind += seen.light[static_cast<std::size_t>(object)];
    own.behind_with += seen.light[0];
    own.behind_surfaces += 1.0F;
  }

  /// Who is in front of whom, and the light of an object that something covers.
  void add_order(std::size_t place, int sample, std::size_t half, std::size_t i, int front_object,
                 const Sampler& sampler, const PathPlan& plan) {
    for (int k = 1; k <= 3; ++k) {
      const auto& hit = objects_[static_cast<std::size_t>(k - 1)][i];
      if (!hit) continue;
      ObjectTile& there = object_tile(k);
      extend_distances(there, sample + 1);
      const std::size_t at = static_cast<std::size_t>(sample) * tile_pixels + place;
      there.object_m[at] = hit->distance_m;
      const SurfacePoint* real = seen_without(i, k);
      if (real != nullptr) there.real_m[at] = real->distance_m;
      if (k == front_object) continue;
      ObjectSums& own = there.halves[half][place];
      own.hidden += shade(only_world(0), *hit, sampler, plan).light[0];
      own.hidden_samples += 1.0F;
    }
  }

  struct Shaded {
    WorldLight light = {};
    float reach_m = 0;
  };
  Shaded shade(WorldSet set, const SurfacePoint& point, const Sampler& sampler, const PathPlan& plan) const {
    Shaded shaded;
    shaded.reach_m = add_leaving(geometry_.worlds, set, point, scene_.light, sampler, plan, shaded.light);
    return shaded;
  }

  void see(WorldSums& sums, int world, const Shaded& shaded, std::size_t pixel, const SurfacePoint& point) {
    const auto v = static_cast<std::size_t>(world);
    sums.seen[v] += shaded.light[v];
    sums.surfaces[v] += 1.0F;
    if (world > 0) sums_.guides[v - 1][pixel].add(point, shaded.reach_m);
  }

  ObjectTile& object_tile(int object) {
    auto& there = sums_.objects[static_cast<std::size_t>(object - 1)][static_cast<std::size_t>(tile_)];
    if (!there) {
      there = std::make_unique<ObjectTile>();
      for (auto& half : there->halves) half.resize(tile_pixels);
      there->guides.resize(tile_pixels);
    }
    return *there;
  }

  static void extend_distances(ObjectTile& tile, int samples) {
    const std::size_t size = static_cast<std::size_t>(samples) * tile_pixels;
    if (tile.object_m.size() >= size) return;
    tile.object_m.resize(size, std::numeric_limits<float>::infinity());
    tile.real_m.resize(size, std::numeric_limits<float>::infinity());
  }

  const TruthScene& scene_;
  const SceneGeometry& geometry_;
  const ScenePassOptions& options_;
  SceneSums& sums_;
  int tile_;
  Hits room_;
  std::array<Hits, 3> objects_;
  std::vector<ShadowRay> shadow_rays_;                            ///< of the rays_a_call, sample by sample
  std::array<std::size_t, rays_a_call> end_of_shadow_rays_ = {};  ///< of each sample
  std::vector<Ray> asked_;
  std::vector<std::uint8_t> blocked_;
};

}  // namespace

SceneSums empty_sums(const Camera& camera) {
  SceneSums sums;
  sums.grid = {camera.width_px, camera.height_px};
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : sums.halves) half.resize(pixels);
  for (auto& guides : sums.guides) guides.resize(pixels);
  for (auto& object : sums.objects) object.resize(static_cast<std::size_t>(sums.grid.count()));
  sums.spp.resize(static_cast<std::size_t>(sums.grid.count()));
  return sums;
}

void add_samples(const TruthScene& scene, const SceneGeometry& geometry, const std::vector<int>& wanted_spp,
                 const ScenePassOptions& options, SceneSums& sums) {
  std::mutex counting;
  const int tiles = sums.grid.count();
  const auto work = [&](int tile) {
    int& spp = sums.spp[static_cast<std::size_t>(tile)];
    const int wanted = wanted_spp[static_cast<std::size_t>(tile)];
    if (wanted <= spp) return;
    const std::int64_t before = rays_traced_by_this_thread();
    const OmittedRays omitted_before = omitted_rays;
    TileSampler(scene, geometry, options, sums, tile).add(spp, wanted);
    spp = wanted;
    const std::lock_guard lock(counting);
    sums.rays += rays_traced_by_this_thread() - before;
    sums.omitted += omitted_rays - omitted_before;
  };
  parallel_for(tiles, options.threads, work, [&](int finished) {
    if (options.progress) options.progress(static_cast<double>(finished) / tiles);
  });
}

}  // namespace seamline
