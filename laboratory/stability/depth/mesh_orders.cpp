// Orders of the adaptive mesh.
#include <cmath>

#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/orders.h"
#include "laboratory/stability/depth/depth_maps.h"
#include "laboratory/stability/depth/mesh_check.h"
#include "renderer/depth/adaptive_mesh.h"
#include "renderer/depth/full_mesh.h"

namespace seamline::stability {
namespace {

constexpr int cave_width_px = 256;

/// A smooth cave, so that curvature alone decides how fine the mesh must be.
DepthMap cave_map() {
  return make_depth_map(cave_width_px, [](int column, int row) {
    const Eigen::Vector3d d = panorama_direction(column + 0.5, row + 0.5, cave_width_px, cave_width_px / 2);
    return 2 + 0.5 * d.x() * d.y() + 0.7 * d.z() * d.z() * d.x();
  });
}

}  // namespace

OrderSeries mesh_error_order() {
  return {.name = "mesh-error",
          .line = "largest error",
          .tried = "the adaptive mesh's largest error, by brute force, at tolerances 0.05 to 0.0008",
          .expected = 1,
          .tolerance = 0.15,
          .reason =
              "triangles halve their error by splitting, so that the error found lies anywhere from half "
              "the tolerance to all of it: 0.7 over a factor of 64 is 0.17 at worst",
          .panel = 1,
          .measure = [] {
            std::vector<std::pair<double, double>> points;
            const DepthMap map = cave_map();
            const DenseSphere sphere = make_dense_sphere(map, 0, 1, cave_width_px);
            for (double tolerance = 0.05; tolerance > 5e-4; tolerance /= 2)
              points.emplace_back(
                  tolerance, check_mesh(build_adaptive_mesh(sphere, tolerance, 1), sphere).largest_error);
            return points;
          }};
}

OrderSeries mesh_triangles_order() {
  return {.name = "mesh-triangles",
          .line = "triangles / full density",
          .tried = "the adaptive mesh's number of triangles at tolerances 0.05 to 0.0008",
          .expected = -1,
          .tolerance = 0.15,
          .reason = "the error of a flat triangle goes with its area; splits by two make steps",
          .panel = 1,
          .measure = [] {
            std::vector<std::pair<double, double>> points;
            const DepthMap map = cave_map();
            const DenseSphere sphere = make_dense_sphere(map, 0, 1, cave_width_px);
            const double full = build_full_mesh(sphere, 1).triangles.size();
            for (double tolerance = 0.05; tolerance > 5e-4; tolerance /= 2)
              points.emplace_back(tolerance,
                                  build_adaptive_mesh(sphere, tolerance, 1).triangles.size() / full);
            return points;
          }};
}

}  // namespace seamline::stability
