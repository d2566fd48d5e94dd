#pragma once
// Rooms that depth sensors look at in tests, and how two scenes are compared.
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "renderer/depth/local_scene.h"
#include "renderer/depth/sensor/sensor_scene.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer::sensor_rooms {

/// A room with a ball and a box in it, all before the camera.
inline Geometry furnished_truth() {
  return Geometry(std::vector<std::shared_ptr<const SurfaceMesh>>{
      test::box({-3, -1.5F, -6}, {3, 2.5F, 4}, 0.6F),
      test::box({-1.6F, -1.5F, -4.5F}, {-0.6F, 0.2F, -3.5F}, 0.4F),
      test::sphere({0.9F, -0.6F, -3.2F}, 0.7F, 96, 0.8F)});
}

/// Planes alone: what two triangles a wall stand for exactly.
inline Geometry empty_room() {
  return Geometry(
      std::vector<std::shared_ptr<const SurfaceMesh>>{test::box({-3, -1.5F, -6}, {3, 2.5F, 4}, 0.6F)});
}

inline PinholeSource pinhole(int width_px = 160, int height_px = 120, double field_of_view_deg = 60) {
  PinholeSource source;
  source.camera = sensors::pinhole_of_field_of_view(width_px, height_px, field_of_view_deg);
  return source;
}

inline DepthSettings settings_of(const DepthChain& chain, MeshDensity mesh = MeshDensity::adaptive) {
  DepthSettings settings{.width_px = 160, .mesh = mesh};
  settings.chain = chain;
  return settings;
}

inline DepthChain chain_of(const DepthSource& source) {
  DepthChain chain;
  chain.sources = {source};
  return chain;
}

inline SourceNoise generic_noise(double relative_sigma, double scale = 1) {
  return {.model = sensors::GenericNoise{.relative_sigma = relative_sigma}, .scale = scale};
}

inline bool same(const DepthMesh& a, const DepthMesh& b) {
  return a.vertices_m == b.vertices_m && a.triangles == b.triangles;
}

/// Share of rays from the camera, through a field of view, on which two scenes are no more than a relative
/// distance apart.
inline double share_alike(const Geometry& a, const Geometry& b, double field_of_view_deg, double relative) {
  const int side = 101;
  const double half = std::tan(field_of_view_deg / 2 * std::numbers::pi / 180);
  int alike = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Eigen::Vector3d direction(half * (2.0 * (x + 0.5) / side - 1),
                                      half * 0.7 * (2.0 * (y + 0.5) / side - 1), -1);
      const Ray ray{Eigen::Vector3f::Zero(), direction.normalized().cast<float>()};
      const auto hit_a = a.nearest(ray), hit_b = b.nearest(ray);
      if (hit_a && hit_b &&
          std::abs(hit_a->distance_m - hit_b->distance_m) <=
              relative * static_cast<double>(hit_a->distance_m))
        ++alike;
    }
  return static_cast<double>(alike) / (side * side);
}

}  // namespace seamline::renderer::sensor_rooms
