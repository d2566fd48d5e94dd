#pragma once
#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "raytracer/tracing/geometry.h"

/// Packets of rays, as Embree wants them: one array for each coordinate. Only `geometry.cpp` includes it.
namespace seamline::renderer {

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
    for (int lane = 0; lane < count; ++lane) set_lane(packet, lane, rays[static_cast<std::size_t>(lane)]);
    for (int lane = 0; lane < packet_size; ++lane) valid[lane] = lane < count ? -1 : 0;
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
void intersect_in_packets(RTCScene scene, std::span<const Ray> rays, Coherence coherence,
                          const Found& found) {
  RTCIntersectContext context = packet_context(coherence);
  RTCRayHit8 packet;
  PacketLanes lanes;
  set_constants(packet.ray);
  for (std::size_t first = 0; first < rays.size(); first += packet_size) {
    const auto some = rays.subspan(first, std::min<std::size_t>(packet_size, rays.size() - first));
    lanes.set(packet.ray, some);
    std::fill_n(packet.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect8(lanes.valid, scene, &context, &packet);
    for (std::size_t lane = 0; lane < some.size(); ++lane)
      found(first + lane, packet, static_cast<int>(lane));
  }
}

/// Calls found(index, whether something lies on the ray) for every ray, in order.
template <class Found>
void occlude_in_packets(RTCScene scene, std::span<const Ray> rays, Coherence coherence, const Found& found) {
  RTCIntersectContext context = packet_context(coherence);
  RTCRay8 packet;
  PacketLanes lanes;
  set_constants(packet);
  for (std::size_t first = 0; first < rays.size(); first += packet_size) {
    const auto some = rays.subspan(first, std::min<std::size_t>(packet_size, rays.size() - first));
    lanes.set(packet, some);
    rtcOccluded8(lanes.valid, scene, &context, &packet);
    for (std::size_t lane = 0; lane < some.size(); ++lane) found(first + lane, packet.tfar[lane] < 0.0F);
  }
}

}  // namespace seamline::renderer
