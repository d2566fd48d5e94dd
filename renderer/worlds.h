#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/light.h"
#include "renderer/sampler.h"
#include "renderer/transport.h"

namespace seamline {

/// A set of worlds, bit v for world v.
using WorldSet = std::uint8_t;
[[nodiscard]] constexpr WorldSet only_world(int world) {
  return static_cast<WorldSet>(1U << static_cast<unsigned>(world));
}

/// The worlds that differ by which virtual object is there: world 0 has all objects, world k (1 to 3) lacks
/// object k. One computation serves all of them, because most paths meet no object and are the same in each;
/// they part only where one does (DESIGN section 4: three backgrounds and the reference of a scene rendered
/// jointly).
struct Worlds {
  const Geometry* room = nullptr;              ///< what is in every world
  const Geometry* objects = nullptr;           ///< all objects together
  std::array<const Geometry*, 3> others = {};  ///< [k - 1]: the objects of world k; null: none
  int object_count = 0;

  [[nodiscard]] WorldSet all() const { return static_cast<WorldSet>((1U << (object_count + 1)) - 1U); }
  [[nodiscard]] bool emits() const { return room->emits() || objects->emits(); }

  /// The worlds of `set` in which nothing lies on the ray.
  [[nodiscard]] WorldSet reached(const Ray& ray, WorldSet set) const {
    return room->occluded(ray) ? WorldSet{0} : reached_past_room(ray, set);
  }
  /// The same when the room is known not to be in the way.
  [[nodiscard]] WorldSet reached_past_room(const Ray& ray, WorldSet set) const;

  /// Calls `meet(subset, hit)` for subsets that together are `set`: the nearest surface (or none) in all
  /// worlds of the subset.
  template <class Meet>
  void nearest(Ray ray, WorldSet set, Meet&& meet) const {
    const std::optional<SurfacePoint> hit = room->nearest(ray);
    if (hit) ray.far_m = hit->distance_m;
    const std::optional<SurfacePoint> object = objects->nearest(ray);
    if (!object) {
      meet(set, hit);
      return;
    }
    const int lacking = world_without(*object);
    const WorldSet rest = set & only_world(lacking);
    if (set != rest) meet(static_cast<WorldSet>(set & ~rest), object);
    if (rest == 0) return;
    const Geometry* others_there = others[static_cast<std::size_t>(lacking - 1)];
    const std::optional<SurfacePoint> other =
        others_there != nullptr ? others_there->nearest(ray) : std::nullopt;
    meet(rest, other ? other : hit);
  }

  /// The world that lacks the object a point lies on.
  [[nodiscard]] int world_without(const SurfacePoint& object_point) const {
    return object_count == 1 ? 1 : object_point.object_index;
  }
};

/// Light in each world.
using WorldLight = std::array<Split, 4>;

/// How one path is traced. Its tail is what comes after the sun at its second surface: to save rays without
/// bias only every few samples trace it, and then it counts as many times.
struct PathPlan {
  bool has_tail = true;
  float tail_weight = 1.0F;
  bool sky_joins_bounce = false;  ///< the sky at the first surface is added to the light that may be filtered
  WorldSet reach_of = 0xFF;       ///< the worlds whose first hit counts as how far the first ray got
};
/// Every `tail_every`-th sample of each half has a tail.
[[nodiscard]] inline PathPlan path_plan(int sample, int tail_every, bool sky_joins_bounce = false) {
  return {.has_tail = (sample / 2) % tail_every == 0,
          .tail_weight = static_cast<float>(tail_every),
          .sky_joins_bounce = sky_joins_bounce};
}

/// A ray of a path's first vertex that only asks whether something is in the way of sun or sky.
struct ShadowRay {
  Ray ray;
  Rgb radiance = Rgb::Zero();  ///< what the vertex sends to the camera when nothing is
  bool to_sun = false;
  bool direct = true;  ///< light that no filter touches
  bool room_blocks = false;
};

/// Appends the shadow rays of a first vertex, suns before sky; `room_blocks` is yet to be asked. They do not
/// depend on worlds, so that those of many samples can be asked together.
void append_shadow_rays(const Worlds& worlds, const SurfacePoint& point, const Light& light,
                        const Sampler& sampler, const PathPlan& plan, std::vector<ShadowRay>& out);

/// Adds to `out` the radiance that `point`, seen in all worlds of `set`, sends to the camera. The point's own
/// emission counts as direct light, so that no filter of bounce light touches it. One sample. Returns how
/// far its first ray got, infinity for the sky.
float add_leaving(const Worlds& worlds, WorldSet set, const SurfacePoint& point, const Light& light,
                  const Sampler& sampler, const PathPlan& plan, WorldLight& out);
/// The same when the vertex' shadow rays have been asked.
float add_leaving(const Worlds& worlds, WorldSet set, const SurfacePoint& point, const Light& light,
                  const Sampler& sampler, const PathPlan& plan, std::span<const ShadowRay> shadow_rays,
                  WorldLight& out);

}  // namespace seamline
