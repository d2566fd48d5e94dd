#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "raytracer/material/scattering.h"
#include "raytracer/tracing/mesh.h"
#include "raytracer/tracing/ray.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

inline constexpr float inverse_pi = std::numbers::inv_pi_v<float>;
inline constexpr float endless = std::numeric_limits<float>::infinity();

/// A point on a surface as light sees it. Both normals are on the side the ray came from: surfaces are
/// two-sided. A glossy one shows nothing to a viewer below its shading normal's horizon, so there the normal,
/// of vertices or of a normal texture, is turned towards the ray until it is 0.6 degrees inside; a diffuse
/// one keeps it.
struct SurfacePoint {
  SurfacePoint() {}  // NOLINT: so that a hit is not filled with zeros first

  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;            ///< unit, for shading
  Eigen::Vector3f geometric_normal;  ///< unit, of the triangle
  float distance_m = 0;              ///< along the ray
  Rgb albedo = Rgb::Zero();          ///< of the diffuse base
  Rgb emission = Rgb::Zero();
  Rgb f0 = Rgb::Zero();       ///< of the specular layer; 0: there is none
  float alpha = 1.0F;         ///< of the specular layer
  float f90 = 1.0F;           ///< of the specular layer, along the horizon
  Eigen::Vector3f to_viewer;  ///< unit, back along the ray; of glossy points only
  int object_index = 0;
  std::uint32_t mesh = 0;
};

/// What the surface does with light at a point.
[[nodiscard]] inline Scatterer scatterer(const SurfacePoint& point) {
  return {point.albedo, point.f0, point.alpha, point.f90};
}

/// Where a ray starts that leaves a surface: off the surface by 1e-5 of the distance from the camera
/// (documentation/developers/design.md, section 6), on the side that `direction` goes to.
[[nodiscard]] Eigen::Vector3f ray_start(const SurfacePoint& point, const Eigen::Vector3f& direction);

/// Whether a direction leaves the surface on the side it is seen from.
[[nodiscard]] inline bool above_horizon(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  return point.geometric_normal.dot(direction) > 0.0F;
}

/// A direction that scattering on a glossy surface chose, as light leaves in it: one that goes below the
/// surface, as smooth normals make it near edges, is mirrored in the triangle, so that its light is not lost.
[[nodiscard]] inline Eigen::Vector3f leaving_direction(const SurfacePoint& point,
                                                       const Eigen::Vector3f& direction) {
  const float height = point.geometric_normal.dot(direction);
  if (height > 0.0F || !(point.f0 > 0.0F).any()) return direction;
  return direction - 2.0F * height * point.geometric_normal;
}

/// The ray that leaves a surface point, off the surface (see `ray_start`).
[[nodiscard]] inline Ray leaving_ray(const SurfacePoint& point, const Eigen::Vector3f& direction,
                                     float far_m) {
  return {ray_start(point, direction), direction, far_m};
}

/// Cosine with the sun's direction, 0 when the sun is below the surface's horizon.
[[nodiscard]] inline float sun_cosine(const SurfacePoint& point, const Eigen::Vector3f& to_sun) {
  return above_horizon(point, to_sun) ? std::max(0.0F, point.normal.dot(to_sun)) : 0.0F;
}

/// What a hit on a mesh needs to become a SurfacePoint, without a detour over the mesh.
struct SurfaceTable {
  const Triangle* triangles = nullptr;
  const Eigen::Vector3f* normals = nullptr;  ///< null: geometric ones are used, or the same
  Rgb albedo = Rgb::Zero(), emission = Rgb::Zero();
  int object_index = 0;
  const SurfaceMesh* with_material = nullptr;  ///< the mesh, where it is glossy or textured
};

[[nodiscard]] SurfaceTable surface_table(const SurfaceMesh& mesh);

/// What the tracer says of a hit.
struct SurfaceHit {
  Eigen::Vector3f normal;  ///< any length, either side
  float distance_m, u, v;
  std::uint32_t triangle, mesh;
};

/// Texture coordinates and vertex colours inside a triangle of a mesh, at barycentric (u, v).
[[nodiscard]] TextureCoordinates texture_coordinates(const SurfaceMesh& mesh, std::uint32_t triangle, float u,
                                                     float v);

/// Radiance of a mesh at barycentric (u, v) of a triangle: none in the holes of an alpha mask.
[[nodiscard]] Rgb emission_at(const SurfaceMesh& mesh, std::uint32_t triangle, float u, float v);

/// The surface that a ray hit.
void set_surface(const SurfaceTable& surface, const Ray& ray, const SurfaceHit& hit,
                 std::optional<SurfacePoint>& out);

}  // namespace seamline::renderer
