#pragma once
#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "raytracer/tracing/bounding_boxes.h"
#include "raytracer/tracing/geometry.h"

/// Packets of rays, as Embree wants them: one array for each coordinate. Only `geometry.cpp` includes it.
namespace seamline::renderer {

/// A search tree that a geometry asks.
struct TracedTree {
  RTCScene scene = nullptr;
  const BoundingBoxes* boxes = nullptr;  ///< around what it holds, where there are further trees
  std::uint32_t first_surface = 0;       ///< of the geometry, that is its first mesh
};

/// Calls ask(tree, context) for each tree that any of some rays may meet, until it returns false. Hits carry
/// the number of the tree as their instID.
template <class Ask>
void for_each_tree(std::span<const TracedTree> trees, std::span<const Ray> rays, RTCIntersectContext context,
                   const Ask& ask) {
  for (std::size_t tree = 0; tree < trees.size(); ++tree) {
    if (trees.size() > 1 && !trees[tree].boxes->may_meet(rays)) continue;
    context.instID[0] = static_cast<unsigned>(tree);
    if (!ask(trees[tree].scene, context)) return;
  }
}

template <class Ask>
void for_each_tree(std::span<const TracedTree> trees, std::span<const Ray> rays, const Ask& ask) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for_each_tree(trees, rays, context, ask);
}

/// Rays of a packet: one AVX2 register of each coordinate. Measured on 4, 8 and 16 with `seamline lab bench
/// --only tracer`: 16 is two packets of 8 inside Embree and a tenth slower, 4 leaves half of the registers
/// empty.
inline constexpr int packet_size = 8;

inline void set_lane(RTCRay8& packet, int lane, const Ray& ray) {
  packet.org_x[lane] = ray.origin_m.x();
  packet.org_y[lane] = ray.origin_m.y();
  packet.org_z[lane] = ray.origin_m.z();
  packet.dir_x[lane] = ray.direction.x();
  packet.dir_y[lane] = ray.direction.y();
  packet.dir_z[lane] = ray.direction.z();
  packet.tfar[lane] = ray.far_m;
}

/// Which rays of a packet are to be traced: all but in the last packet.
struct PacketLanes {
  alignas(32) int valid[packet_size];

  void set(RTCRay8& packet, std::span<const Ray> rays) {
    const int count = static_cast<int>(rays.size());
    for (int lane = 0; lane < count; ++lane) set_lane(packet, lane, rays[lane]);
    for (int lane = 0; lane < packet_size; ++lane) valid[lane] = lane < count ? -1 : 0;
  }

  /// Rays that something was found on are not traced again. Returns whether any is left.
  bool leave_out_blocked(const RTCRay8& packet) {
    bool any_left = false;
    for (int lane = 0; lane < packet_size; ++lane) {
      if (valid[lane] != 0 && packet.tfar[lane] < 0.0F) valid[lane] = 0;
      any_left = any_left || valid[lane] != 0;
    }
    return any_left;
  }
};

/// What is the same for every ray of every packet.
inline void set_constants(RTCRay8& packet) {
  std::fill_n(packet.tnear, packet_size, 0.0F);
  std::fill_n(packet.time, packet_size, 0.0F);
  std::fill_n(packet.mask, packet_size, 0xffffffffU);
  std::fill_n(packet.flags, packet_size, 0U);
}

/// With the coherent flag, rays of a packet go down the tree together; without it, those that part from the
/// others go alone.
inline RTCIntersectContext packet_context(Coherence coherence) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherence == Coherence::together ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                   : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}

/// Calls found(index, packet, lane) for every ray, in order, with the packet that holds its answer;
/// packet.hit.geomID[lane] is RTC_INVALID_GEOMETRY_ID when nothing was hit.
template <class Found>
void intersect_in_packets(std::span<const TracedTree> trees, std::span<const Ray> rays, Coherence coherence,
                          const Found& found) {
  const RTCIntersectContext together = packet_context(coherence);
  RTCRayHit8 packet;
  PacketLanes lanes;
  set_constants(packet.ray);
  for (std::size_t first = 0; first < rays.size(); first += packet_size) {
    const auto some = rays.subspan(first, std::min<std::size_t>(packet_size, rays.size() - first));
    lanes.set(packet.ray, some);
    std::fill_n(packet.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
    for_each_tree(trees, some, together, [&](RTCScene tree, RTCIntersectContext& context) {
      rtcIntersect8(lanes.valid, tree, &context, &packet);
      return true;
    });
    for (std::size_t lane = 0; lane < some.size(); ++lane)
      found(first + lane, packet, static_cast<int>(lane));
  }
}

/// Calls found(index, whether something lies on the ray) for every ray, in order.
template <class Found>
void occlude_in_packets(std::span<const TracedTree> trees, std::span<const Ray> rays, Coherence coherence,
                        const Found& found) {
  const RTCIntersectContext together = packet_context(coherence);
  RTCRay8 packet;
  PacketLanes lanes;
  set_constants(packet);
  for (std::size_t first = 0; first < rays.size(); first += packet_size) {
    const auto some = rays.subspan(first, std::min<std::size_t>(packet_size, rays.size() - first));
    lanes.set(packet, some);
    for_each_tree(trees, some, together, [&](RTCScene tree, RTCIntersectContext& context) {
      rtcOccluded8(lanes.valid, tree, &context, &packet);
      return lanes.leave_out_blocked(packet);
    });
    for (std::size_t lane = 0; lane < some.size(); ++lane) found(first + lane, packet.tfar[lane] < 0.0F);
  }
}

}  // namespace seamline::renderer
