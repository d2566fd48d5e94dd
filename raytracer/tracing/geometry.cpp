// Embree is included by this file, ray_packet.h, ray_device.cpp and the benchmarks (bench_embree.cpp) only.
#include "raytracer/tracing/geometry.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <future>
#include <new>
#include <utility>

#include "raytracer/tracing/quads.h"
#include "raytracer/tracing/ray_device.h"
#include "raytracer/tracing/ray_packet.h"
#include "raytracer/tracing/triangle_neighbours.h"
#include "support/running/interrupt.h"

namespace seamline::renderer {
namespace {

RTCDevice embree_device() {
  return static_cast<RTCDevice>(RayDevice::instance().handle());
}

RTCScene as_scene(void* scene) {
  return static_cast<RTCScene>(scene);
}

/// Called by Embree for hits of meshes with an alpha mask: those in a hole are none.
void leave_out_holes(const RTCFilterFunctionNArguments* arguments) {
  const auto& mesh = *static_cast<const SurfaceMesh*>(arguments->geometryUserPtr);
  for (unsigned lane = 0; lane < arguments->N; ++lane) {
    if (arguments->valid[lane] == 0) continue;
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, lane);
    const float u = RTCHitN_u(arguments->hit, arguments->N, lane);
    const float v = RTCHitN_v(arguments->hit, arguments->N, lane);
    if (cut_away(*mesh.material, texture_coordinates(mesh, triangle, u, v))) arguments->valid[lane] = 0;
  }
}

/// Adds a mesh of triangles or of quads to a scene, which copies it. `masked`: a mesh with holes, which stays
/// where it is.
template <std::size_t corners>
void attach(RTCScene scene, const std::vector<Eigen::Vector3f>& positions,
            const std::vector<std::array<std::uint32_t, corners>>& faces, RTCBuildQuality quality,
            const SurfaceMesh* masked = nullptr) {
  static_assert(corners == 3 || corners == 4);
  RTCGeometry geometry =
      rtcNewGeometry(embree_device(), corners == 3 ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_QUAD);
  rtcSetGeometryBuildQuality(geometry, quality);
  const auto copy = [geometry](RTCBufferType type, RTCFormat format, const auto& values) {
    using Value = std::decay_t<decltype(values.front())>;
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Value), values.size());
    std::copy(values.begin(), values.end(), static_cast<Value*>(buffer));
  };
  copy(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
  copy(RTC_BUFFER_TYPE_INDEX, corners == 3 ? RTC_FORMAT_UINT3 : RTC_FORMAT_UINT4, faces);
  if (masked != nullptr) {
    rtcSetGeometryUserData(geometry, const_cast<SurfaceMesh*>(masked));  // NOLINT: only read
    rtcSetGeometryIntersectFilterFunction(geometry, leave_out_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, leave_out_holes);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

/// Embree keeps its errors to itself until asked: a scene that could not be built would be an empty one.
void commit(RTCScene scene) {
  rtcSetSceneProgressMonitorFunction(
      scene, [](void*, double) { return !interrupted(); }, nullptr);
  rtcCommitScene(scene);
  stop_if_interrupted();
  if (rtcGetDeviceError(embree_device()) != RTC_ERROR_NONE) throw std::bad_alloc();
}

void count(RayCounts* counts, std::size_t rays) {
  if (counts != nullptr) counts->traced += static_cast<std::int64_t>(rays);
}

void set_ray(RTCRay& out, const Ray& ray) {
  out.org_x = ray.origin_m.x();
  out.org_y = ray.origin_m.y();
  out.org_z = ray.origin_m.z();
  out.tnear = 0.0F;
  out.dir_x = ray.direction.x();
  out.dir_y = ray.direction.y();
  out.dir_z = ray.direction.z();
  out.time = 0.0F;
  out.tfar = ray.far_m;
  out.mask = 0xffffffffU;
  out.flags = 0;
}

constexpr std::size_t left_over_size = 8;  ///< a packet

/// Rays from the centre that the table of directions could not answer: they pass close to a hole.
struct LeftOver {
  std::array<Ray, left_over_size> rays;
  std::array<std::size_t, left_over_size> index;
  std::size_t count = 0;
};

/// A point of the local scene, which has geometric normals only.
void set_surface_from_centre(const Eigen::Vector3f& normal, const SurfaceTable& surface, const Ray& ray,
                             float distance_m, std::optional<SurfacePoint>& out) {
  SurfacePoint& point = out.emplace();
  point.distance_m = distance_m;
  point.position_m = ray.direction * distance_m;
  point.normal = point.geometric_normal = normal;
  point.albedo = surface.with_material == nullptr
                     ? surface.albedo
                     : surface.with_material->albedo_by_direction->at(ray.direction);
}

}  // namespace

Geometry::Geometry(std::span<const std::shared_ptr<const SurfaceMesh>> meshes, Edges edges)
    : scene_(rtcNewScene(embree_device())), meshes_(meshes.begin(), meshes.end()), boxes_(meshes) {
  if (edges == Edges::tight) rtcSetSceneFlags(as_scene(scene_), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(as_scene(scene_), RTC_BUILD_QUALITY_HIGH);
  for (const auto& mesh : meshes_) {
    attach(as_scene(scene_), mesh->positions_m, mesh->triangles, RTC_BUILD_QUALITY_HIGH,
           mesh->material && mesh->material->alpha_cutoff ? mesh.get() : nullptr);
    surfaces_.push_back(surface_table(*mesh));
    emits_ = emits_ || (mesh->emission > 0.0F).any();
    glossy_ = glossy_ || (mesh->f0 > 0.0F).any();
  }
  commit(as_scene(scene_));
}

Geometry::Geometry(const DepthMesh& mesh, const Rgb& albedo, TreeQuality quality, CentreRays centre)
    : scene_(rtcNewScene(embree_device())) {
  surfaces_.push_back({.albedo = albedo});
  const RTCBuildQuality of_tree =
      quality == TreeQuality::for_light ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
  rtcSetSceneBuildQuality(as_scene(scene_), of_tree);
  if (mesh.triangles.size() > DirectionTable::most_triangles) {
    attach(as_scene(scene_), mesh.vertices_m, mesh.triangles, of_tree);
    commit(as_scene(scene_));
    return;
  }
  const auto neighbours = triangle_neighbours(mesh.vertices_m.size(), mesh.triangles);
  auto table =
      std::async(std::launch::async, [&mesh, &neighbours, centre]() -> std::optional<DirectionTable> {
        if (centre == CentreRays::by_tree) return std::nullopt;
        return make_direction_table(mesh.vertices_m, mesh.triangles, neighbours);
      });
  attach(as_scene(scene_), mesh.vertices_m, pair_into_quads(mesh.vertices_m, mesh.triangles, neighbours),
         of_tree);
  commit(as_scene(scene_));
  directions_ = table.get();
}

void Geometry::paint(std::shared_ptr<const AlbedoMap> albedo) {
  assert(meshes_.empty() && surfaces_.size() == 1);
  auto painted = std::make_shared<SurfaceMesh>();
  painted->albedo_by_direction = std::move(albedo);
  painted_ = std::move(painted);
  surfaces_.front().with_material = painted_.get();
}

std::int64_t Geometry::own_memory_bytes() const {
  std::size_t bytes = 0;
  for (const auto& mesh : meshes_)
    bytes += mesh->positions_m.size() * sizeof(Eigen::Vector3f) +
             mesh->normals.size() * sizeof(Eigen::Vector3f) + mesh->triangles.size() * sizeof(Triangle) +
             (mesh->uvs[0].size() + mesh->uvs[1].size()) * sizeof(Eigen::Vector2f) +
             mesh->tangents.size() * sizeof(Eigen::Vector4f) + mesh->colours.size() * sizeof(Eigen::Array4f);
  if (directions_)
    bytes += directions_->triangle_of_cell.size() * sizeof(std::uint32_t) +
             directions_->triangles.size() * sizeof(CentreTriangle);
  return static_cast<std::int64_t>(bytes);
}

Geometry::~Geometry() {
  if (scene_ != nullptr) rtcReleaseScene(as_scene(scene_));
}

Geometry::Geometry(Geometry&& other) noexcept
    : scene_(std::exchange(other.scene_, nullptr)),
      surfaces_(std::move(other.surfaces_)),
      meshes_(std::move(other.meshes_)),
      boxes_(std::move(other.boxes_)),
      directions_(std::move(other.directions_)),
      painted_(std::move(other.painted_)),
      emits_(other.emits_),
      glossy_(other.glossy_) {}

std::optional<SurfacePoint> Geometry::nearest(const Ray& ray, RayCounts* counts) const {
  count(counts, 1);
  if (!boxes_.may_meet(ray)) return std::nullopt;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query;
  set_ray(query.ray, ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(as_scene(scene_), &context, &query);
  std::optional<SurfacePoint> point;
  if (const RTCHit& hit = query.hit; hit.geomID != RTC_INVALID_GEOMETRY_ID)
    set_surface(surfaces_[hit.geomID], ray,
                {{hit.Ng_x, hit.Ng_y, hit.Ng_z}, query.ray.tfar, hit.u, hit.v, hit.primID, hit.geomID},
                point);
  return point;
}

bool Geometry::occluded(const Ray& ray, RayCounts* counts) const {
  count(counts, 1);
  if (!boxes_.may_meet(ray)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query;
  set_ray(query, ray);
  rtcOccluded1(as_scene(scene_), &context, &query);
  return query.tfar < 0.0F;
}

void Geometry::nearest(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits,
                       Coherence coherence, RayCounts* counts) const {
  count(counts, rays.size());
  if (!boxes_.may_meet(rays)) {
    std::fill_n(hits.begin(), rays.size(), std::nullopt);
    return;
  }
  intersect_in_packets(as_scene(scene_), rays, coherence,
                       [&](std::size_t i, const RTCRayHit8& packet, int lane) {
                         const RTCHit8& hit = packet.hit;
                         hits[i].reset();
                         if (hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) return;
                         set_surface(surfaces_[hit.geomID[lane]], rays[i],
                                     {{hit.Ng_x[lane], hit.Ng_y[lane], hit.Ng_z[lane]},
                                      packet.ray.tfar[lane],
                                      hit.u[lane],
                                      hit.v[lane],
                                      hit.primID[lane],
                                      hit.geomID[lane]},
                                     hits[i]);
                       });
}

void Geometry::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked, Coherence coherence,
                        RayCounts* counts) const {
  count(counts, rays.size());
  if (!boxes_.may_meet(rays)) {
    std::fill_n(blocked.begin(), rays.size(), std::uint8_t{0});
    return;
  }
  occlude_in_packets(as_scene(scene_), rays, coherence,
                     [&](std::size_t i, bool is_blocked) { blocked[i] = is_blocked ? 1 : 0; });
}

void Geometry::distances(std::span<const Ray> rays, std::span<float> distance_m, RayCounts* counts) const {
  count(counts, rays.size());
  intersect_in_packets(as_scene(scene_), rays, Coherence::together,
                       [&](std::size_t i, const RTCRayHit8& packet, int lane) {
                         distance_m[i] = packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID
                                             ? std::numeric_limits<float>::infinity()
                                             : packet.ray.tfar[lane];
                       });
}

void Geometry::nearest_from_centre(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits,
                                   RayCounts* counts) const {
  if (!directions_) return nearest(rays, hits, Coherence::together, counts);
  if (counts != nullptr) counts->traced += static_cast<std::int64_t>(rays.size());
  std::uint32_t before = DirectionTable::nothing;
  Eigen::Vector3f plane_per_m, normal;  // of that triangle
  LeftOver left_over;
  const auto trace_left_over = [&] {
    std::array<std::optional<SurfacePoint>, left_over_size> found;
    nearest(std::span(left_over.rays).first(left_over.count), std::span(found).first(left_over.count));
    for (std::size_t k = 0; k < left_over.count; ++k) hits[left_over.index[k]] = found[k];
    left_over.count = 0;
  };
  for (std::size_t i = 0; i < rays.size(); ++i) {
    assert(rays[i].origin_m.isZero());
    const std::uint32_t triangle = find_triangle(*directions_, rays[i].direction, before);
    if (triangle == DirectionTable::not_found) {
      left_over.rays[left_over.count] = rays[i];
      left_over.index[left_over.count++] = i;
      if (left_over.count == left_over_size) trace_left_over();
      continue;
    }
    hits[i].reset();
    if (triangle != DirectionTable::nothing && triangle != before) {
      const CentreTriangle& seen = directions_->triangles[triangle];
      plane_per_m = seen.plane_per_m;
      normal = plane_per_m * -seen.plane_distance_m;  // towards the centre
    }
    before = triangle;
    if (triangle == DirectionTable::nothing) continue;
    const float distance_m = 1.0F / plane_per_m.dot(rays[i].direction);
    if (distance_m > 0.0F && distance_m <= rays[i].far_m)
      set_surface_from_centre(normal, surfaces_.front(), rays[i], distance_m, hits[i]);
  }
  if (left_over.count > 0) trace_left_over();
}

}  // namespace seamline::renderer
