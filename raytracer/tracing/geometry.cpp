// Embree is included by this file, ray_packet.h, search_tree.cpp, ray_device.cpp and the benchmarks
// (bench_embree.cpp) only.
#include "raytracer/tracing/geometry.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <future>
#include <utility>

#include "raytracer/tracing/kept_trees.h"
#include "raytracer/tracing/quads.h"
#include "raytracer/tracing/ray_packet.h"
#include "raytracer/tracing/search_tree.h"
#include "raytracer/tracing/triangle_neighbours.h"

namespace seamline::renderer {
namespace {

/// What a geometry asks: a tree, or one for each body.
struct Trees {
  std::vector<std::shared_ptr<const SearchTree>> held = {};
  std::vector<TracedTree> traced = {};

  void add(std::shared_ptr<const SearchTree> tree, std::size_t first_surface) {
    traced.push_back(
        {static_cast<RTCScene>(tree->scene()), &tree->boxes(), static_cast<std::uint32_t>(first_surface)});
    held.push_back(std::move(tree));
  }
};

std::span<const TracedTree> traced(const void* trees) {
  return static_cast<const Trees*>(trees)->traced;
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
    : meshes_(meshes.begin(), meshes.end()), boxes_(meshes) {
  for (const auto& mesh : meshes_) {
    surfaces_.push_back(surface_table(*mesh));
    emits_ = emits_ || (mesh->emission > 0.0F).any();
    glossy_ = glossy_ || (mesh->f0 > 0.0F).any();
  }
  auto trees = std::make_unique<Trees>();
  if (KeptTrees* const kept = KeptTrees::current()) {
    for (const KeptTrees::Meshes body : bodies_of(meshes_))
      trees->add(kept->tree_of(body, edges), static_cast<std::size_t>(body.data() - meshes_.data()));
  } else {
    trees->add(std::make_shared<const SearchTree>(meshes_, edges), 0);
  }
  scene_ = trees.release();
}

Geometry::Geometry(const DepthMesh& mesh, const Rgb& albedo, TreeQuality quality, CentreRays centre) {
  surfaces_.push_back({.albedo = albedo});
  auto trees = std::make_unique<Trees>();
  if (mesh.triangles.size() > DirectionTable::most_triangles) {
    trees->add(std::make_shared<const SearchTree>(mesh.vertices_m, mesh.triangles, quality), 0);
  } else {
    const auto neighbours = triangle_neighbours(mesh.vertices_m.size(), mesh.triangles);
    auto table =
        std::async(std::launch::async, [&mesh, &neighbours, centre]() -> std::optional<DirectionTable> {
          if (centre == CentreRays::by_tree) return std::nullopt;
          return make_direction_table(mesh.vertices_m, mesh.triangles, neighbours);
        });
    trees->add(std::make_shared<const SearchTree>(
                   mesh.vertices_m, pair_into_quads(mesh.vertices_m, mesh.triangles, neighbours), quality),
               0);
    directions_ = table.get();
  }
  scene_ = trees.release();
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
  delete static_cast<Trees*>(scene_);
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
  RTCRayHit query;
  set_ray(query.ray, ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  for_each_tree(traced(scene_), std::span(&ray, 1), [&](RTCScene tree, RTCIntersectContext& context) {
    rtcIntersect1(tree, &context, &query);
    return true;
  });
  std::optional<SurfacePoint> point;
  if (const RTCHit& hit = query.hit; hit.geomID != RTC_INVALID_GEOMETRY_ID) {
    const std::uint32_t surface = traced(scene_)[hit.instID[0]].first_surface + hit.geomID;
    set_surface(surfaces_[surface], ray,
                {{hit.Ng_x, hit.Ng_y, hit.Ng_z}, query.ray.tfar, hit.u, hit.v, hit.primID, surface}, point);
  }
  return point;
}

bool Geometry::occluded(const Ray& ray, RayCounts* counts) const {
  count(counts, 1);
  if (!boxes_.may_meet(ray)) return false;
  RTCRay query;
  set_ray(query, ray);
  for_each_tree(traced(scene_), std::span(&ray, 1), [&](RTCScene tree, RTCIntersectContext& context) {
    rtcOccluded1(tree, &context, &query);
    return query.tfar >= 0.0F;
  });
  return query.tfar < 0.0F;
}

void Geometry::nearest(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits,
                       Coherence coherence, RayCounts* counts) const {
  count(counts, rays.size());
  if (!boxes_.may_meet(rays)) {
    std::fill_n(hits.begin(), rays.size(), std::nullopt);
    return;
  }
  const std::span<const TracedTree> trees = traced(scene_);
  intersect_in_packets(trees, rays, coherence, [&](std::size_t i, const RTCRayHit8& packet, int lane) {
    const RTCHit8& hit = packet.hit;
    hits[i].reset();
    if (hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) return;
    const std::uint32_t surface = trees[hit.instID[0][lane]].first_surface + hit.geomID[lane];
    set_surface(surfaces_[surface], rays[i],
                {{hit.Ng_x[lane], hit.Ng_y[lane], hit.Ng_z[lane]},
                 packet.ray.tfar[lane],
                 hit.u[lane],
                 hit.v[lane],
                 hit.primID[lane],
                 surface},
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
  occlude_in_packets(traced(scene_), rays, coherence,
                     [&](std::size_t i, bool is_blocked) { blocked[i] = is_blocked ? 1 : 0; });
}

void Geometry::distances(std::span<const Ray> rays, std::span<float> distance_m, RayCounts* counts) const {
  count(counts, rays.size());
  intersect_in_packets(traced(scene_), rays, Coherence::together,
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
