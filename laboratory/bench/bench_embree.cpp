// Bare Embree loops, which Seamline's own are measured against.
#include "laboratory/bench/bench_embree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <stdexcept>

#include "raytracer/tracing/ray_device.h"

namespace seamline::renderer {
namespace {

/// A packet's arrays and Embree's functions for it, by its size.
template <int size>
struct Packet;
template <>
struct Packet<4> {
  using RayHit = RTCRayHit4;
  static constexpr auto intersect = rtcIntersect4;
  static constexpr auto occlude = rtcOccluded4;
};
template <>
struct Packet<8> {
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occlude = rtcOccluded8;
};
template <>
struct Packet<16> {
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occlude = rtcOccluded16;
};

RTCIntersectContext context_for(Coherence coherence) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherence == Coherence::together) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

template <int size>
void trace_packets(RTCScene scene, bool nearest, RTCIntersectContext context, std::span<const Ray> rays,
                   std::span<float> distance_m) {
  alignas(64) int valid[size];
  typename Packet<size>::RayHit packet;
  for (std::size_t first = 0; first < rays.size(); first += size) {
    const std::size_t count = std::min<std::size_t>(size, rays.size() - first);
    for (std::size_t lane = 0; lane < size; ++lane) {
      const Ray& ray = rays[first + std::min(lane, count - 1)];
      valid[lane] = lane < count ? -1 : 0;
      packet.ray.org_x[lane] = ray.origin_m.x();
      packet.ray.org_y[lane] = ray.origin_m.y();
      packet.ray.org_z[lane] = ray.origin_m.z();
      packet.ray.dir_x[lane] = ray.direction.x();
      packet.ray.dir_y[lane] = ray.direction.y();
      packet.ray.dir_z[lane] = ray.direction.z();
      packet.ray.tnear[lane] = 0;
      packet.ray.tfar[lane] = ray.far_m;
      packet.ray.time[lane] = 0;
      packet.ray.mask[lane] = 0xffffffffU;
      packet.ray.flags[lane] = 0;
      packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    if (nearest)
      Packet<size>::intersect(valid, scene, &context, &packet);
    else
      Packet<size>::occlude(valid, scene, &context, &packet.ray);
    std::copy_n(packet.ray.tfar, count, &distance_m[first]);
  }
}

void trace_single(RTCScene scene, bool nearest, RTCIntersectContext context, std::span<const Ray> rays,
                  std::span<float> distance_m) {
  RTCRayHit one;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray& ray = rays[i];
    one.ray = {.org_x = ray.origin_m.x(),
               .org_y = ray.origin_m.y(),
               .org_z = ray.origin_m.z(),
               .tnear = 0,
               .dir_x = ray.direction.x(),
               .dir_y = ray.direction.y(),
               .dir_z = ray.direction.z(),
               .time = 0,
               .tfar = ray.far_m,
               .mask = 0xffffffffU,
               .id = 0,
               .flags = 0};
    one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (nearest)
      rtcIntersect1(scene, &context, &one);
    else
      rtcOccluded1(scene, &context, &one.ray);
    distance_m[i] = one.ray.tfar;
  }
}

void trace(RTCScene scene, bool nearest, int packet_size, Coherence coherence, std::span<const Ray> rays,
           std::span<float> distance_m) {
  const RTCIntersectContext context = context_for(coherence);
  switch (packet_size) {
    case 1:
      return trace_single(scene, nearest, context, rays, distance_m);
    case 4:
      return trace_packets<4>(scene, nearest, context, rays, distance_m);
    case 8:
      return trace_packets<8>(scene, nearest, context, rays, distance_m);
    case 16:
      return trace_packets<16>(scene, nearest, context, rays, distance_m);
    default:
      throw std::logic_error("Embree has packets of 1, 4, 8 and 16");
  }
}

}  // namespace

BareScene::BareScene(std::span<const std::shared_ptr<const SurfaceMesh>> parts, Edges edges) {
  const auto device = static_cast<RTCDevice>(RayDevice::instance().handle());
  RTCScene scene = rtcNewScene(device);
  if (edges == Edges::tight) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  for (const auto& part : parts) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Eigen::Vector3f), part->positions_m.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(Triangle), part->triangles.size());
    std::copy(part->positions_m.begin(), part->positions_m.end(), static_cast<Eigen::Vector3f*>(vertices));
    std::copy(part->triangles.begin(), part->triangles.end(), static_cast<Triangle*>(indices));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);
  scene_ = scene;
}

BareScene::~BareScene() {
  rtcReleaseScene(static_cast<RTCScene>(scene_));
}

void BareScene::nearest(int packet_size, Coherence coherence, std::span<const Ray> rays,
                        std::span<float> distance_m) const {
  trace(static_cast<RTCScene>(scene_), true, packet_size, coherence, rays, distance_m);
}

void BareScene::occluded(int packet_size, Coherence coherence, std::span<const Ray> rays,
                         std::span<float> distance_m) const {
  trace(static_cast<RTCScene>(scene_), false, packet_size, coherence, rays, distance_m);
}

}  // namespace seamline::renderer
