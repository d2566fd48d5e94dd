#include "renderer/transport/worlds.h"

namespace seamline::renderer {

WorldSet Worlds::reached_past_room(const Ray& ray, WorldSet set, RayCounts* counts) const {
  if (!objects->occluded(ray, counts)) return set;
  WorldSet reached = 0;
  for (int world = 1; world <= object_count; ++world) {
    if ((set & only_world(world)) == 0) continue;
    const Geometry* there = others[world - 1];
    if (there == nullptr || !there->occluded(ray, counts)) reached |= only_world(world);
  }
  return reached;
}

}  // namespace seamline::renderer
