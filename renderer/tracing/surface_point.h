#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "renderer/tracing/mesh.h"
#include "renderer/tracing/ray.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

struct Part;

/// A point on a surface as light sees it. Both normals are on the side the ray came from: surfaces are
/// two-sided.
struct SurfacePoint {
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;            ///< unit, for shading
  Eigen::Vector3f geometric_normal;  ///< unit, of the triangle
  float distance_m = 0;              ///< along the ray
  Rgb albedo = Rgb::Zero();
  Rgb emission = Rgb::Zero();
  int object_index = 0;
  std::uint32_t part = 0;
};

/// Where a ray starts that leaves a surface: off the surface by 1e-5 of the distance from the camera (DESIGN
/// section 4), on the side that `direction` goes to.
[[nodiscard]] Eigen::Vector3f ray_start(const SurfacePoint& point, const Eigen::Vector3f& direction);

/// Whether a direction leaves the surface on the side it is seen from.
[[nodiscard]] inline bool above_horizon(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  return point.geometric_normal.dot(direction) > 0.0F;
}

/// What a hit on a part needs to become a SurfacePoint, without a detour over the part.
struct SurfaceTable {
  const Triangle* triangles = nullptr;
  const Eigen::Vector3f* normals = nullptr;  ///< null: geometric ones are used, or the same
  Rgb albedo = Rgb::Zero(), emission = Rgb::Zero();
  int object_index = 0;
};

[[nodiscard]] SurfaceTable surface_table(const Part& part);

/// What the tracer says of a hit.
struct SurfaceHit {
  Eigen::Vector3f normal;  ///< any length, either side
  float distance_m, u, v;
  std::uint32_t triangle, part;
};

/// The surface that a ray hit.
void set_surface(const SurfaceTable& surface, const Ray& ray, const SurfaceHit& hit,
                 std::optional<SurfacePoint>& out);

}  // namespace seamline::renderer
