#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "raytracer/common/sampler.h"
#include "raytracer/light/light.h"
#include "renderer/transport/transport.h"
#include "stimuli/definition/parts/task_definition.h"

namespace seamline::renderer {

/// A set of worlds, bit v for world v.
using WorldSet = std::uint16_t;
static_assert(most_objects_of_scene < 16);
[[nodiscard]] constexpr WorldSet only_world(int world) {
  return static_cast<WorldSet>(1U << static_cast<unsigned>(world));
}

/// The worlds that differ by which virtual object is there: world 0 has all objects, world k (from 1) lacks
/// object k. One computation serves all of them, because most paths meet no object and are the same in each;
/// they part only where one does (documentation/developers/design.md, section 3: the backgrounds and the
/// reference of a scene rendered jointly).
struct Worlds {
  const Geometry* room = nullptr;     ///< what is in every world
  const Geometry* objects = nullptr;  ///< all objects together
  /// [k - 1]: the objects of world k; null: none.
  std::array<const Geometry*, most_objects_of_scene> others = {};
  int object_count = 0;

  /// World 0 and one for each object.
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(object_count) + 1; }

  [[nodiscard]] WorldSet all() const { return static_cast<WorldSet>((1U << (object_count + 1)) - 1U); }
  [[nodiscard]] bool emits() const { return room->emits() || objects->emits(); }

  /// The worlds of `set` in which no object lies on the ray, when nothing of the room does.
  [[nodiscard]] WorldSet reached_past_room(const Ray& ray, WorldSet set, RayCounts* counts = nullptr) const;

  /// Calls `meet(subset, hit)` for subsets that together are `set`: the nearest surface (or none) in all
  /// worlds of the subset. `room_hit`: what the ray meets of the room.
  template <class Meet>
  void nearest_past_room(Ray ray, const std::optional<SurfacePoint>& room_hit, WorldSet set, Meet&& meet,
                         RayCounts* counts = nullptr) const {
    if (room_hit) ray.far_m = room_hit->distance_m;
    const std::optional<SurfacePoint> object = objects->nearest(ray, counts);
    if (!object) {
      meet(set, room_hit);
      return;
    }
    const int lacking = world_without(*object);
    const WorldSet lacking_it = set & only_world(lacking);
    if (set != lacking_it) meet(static_cast<WorldSet>(set & ~lacking_it), object);
    if (lacking_it == 0) return;
    const Geometry* others_there = others[static_cast<std::size_t>(lacking - 1)];
    const std::optional<SurfacePoint> other =
        others_there != nullptr ? others_there->nearest(ray, counts) : std::nullopt;
    meet(lacking_it, other ? other : room_hit);
  }

  /// The world that lacks the object a point lies on.
  [[nodiscard]] int world_without(const SurfacePoint& object_point) const {
    return object_count == 1 ? 1 : object_point.object_index;
  }
};

}  // namespace seamline::renderer
