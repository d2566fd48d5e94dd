#include "renderer/estimators/fast/fast_truth_pass.h"
#include "raytracer/scene/panorama_camera.h"

#include <mutex>

#include "raytracer/common/parallel.h"
#include "raytracer/scene/camera.h"
#include "renderer/estimators/seen_emission.h"
#include "renderer/transport/path_batch.h"

namespace seamline::renderer {
namespace {

using Hits = std::array<std::optional<SurfacePoint>, rays_a_call>;

/// Samples one tile: looks at a few samples of a pixel at a time, and follows the paths of several such looks
/// together.
class TileSampler {
 public:
  TileSampler(const TruthScene& scene, const SceneGeometry& geometry, const ScenePassOptions& options,
              SceneSums& sums, int tile)
      : scene_(scene),
        geometry_(geometry),
        options_(options),
        sums_(sums),
        tile_(tile),
        objects_(geometry.alone.size()) {
    paths_.begin(geometry_.worlds, scene_.light);
  }

  /// Adds samples to one of its blocks.
  void add(int block, int from, int to) {
    end_sample_ = to;
    const BlockGrid::Rectangle r = sums_.blocks().rectangle(block);
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        for (int first = from; first < to; first += static_cast<int>(rays_a_call))
          look(x, y, first, std::min(to, first + static_cast<int>(rays_a_call)));
    follow_paths();
  }

  [[nodiscard]] RayCounts counts() const { return counts_ + paths_.counts(); }

 private:
  static constexpr std::size_t paths_at_once = 64;

  /// What a path is followed for.
  enum class LightOf {
    front,   ///< what the camera sees
    behind,  ///< what an object in front covers
    hidden   ///< an object that something covers
  };
  struct Followed {
    LightOf light_of;
    int object;  ///< 0: none
    std::size_t pixel, place, half;
    int x, y;
    int front;  ///< the object that the camera ray meets first; 0: none
  };

  void look(int x, int y, int from, int to) {
    const auto count = static_cast<std::size_t>(to - from);
    std::array<Ray, rays_a_call> rays;
    for (std::size_t i = 0; i < count; ++i)
      rays[i] = camera_ray(scene_.camera, x, y, Sampler(options_.seed, x, y, from + static_cast<int>(i)));
    const std::span<const Ray> asked(rays.data(), count);
    nearest_seen(scene_.camera, geometry_.room, asked, std::span(room_.data(), count), &counts_);
    find_objects(asked);
    if (options_.occlusion != nullptr) drop_hidden(x, y, from, asked);
    for (std::size_t i = 0; i < count; ++i) add_sample(x, y, from + static_cast<int>(i), i);
    if (paths_.size() >= paths_at_once) follow_paths();
  }

  /// Most packets meet no object: one question for all of them.
  void find_objects(std::span<const Ray> rays) {
    const std::span any(objects_[0].data(), rays.size());
    nearest_seen(scene_.camera, geometry_.objects, rays, any, &counts_);
    const bool none = std::none_of(any.begin(), any.end(), [](const auto& hit) { return hit.has_value(); });
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      const std::span hits(objects_[k].data(), rays.size());
      if (none)
        std::fill(hits.begin(), hits.end(), std::nullopt);
      else
        nearest_seen(scene_.camera, geometry_.alone[k], rays, hits, &counts_);
    }
  }

  /// Objects where something that was given says that they are hidden. What is left is in front of the room.
  void drop_hidden(int x, int y, int from, std::span<const Ray> rays) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Sampler sampler(options_.seed, x, y, from + static_cast<int>(i));
      const MaskPlace place{rays[i].direction, camera_place(scene_.camera, x, y, sampler)};
      for (Hits& hits : objects_)
        if (hits[i] && hides(*options_.occlusion, place, hits[i]->distance_m)) hits[i].reset();
    }
  }

  /// The surface that sample `i` shows when `left_out` (0: none) is not there.
  const SurfacePoint* seen_without(std::size_t i, int left_out) const {
    const SurfacePoint* room = room_[i] ? &*room_[i] : nullptr;
    const SurfacePoint* object = nullptr;
    for (int k = 1; k <= geometry_.worlds.object_count; ++k) {
      const auto& hit = objects_[k - 1][i];
      if (k != left_out && hit && (object == nullptr || hit->distance_m < object->distance_m)) object = &*hit;
    }
    if (object == nullptr || room == nullptr) return object != nullptr ? object : room;
    return options_.occlusion != nullptr || object->distance_m < room->distance_m ? object : room;
  }

  void add_sample(int x, int y, int sample, std::size_t i) {
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const auto half = static_cast<std::size_t>(sample % 2);
    const SurfacePoint* front = seen_without(i, 0);
    const int object = front == nullptr ? 0 : front->object_index;
    const Followed seen{LightOf::front, object, sums_.index(x, y), place, half, x, y, object};
    const Sampler sampler(options_.seed, x, y, sample);
    const PathRules rules = path_rules(sampler, options_.tail_every);
    if (front != nullptr) {
      const WorldSet set = geometry_.worlds.all() & ~(object == 0 ? 0 : only_world(object));
      follow(seen, {set, *front, sampler, rules});
    }
    if (object != 0) {
      object_tile(object).halves[half][place].covered += 1.0F;
      add_behind(seen, i, sampler, rules);
    }
    if (options_.who_is_in_front) add_order(seen, {x, y, sample}, i, sampler, rules);
  }

  /// What an object in front covers.
  void add_behind(Followed seen, std::size_t i, const Sampler& sampler, const PathRules& rules) {
    const SurfacePoint* behind = seen_without(i, seen.object);
    if (behind == nullptr) return;
    object_tile(seen.object).halves[seen.half][seen.place].behind_surfaces += 1.0F;
    const WorldSet set = only_world(seen.object) | (options_.who_is_in_front ? only_world(0) : 0);
    PathRules own_reach = rules;  // what else is kept must not change what guides the filter
    own_reach.reach_of = only_world(seen.object);
    seen.light_of = LightOf::behind;
    follow(seen, {set, *behind, sampler, own_reach});
  }

  /// Who is in front of whom, and the light of an object that something covers.
  void add_order(const Followed& seen, const SampleId& id, std::size_t i, const Sampler& sampler,
                 const PathRules& rules) {
    for (int k = 1; k <= geometry_.worlds.object_count; ++k) {
      const auto& hit = objects_[k - 1][i];
      if (!hit) continue;
      ObjectTile& there = object_tile(k);
      const SurfacePoint* real = seen_without(i, k);
      const bool covered = real != nullptr && real->distance_m <= hit->distance_m;
      ObjectOnRays& on_rays = there.on_rays[ObjectTile::block_in_tile(id.x, id.y)];
      on_rays.extend(end_sample_);
      on_rays.set(id.number, id.x, id.y, covered ? ObjectOnRays::Is::covered : ObjectOnRays::Is::in_front);
      if (k == seen.object) continue;
      there.halves[seen.half][seen.place].hidden_samples += 1.0F;
      follow({LightOf::hidden, k, seen.pixel, seen.place, seen.half, id.x, id.y, seen.front},
             {only_world(0), *hit, sampler, rules});
    }
  }

  void follow(const Followed& followed, PathStart start) {
    if (options_.seen != nullptr && followed.light_of != LightOf::hidden)
      options_.seen->even_out(followed.x, followed.y, followed.front, start.point);
    start.rules.first_sky = first_sky(start.point);
    followed_.push_back(followed);
    paths_.add(start);
  }

  /// On an object the sky is kept in its light, because what the depth mesh changes of both is asked for at
  /// once.
  [[nodiscard]] FirstSky first_sky(const SurfacePoint& point) const {
    const bool apart = options_.first_sky == FirstSky::apart;
    return apart && point.object_index != 0 ? FirstSky::direct : options_.first_sky;
  }

  void follow_paths() {
    const std::span<const PathLight> found = paths_.trace();
    for (std::size_t i = 0; i < found.size(); ++i) add_light(followed_[i], paths_.start(i).point, found[i]);
    paths_.begin(geometry_.worlds, scene_.light);
    followed_.clear();
  }

  void add_light(const Followed& followed, const SurfacePoint& point, const PathLight& found) {
    const int object = followed.object;
    ObjectPixel* own = nullptr;
    if (object != 0) own = &object_tile(object).halves[followed.half][followed.place];
    switch (followed.light_of) {
      case LightOf::front:
        for (int v = 0; v <= geometry_.worlds.object_count; ++v)
          if (object == 0 || v != object) see(followed, v, point, found);
        if (object == 0) return;
        own->object += found.light[0];
        if (mirrors()) own_mirrored(followed).object += found.light[0].mirrored;
        object_tile(object).guides[followed.place].add(point, found.reach_m);
        return;
      case LightOf::behind:
        see(followed, object, point, found);
        own->behind += found.light[object];
        own->behind_with += found.light[0];
        if (!found.sky.empty()) {
          ObjectPart& sky = object_tile(object).sky[followed.half][followed.place];
          sky.behind += found.sky[object];
          sky.behind_with += found.sky[0];
        }
        if (!mirrors()) return;
        own_mirrored(followed).behind += found.light[object].mirrored;
        own_mirrored(followed).behind_with += found.light[0].mirrored;
        return;
      case LightOf::hidden:
        own->hidden += found.light[0];
        if (mirrors()) own_mirrored(followed).hidden += found.light[0].mirrored;
        return;
    }
  }

  void see(const Followed& followed, int world, const SurfacePoint& point, const PathLight& found) {
    const auto v = static_cast<std::size_t>(world);
    const WorldPlace at = sums_.place_of(followed.pixel, v);
    WorldPixel& sums = sums_.halves[followed.half][at.pixel];
    sums.seen[at.world] += found.light[v];
    if (mirrors()) sums_.mirrored[followed.half][at.pixel].seen[at.world] += found.light[v].mirrored;
    if (!found.sky.empty()) sums_.sky[followed.half][at.pixel].seen[at.world] += found.sky[v];
    sums.surfaces[at.world] += 1.0F;
    if (world > 0) sums_.guides[v - 1][followed.pixel].add(point, found.reach_m);
  }

  [[nodiscard]] bool mirrors() const { return !sums_.mirrored[0].empty(); }
  ObjectPart& own_mirrored(const Followed& followed) {
    return object_tile(followed.object).mirrored[followed.half][followed.place];
  }

  ObjectTile& object_tile(int object) {
    auto& there = sums_.objects[object - 1][tile_];
    if (!there) {
      there = std::make_unique<ObjectTile>();
      for (auto& half : there->halves) half.resize(tile_pixels);
      if (mirrors())
        for (auto& half : there->mirrored) half.resize(tile_pixels);
      if (options_.first_sky == FirstSky::apart)
        for (auto& half : there->sky) half.resize(tile_pixels);
      there->guides.resize(tile_pixels);
    }
    return *there;
  }

  const TruthScene& scene_;
  const SceneGeometry& geometry_;
  const ScenePassOptions& options_;
  SceneSums& sums_;
  int tile_;
  int end_sample_ = 0;  ///< of those being added
  Hits room_;
  std::vector<Hits> objects_;  ///< of each object
  RayCounts counts_;           ///< of camera rays
  PathBatch paths_;
  std::vector<Followed> followed_;  ///< of each path
};

}  // namespace

SceneSums empty_sums(const Camera& camera, std::size_t objects) {
  SceneSums sums;
  sums.groups = (objects + worlds_a_group) / worlds_a_group;
  sums.guides.resize(objects);
  sums.objects.resize(objects);
  sums.grid = {camera.width_px, camera.height_px, wraps(camera)};
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : sums.halves) half.resize(pixels * sums.groups);
  for (auto& guides : sums.guides) guides.resize(pixels);
  for (auto& object : sums.objects) object.resize(sums.grid.count());
  sums.spp.resize(static_cast<std::size_t>(sums.blocks().count()));
  return sums;
}

void add_samples(const TruthScene& scene, const SceneGeometry& geometry, const std::vector<int>& wanted_spp,
                 const ScenePassOptions& options, SceneSums& sums) {
  std::mutex counting;
  if (geometry.worlds.room->is_glossy() || geometry.worlds.objects->is_glossy())
    for (std::size_t half = 0; half < 2; ++half) sums.mirrored[half].resize(sums.halves[half].size());
  if (options.first_sky == FirstSky::apart)
    for (std::size_t half = 0; half < 2; ++half) sums.sky[half].resize(sums.halves[half].size());
  const int tiles = sums.grid.count();
  const auto work = [&](int tile) {
    TileSampler sampler(scene, geometry, options, sums, tile);
    for (const int block : blocks_of(sums.grid, tile)) {
      int& spp = sums.spp[block];
      const int wanted = wanted_spp[block];
      if (wanted <= spp) continue;
      sampler.add(block, spp, wanted);
      spp = wanted;
    }
    const std::lock_guard lock(counting);
    sums.counts += sampler.counts();
  };
  parallel_for(tiles, options.threads, work, [&](int finished) {
    if (options.progress) options.progress(static_cast<double>(finished) / tiles);
  });
}

}  // namespace seamline::renderer
