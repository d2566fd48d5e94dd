#include "raytracer/tracing/surface_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raytracer/tracing/geometry.h"

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

template <class Value>
Value between_vertices(const std::vector<Value>& of_vertices, const Triangle& t, float u, float v) {
  return (1.0F - u - v) * of_vertices[t[0]] + u * of_vertices[t[1]] + v * of_vertices[t[2]];
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

/// The normal texture's, in the file's own frame, whose side is then the ray's.
Eigen::Vector3f textured_normal(const SurfaceMesh& mesh, const SurfaceHit& hit, const TextureCoordinates& uv,
                                const Eigen::Vector3f& geometric) {
  const Triangle& t = mesh.triangles[hit.triangle];
  const Eigen::Vector3f& corner_m = mesh.positions_m[t[0]];
  Eigen::Vector3f outwards =
      mesh.normals.empty()
          ? Eigen::Vector3f((mesh.positions_m[t[1]] - corner_m).cross(mesh.positions_m[t[2]] - corner_m))
          : between_vertices(mesh.normals, t, hit.u, hit.v);
  if (!(outwards.norm() > 0.0F)) return geometric;
  outwards.normalize();
  const Eigen::Vector4f tangent = between_vertices(mesh.tangents, t, hit.u, hit.v);
  const Eigen::Vector3f across = tangent.head<3>() - outwards.dot(tangent.head<3>()) * outwards;
  if (!(across.norm() > 0.0F)) return outwards.dot(geometric) < 0.0F ? -outwards : outwards;
  const Eigen::Vector3f right = across.normalized();
  const Eigen::Vector3f up = outwards.cross(right) * (tangent[3] < 0.0F ? -1.0F : 1.0F);
  const Eigen::Vector3f normal = mapped_normal(*mesh.material, uv, outwards, right, up);
  return outwards.dot(geometric) < 0.0F ? -normal : normal;
}

void set_textured(const SurfaceMesh& mesh, const SurfaceHit& hit, SurfacePoint& point) {
  const TextureCoordinates uv = texture_coordinates(mesh, hit.triangle, hit.u, hit.v);
  const MaterialValues values = material_at(*mesh.material, uv);
  point.albedo = values.scatterer.albedo;
  point.f0 = values.scatterer.f0;
  point.alpha = values.scatterer.alpha;
  point.f90 = values.scatterer.f90;
  point.emission = values.emission;
  if (!mesh.tangents.empty()) point.normal = textured_normal(mesh, hit, uv, point.geometric_normal);
}

/// See `SurfacePoint`.
void turn_towards(const Eigen::Vector3f& to_viewer, SurfacePoint& point) {
  constexpr float least_cosine = 0.01F;
  const float cosine = point.normal.dot(to_viewer);
  if (cosine < least_cosine) point.normal = (point.normal + (least_cosine - cosine) * to_viewer).normalized();
}

/// What only glossy and textured surfaces need; apart, so that the others, which are most, pay for one
/// question.
[[gnu::noinline]] void set_material_of(const SurfaceMesh& mesh, const Ray& ray, const SurfaceHit& hit,
                                       SurfacePoint& point) {
  if (mesh.albedo_by_direction) {
    point.albedo = mesh.albedo_by_direction->at(point.position_m);
    return;
  }
  point.f0 = mesh.f0;
  point.alpha = mesh.alpha;
  point.f90 = mesh.f90;
  if (mesh.material) set_textured(mesh, hit, point);
  if (!(point.f0 > 0.0F).any()) return;
  point.to_viewer = -ray.direction;
  turn_towards(point.to_viewer, point);
}

}  // namespace

SurfaceTable surface_table(const SurfaceMesh& mesh) {
  return {.triangles = mesh.triangles.data(),
          .normals = mesh.normals.empty() || is_flat_shaded(mesh) ? nullptr : mesh.normals.data(),
          .albedo = mesh.albedo,
          .emission = mesh.emission,
          .object_index = mesh.object_index,
          .with_material = mesh.material || (mesh.f0 > 0.0F).any() ? &mesh : nullptr};
}

TextureCoordinates texture_coordinates(const SurfaceMesh& mesh, std::uint32_t triangle, float u, float v) {
  TextureCoordinates uv;
  for (std::size_t set = 0; set < uv.sets.size(); ++set)
    if (!mesh.uvs[set].empty())
      uv.sets[set] = between_vertices(mesh.uvs[set], mesh.triangles[triangle], u, v);
  if (!mesh.colours.empty()) uv.colour = between_vertices(mesh.colours, mesh.triangles[triangle], u, v);
  return uv;
}

Rgb emission_at(const SurfaceMesh& mesh, std::uint32_t triangle, float u, float v) {
  if (!mesh.material) return mesh.emission;
  const TextureCoordinates uv = texture_coordinates(mesh, triangle, u, v);
  return cut_away(*mesh.material, uv) ? Rgb(Rgb::Zero()) : material_at(*mesh.material, uv).emission;
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
  if (surface.with_material != nullptr) set_material_of(*surface.with_material, ray, hit, point);
}

Eigen::Vector3f ray_start(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  const float scale = std::max(point.position_m.cwiseAbs().maxCoeff(), point.distance_m);
  const float side = above_horizon(point, direction) ? 1.0F : -1.0F;
  return point.position_m + point.geometric_normal * (side * relative_offset * scale);
}

}  // namespace seamline::renderer
