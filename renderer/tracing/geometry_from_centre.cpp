// Rays of the panorama's centre: answered by the table of directions, and only what it leaves over by Embree.
#include <array>
#include <cassert>

#include "renderer/tracing/geometry.h"

namespace seamline::renderer {
namespace {

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
  point.albedo = surface.albedo;
}

}  // namespace

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
