#pragma once
#include <array>
#include <optional>
#include <utility>

#include "raytracer/scene/camera.h"

namespace seamline::renderer {

/// The surface that a pixel's middle shows. Where a depth map has the photograph's own pixels, the rays
/// through their middles meet the mesh exactly at its vertices, where one in 30 slips between the triangles,
/// or past the last row. So a ray that meets nothing is asked again a 64th of a pixel beside, in eight
/// directions between those of rows, columns and diagonals, along which edges lie; what that finds is
/// answered as the middle sees its plane.
[[nodiscard]] inline std::optional<SurfacePoint> seen_surface(const Camera& camera, const Geometry& geometry,
                                                              int x, int y) {
  const Ray ray = centre_ray(camera, x, y);
  if (ray.direction.isZero()) return std::nullopt;
  if (auto hit = geometry.nearest(ray)) return hit;
  constexpr float near_px = 1.0F / 128, far_px = 1.0F / 64;
  constexpr std::array<std::pair<float, float>, 8> beside = {{{far_px, near_px},
                                                              {near_px, far_px},
                                                              {-near_px, far_px},
                                                              {-far_px, near_px},
                                                              {-far_px, -near_px},
                                                              {-near_px, -far_px},
                                                              {near_px, -far_px},
                                                              {far_px, -near_px}}};
  for (const auto& [right, down] : beside) {
    const Eigen::Vector3f direction = camera.direction_within(x, y, 0.5F + right, 0.5F + down);
    if (direction.isZero()) continue;
    auto hit = geometry.nearest({ray.origin_m, direction});
    if (!hit) continue;
    const float in_plane_m =
        hit->geometric_normal.dot(hit->position_m - ray.origin_m) / hit->geometric_normal.dot(ray.direction);
    if (in_plane_m > 0.5F * hit->distance_m && in_plane_m < 2.0F * hit->distance_m)
      hit->distance_m = in_plane_m;
    hit->position_m = ray.origin_m + hit->distance_m * ray.direction;
    return hit;
  }
  return std::nullopt;
}

}  // namespace seamline::renderer
