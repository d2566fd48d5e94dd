// The only file that includes Embree, besides the benchmarks.
#include "renderer/geometry.h"

#include <embree3/rtcore.h>
#include <immintrin.h>

#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>

namespace seamline {
namespace {

thread_local std::int64_t rays_traced = 0;

constexpr float relative_offset = 1e-5F;

RTCDevice device() {
  return static_cast<RTCDevice>(RayDevice::instance().handle());
}
RTCScene as_scene(void* scene) {
  return static_cast<RTCScene>(scene);
}

void attach(RTCScene scene, const std::vector<Eigen::Vector3f>& positions,
            const std::vector<Triangle>& triangles) {
  RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Eigen::Vector3f), positions.size());
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          sizeof(Triangle), triangles.size());
  if (!positions.empty()) std::memcpy(vertices, positions.data(), positions.size() * sizeof(Eigen::Vector3f));
  if (!triangles.empty()) std::memcpy(indices, triangles.data(), triangles.size() * sizeof(Triangle));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

/// Embree keeps its errors to itself until asked: a scene that could not be built would be an empty one.
void commit(RTCScene scene) {
  rtcCommitScene(scene);
  if (rtcGetDeviceError(device()) != RTC_ERROR_NONE) throw std::bad_alloc();
}

RTCRay embree_ray(const Ray& ray) {
  RTCRay out{};
  out.org_x = ray.origin_m.x();
  out.org_y = ray.origin_m.y();
  out.org_z = ray.origin_m.z();
  out.dir_x = ray.direction.x();
  out.dir_y = ray.direction.y();
  out.dir_z = ray.direction.z();
  out.tnear = 0.0F;
  out.tfar = ray.far_m;
  out.mask = 0xffffffffU;
  return out;
}

Eigen::Vector3f shading_normal(const Part& part, const RTCHit& hit, const Eigen::Vector3f& geometric) {
  if (part.normals.empty()) return geometric;
  const Triangle& t = part.triangles[hit.primID];
  const Eigen::Vector3f mixed =
      (1.0F - hit.u - hit.v) * part.normals[t[0]] + hit.u * part.normals[t[1]] + hit.v * part.normals[t[2]];
  const float length = mixed.norm();
  if (!(length > 0.0F)) return geometric;
  // On the geometric normal's side; the file's winding and its normals may disagree.
  return (mixed.dot(geometric) < 0.0F ? -mixed : mixed) / length;
}

}  // namespace

RayDevice::RayDevice() : device_(rtcNewDevice(("isa=" + instruction_set()).c_str())) {
  if (device_ == nullptr) throw std::runtime_error("Embree could not be started");
}

RayDevice::~RayDevice() {
  rtcReleaseDevice(static_cast<RTCDevice>(device_));
}

RayDevice& RayDevice::instance() {
  static RayDevice device;
  return device;
}

std::string RayDevice::instruction_set() {
  return __builtin_cpu_supports("avx2") ? "avx2" : "sse2";
}

Eigen::Vector3f ray_start(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  const float scale = std::max(point.position_m.cwiseAbs().maxCoeff(), point.distance_m);
  const float side = above_horizon(point, direction) ? 1.0F : -1.0F;
  return point.position_m + point.geometric_normal * (side * relative_offset * scale);
}

Geometry::Geometry(std::span<const std::shared_ptr<const Part>> parts)
    : scene_(rtcNewScene(device())), parts_(parts.begin(), parts.end()) {
  rtcSetSceneFlags(as_scene(scene_), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(as_scene(scene_), RTC_BUILD_QUALITY_HIGH);
  for (const auto& part : parts_) {
    attach(as_scene(scene_), part->positions_m, part->triangles);
    emits_ = emits_ || (part->emission > 0.0F).any();
  }
  commit(as_scene(scene_));
}

Geometry::Geometry(const DepthMesh& mesh, const Rgb& albedo) : scene_(rtcNewScene(device())) {
  rtcSetSceneBuildQuality(as_scene(scene_), RTC_BUILD_QUALITY_HIGH);
  attach(as_scene(scene_), mesh.vertices_m, mesh.triangles);
  commit(as_scene(scene_));
  auto part = std::make_shared<Part>();
  part->name = "local scene";
  part->albedo = albedo;
  parts_.push_back(std::move(part));
}

Geometry::~Geometry() {
  if (scene_ != nullptr) rtcReleaseScene(as_scene(scene_));
}

Geometry::Geometry(Geometry&& other) noexcept
    : scene_(other.scene_), parts_(std::move(other.parts_)), emits_(other.emits_) {
  other.scene_ = nullptr;
}

std::optional<SurfacePoint> Geometry::nearest(const Ray& ray) const {
  ++rays_traced;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{embree_ray(ray), {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(as_scene(scene_), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Part& part = *parts_[query.hit.geomID];
  SurfacePoint point;
  point.distance_m = query.ray.tfar;
  point.position_m = ray.origin_m + ray.direction * query.ray.tfar;
  Eigen::Vector3f normal = Eigen::Vector3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z).normalized();
  if (normal.dot(ray.direction) > 0.0F) normal = -normal;
  point.geometric_normal = normal;
  point.normal = shading_normal(part, query.hit, normal);
  point.albedo = part.albedo;
  point.emission = part.emission;
  point.object_index = part.object_index;
  point.part = query.hit.geomID;
  return point;
}

bool Geometry::occluded(const Ray& ray) const {
  ++rays_traced;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = embree_ray(ray);
  rtcOccluded1(as_scene(scene_), &context, &query);
  return query.tfar < 0.0F;
}

void Geometry::nearest(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits) const {
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(rays[i]);
}

void Geometry::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
  for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = occluded(rays[i]) ? 1 : 0;
}

void Geometry::nearest_from_centre(std::span<const Ray> rays,
                                   std::span<std::optional<SurfacePoint>> hits) const {
  nearest(rays, hits);
}

std::int64_t rays_traced_by_this_thread() {
  return rays_traced;
}

void flush_denormals_to_zero() {
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

}  // namespace seamline
