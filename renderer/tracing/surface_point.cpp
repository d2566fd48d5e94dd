#include "renderer/tracing/surface_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "renderer/tracing/geometry.h"

namespace seamline::renderer {
namespace {

constexpr float relative_offset = 1e-5F;

/// Whether shading normals say nothing that the triangles do not: walls, boxes.
bool is_flat_shaded(const SurfaceMesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
    const Eigen::Vector3f& corner_m = mesh.positions_m[t[0]];
    const Eigen::Vector3f across =
        (mesh.positions_m[t[1]] - corner_m).cross(mesh.positions_m[t[2]] - corner_m).normalized();
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return std::abs(mesh.normals[v].dot(across)) > 1 - 1e-6F; });
  });
}

Eigen::Vector3f shading_normal(const SurfaceTable& surface, const SurfaceHit& hit,
                               const Eigen::Vector3f& geometric) {
  if (surface.normals == nullptr) return geometric;
  const Triangle& t = surface.triangles[hit.triangle];
  const Eigen::Vector3f mixed = (1.0F - hit.u - hit.v) * surface.normals[t[0]] +
                                hit.u * surface.normals[t[1]] + hit.v * surface.normals[t[2]];
  const float length = mixed.norm();
  if (!(length > 0.0F)) return geometric;
  // On the geometric normal's side; the file's winding and its normals may disagree.
  return (mixed.dot(geometric) < 0.0F ? -mixed : mixed) / length;
}

}  // namespace

SurfaceTable surface_table(const SurfaceMesh& mesh) {
  return {.triangles = mesh.triangles.data(),
          .normals = mesh.normals.empty() || is_flat_shaded(mesh) ? nullptr : mesh.normals.data(),
          .albedo = mesh.albedo,
          .emission = mesh.emission,
          .object_index = mesh.object_index};
}

void set_surface(const SurfaceTable& surface, const Ray& ray, const SurfaceHit& hit,
                 std::optional<SurfacePoint>& out) {
  SurfacePoint& point = out.emplace();
  point.distance_m = hit.distance_m;
  point.position_m = ray.origin_m + ray.direction * hit.distance_m;
  Eigen::Vector3f normal = hit.normal.normalized();
  if (normal.dot(ray.direction) > 0.0F) normal = -normal;
  point.geometric_normal = normal;
  point.normal = shading_normal(surface, hit, normal);
  point.albedo = surface.albedo;
  point.emission = surface.emission;
  point.object_index = surface.object_index;
  point.mesh = hit.mesh;
}

Eigen::Vector3f ray_start(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  const float scale = std::max(point.position_m.cwiseAbs().maxCoeff(), point.distance_m);
  const float side = above_horizon(point, direction) ? 1.0F : -1.0F;
  return point.position_m + point.geometric_normal * (side * relative_offset * scale);
}

}  // namespace seamline::renderer
