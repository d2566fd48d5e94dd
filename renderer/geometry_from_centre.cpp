// Rays of the panorama's centre: answered by the table of directions, and only what it leaves over by Embree.
#include <array>
#include <cassert>

#include "renderer/geometry.h"
#include "renderer/ray_count.h"

namespace seamline {
namespace {

constexpr std::size_t left_over_size = 8;  ///< a packet

/// Rays from the centre that the table of directions could not answer: they pass close to a hole.
struct LeftOver {
  std::array<Ray, left_over_size> rays;
  std::array<std::size_t, left_over_size> index;
  std::size_t count = 0;
};

/// The plane m.x = 1 of a triangle.
struct Plane {
  Eigen::Vector3f m;       ///< its product with a unit direction is the inverse of the distance
  Eigen::Vector3f normal;  ///< unit, towards the centre
};

Plane plane_of(const Part& part, std::uint32_t triangle) {
  const Triangle& t = part.triangles[triangle];
  const Eigen::Vector3d a = part.positions_m[t[0]].cast<double>();
  const Eigen::Vector3d normal =
      (part.positions_m[t[1]].cast<double>() - a).cross(part.positions_m[t[2]].cast<double>() - a);
  const Eigen::Vector3d m = normal / normal.dot(a);
  return {m.cast<float>(), (-m.normalized()).cast<float>()};
}

/// A point of the local scene, which has geometric normals only.
void set_surface_from_centre(const Eigen::Vector3f& normal, const SurfaceTable& surface, const Ray& ray,
                             float distance_m, std::optional<SurfacePoint>& out) {
  SurfacePoint& point = out.emplace();
  point.distance_m = distance_m;
  point.position_m = ray.direction * distance_m;
  point.normal = point.geometric_normal = normal;
  point.albedo = surface.albedo;
}

}  // namespace

void Geometry::nearest_from_centre(std::span<const Ray> rays,
                                   std::span<std::optional<SurfacePoint>> hits) const {
  if (!directions_) return nearest(rays, hits);
  std::uint32_t before = DirectionTable::nothing;
  Plane plane;  // of that triangle
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
    ++rays_traced;
    hits[i].reset();
    if (triangle != DirectionTable::nothing && triangle != before)
      plane = plane_of(*parts_.front(), triangle);
    before = triangle;
    if (triangle == DirectionTable::nothing) continue;
    const float distance_m = 1.0F / plane.m.dot(rays[i].direction);
    if (distance_m > 0.0F && distance_m <= rays[i].far_m)
      set_surface_from_centre(plane.normal, surfaces_.front(), rays[i], distance_m, hits[i]);
  }
  if (left_over.count > 0) trace_left_over();
}

}  // namespace seamline
