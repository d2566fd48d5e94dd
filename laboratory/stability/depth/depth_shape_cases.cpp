#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/common/worst.h"
#include "laboratory/stability/depth/depth_maps.h"
#include "laboratory/stability/depth/mesh_check.h"
#include "raytracer/tracing/geometry.h"
#include "renderer/depth/adaptive_mesh.h"
#include "renderer/depth/full_mesh.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

constexpr double pi = std::numbers::pi;

Eigen::Vector3d random_direction(Random& random) {
  const double y = 2 * random.uniform() - 1, azimuth = 2 * pi * random.uniform(),
               across = std::sqrt(1 - y * y);
  return {across * std::cos(azimuth), y, across * std::sin(azimuth)};
}

/// A mesh whose vertices are named by where they lie in the dense grid, so that two can be compared whatever
/// the order of their vertices.
struct NamedMesh {
  std::map<int, Eigen::Vector3d> position_m;
  std::vector<std::array<int, 3>> triangles;  ///< sorted, each beginning at its least name
};

NamedMesh named(const DepthMesh& mesh, int width, int height) {
  NamedMesh out;
  std::vector<int> names;
  for (const Eigen::Vector3f& vertex : mesh.vertices_m) {
    const Eigen::Vector3d d = vertex.cast<double>().normalized();
    const int row =
        static_cast<int>(std::floor((0.5 - std::asin(std::clamp(d.y(), -1.0, 1.0)) / pi) * height));
    const double turns = std::atan2(d.x(), -d.z()) / (2 * pi) + 0.5;
    const int column = static_cast<int>(std::floor(turns * width)) % width;
    const bool pole = std::hypot(d.x(), d.z()) < 0.5 * pi / (2 * height);
    names.push_back(pole ? (d.y() > 0 ? -1 : -2) : row * width + column);
    out.position_m[names.back()] = vertex.cast<double>();
  }
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> triangle = {names[t[0]], names[t[1]], names[t[2]]};
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    out.triangles.push_back(triangle);
  }
  std::sort(out.triangles.begin(), out.triangles.end());
  return out;
}

/// A sphere of constant distance: largest relative error of the distances that rays find.
Finding try_constant_sphere(double distance_m, const MeshOptions& options,
                            const MeshRule& rule = build_depth_mesh) {
  constexpr int rays = 100;
  const DepthMesh mesh = rule(constant_map(256, distance_m), options);
  double error = 0;
  for (int i = 0; i < rays; ++i) {
    // Through the middle of cells and of triangles, where a chord is farthest from the sphere.
    const Eigen::Vector3d d = panorama_direction(20 * i + (i % 2 == 0 ? 0.0 : 0.25), 5 * i + 262, 2048, 1024);
    error = worse(error, relative_error(brute_force_distance_m(mesh, d), distance_m));
  }
  return {error,
          fmt::format("{} triangles, largest error {:.2g} of {} rays", mesh.triangles.size(), error, rays)};
}

/// Blocks of 1 m and of 1e6 m side by side: the adaptive mesh's largest error over all rays of the dense
/// sphere; NaN when a ray is lost.
Finding try_jumps() {
  const DepthMap map =
      make_depth_map(64, [](int column, int row) { return (column / 8 + row / 8) % 2 == 0 ? 1.0 : 1e6; });
  const DenseSphere sphere = make_dense_sphere(map, 0, 1, 64);
  const DepthMesh mesh = build_adaptive_mesh(sphere, 1e-4, 1);
  const MeshCheck check = check_mesh(mesh, sphere);
  const bool lost = check.rays_without_hit + check.facing_away > 0;
  return {lost ? nan : check.largest_error,
          fmt::format("{} triangles, largest error {:.2g}, {} rays lost", mesh.triangles.size(),
                      check.largest_error, check.rays_without_hit)};
}

/// Rays at and around a pole of a room: largest relative error of the ceiling's (floor's) distance; NaN when
/// one meets nothing.
Finding try_pole(bool zenith) {
  const double side = zenith ? 1 : -1;
  double error = 0;
  int rays = 0;
  for (const MeshDensity density : {MeshDensity::adaptive, MeshDensity::full}) {
    const DepthMesh mesh = build_depth_mesh(room_map(512), {.density = density, .threads = 1});
    for (const double off_rad : {0.0, 1e-6, 1e-4, 1e-3, 3e-3, 1e-2})
      for (int i = 0; i < 8; ++i, ++rays) {
        const double azimuth = 0.1 + i * pi / 4;
        const Eigen::Vector3d d(std::sin(off_rad) * std::cos(azimuth), side * std::cos(off_rad),
                                std::sin(off_rad) * std::sin(azimuth));
        error = worse(error, relative_error(brute_force_distance_m(mesh, d), room_distance_m(d)));
      }
  }
  return {error, fmt::format("{} rays, largest error {:.2g}", rays, error)};
}

/// The room's panorama turned by every number of texels: the full mesh must be the same one, turned. Largest
/// relative difference of its vertices; NaN when its triangles differ.
Finding try_seam_full() {
  constexpr int width = 64, dense = 128;
  const DepthMap map = room_map(width);
  const NamedMesh usual = named(build_full_mesh(make_dense_sphere(map, 0, 1, dense), 1), dense, dense / 2);
  double error = 0;
  for (int texels = 1; texels < width; ++texels) {
    const DepthMap turned = turned_map(map, texels);
    const NamedMesh other =
        named(build_full_mesh(make_dense_sphere(turned, texels, 1, dense), 1), dense, dense / 2);
    if (other.triangles != usual.triangles || other.position_m.size() != usual.position_m.size())
      return {nan, fmt::format("other triangles after {} texels", texels)};
    for (const auto& [name, at_m] : usual.position_m)
      error = worse(error, (other.position_m.at(name) - at_m).norm() / at_m.norm());
  }
  return {error,
          fmt::format("63 turns, {} vertices, largest difference {:.2g}", usual.position_m.size(), error)};
}

/// The same of the adaptive mesh: its largest error against the panorama that was not turned; NaN when a ray
/// is lost.
Finding try_seam_adaptive(double tolerance) {
  constexpr int width = 32, dense = 64;
  const DepthMap map = room_map(width);
  const DenseSphere sphere = make_dense_sphere(map, 0, 1, dense);
  double error = 0;
  int lost = 0;
  for (int texels = 0; texels < width; ++texels) {
    const DepthMap turned = turned_map(map, texels);
    const MeshCheck check =
        check_mesh(build_adaptive_mesh(make_dense_sphere(turned, texels, 1, dense), tolerance, 1), sphere);
    error = worse(error, check.largest_error);
    lost += check.rays_without_hit;
  }
  return {lost > 0 ? nan : error, fmt::format("31 turns, {} rays lost, largest error {:.3g}", lost, error)};
}

/// Jumps from 1 to 10 m and a hole: rays from the centre by the table of directions against Embree's search.
/// Counts rays that disagree.
Finding try_direction_table() {
  const DepthMap map = make_depth_map(128, [](int column, int row) {
    if (column > 90 && row > 40) return infinity;
    return (column / 32 + row / 32) % 2 == 0 ? 1.0 : 10.0;
  });
  const Geometry geometry(build_depth_mesh(map, {.threads = 1}), Rgb::Constant(0.5F));
  Random random(8);
  std::vector<Ray> rays;
  for (int i = 0; i < 20000; ++i)
    rays.push_back({Eigen::Vector3f::Zero(), random_direction(random).cast<float>().normalized()});
  std::vector<std::optional<SurfacePoint>> by_table(rays.size());
  geometry.nearest_from_centre(rays, by_table);
  int disagree = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto searched = geometry.nearest(rays[i]);
    const bool same = searched.has_value() == by_table[i].has_value() &&
                      (!searched || relative_error(static_cast<double>(by_table[i]->distance_m),
                                                   static_cast<double>(searched->distance_m)) < 1e-3);
    disagree += same ? 0 : 1;
  }
  return {static_cast<double>(disagree), fmt::format("{} of {} rays disagree", disagree, rays.size())};
}

}  // namespace

StabilityCases depth_shape_cases() {
  const auto sphere = [](const std::string& name, const MeshOptions& options, double tolerance,
                         const std::string& reason) {
    return StabilityCase{
        .group = "depth",
        .name = name,
        .tried = "a sphere of constant distance, 256 px",
        .expected = "that distance along every ray",
        .unit = "relative",
        .tolerance = tolerance,
        .reason = reason,
        .run = [options](const StabilityOptions&) { return try_constant_sphere(3, options); }};
  };
  const auto pole = [](const std::string& name, bool zenith) {
    return StabilityCase{
        .group = "depth",
        .name = name,
        .tried =
            "rays straight at a pole of a room's map of 512 px and up to 0.01 rad beside it, both densities",
        .expected = "the distance of the plane there",
        .unit = "relative",
        .tolerance = 1.5e-4,
        .reason =
            "the mesh's bound 1e-4; half a texel (0.006 rad) from the pole the plane is 1.9e-5 farther, and "
            "as much again is lost between texels",
        .run = [zenith](const StabilityOptions&) { return try_pole(zenith); }};
  };
  return {
      sphere("constant-sphere-full", {.density = MeshDensity::full, .threads = 1}, 3e-6,
             "sagitta of a cell of 2 pi / 2048, its diagonal squared over 8: 2.4e-6; float"),
      sphere("constant-sphere-adaptive", {.tolerance = 1e-4, .threads = 1}, 1.03e-4,
             "the mesh's bound holds at the dense sphere's vertices; 2.4e-6 more between them"),
      {.group = "depth",
       .name = "jumps-1e6",
       .tried = "blocks of 1 m and 1e6 m side by side, adaptive mesh",
       .expected = "every ray within the bound, none lost",
       .unit = "relative",
       .tolerance = 1e-4,
       .reason = "the bound that was asked for",
       .run = [](const StabilityOptions&) { return try_jumps(); }},
      pole("zenith", true),
      pole("nadir", false),
      {.group = "depth",
       .name = "seam-full",
       .tried = "a room's panorama of 64 px turned by 1 to 63 texels, full density",
       .expected = "the same mesh, turned, with the same triangles",
       .unit = "relative",
       .tolerance = 1e-6,
       .reason = "positions are rounded to float once: 6e-8 an axis and less",
       .run = [](const StabilityOptions&) { return try_seam_full(); }},
      {.group = "depth",
       .name = "seam-adaptive",
       .tried = "a room's panorama of 32 px turned by 1 to 31 texels, adaptive meshes within 1e-3",
       .expected = "each within its bound of the panorama that was not turned",
       .unit = "relative",
       .tolerance = 1e-3 * (1 + 1e-3),
       .reason = "the bound that was asked for; turned positions are rounded to float anew, 1e-7",
       .run = [](const StabilityOptions&) { return try_seam_adaptive(1e-3); }},
      {.group = "depth",
       .name = "direction-table",
       .tried = "20,000 rays from the centre of a map with jumps from 1 to 10 m and a hole, by the table of "
                "directions and by Embree's search",
       .expected = "the same surface",
       .unit = "rays",
       .tolerance = 2,
       .reason = "a ray within rounding (1e-7 rad) of an edge may get either neighbour",
       .run = [](const StabilityOptions&) { return try_direction_table(); }},
  };
}

}  // namespace seamline::stability
