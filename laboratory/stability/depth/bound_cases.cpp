#include "laboratory/stability/depth/bound_cases.h"

#include <fmt/core.h>

#include <cmath>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/worst.h"
#include "laboratory/stability/depth/mesh_check.h"
#include "renderer/depth/full_mesh.h"

namespace seamline::stability {
namespace {

/// Calls use(sphere, tolerance) for every map.
template <class Use>
void for_each_map(const RandomMaps& maps, const Use& use) {
  for (int i = 0; i < maps.count; ++i) {
    Random random(maps.seed, i);
    const int width_px = 32 + 2 * static_cast<int>(random.below(9));
    const double tolerance = std::pow(10, -1 - 4 * random.uniform());
    const DepthMap map = random_depth_map(width_px, maps.kind, random);
    use(make_dense_sphere(map, 0, 1, width_px), tolerance);
  }
}

}  // namespace

DepthMesh bounded_as_product(const DenseSphere& sphere, double tolerance) {
  return build_adaptive_mesh(sphere, tolerance, 1);
}

Finding try_bound(const RandomMaps& maps, const BoundRule& rule) {
  double worst = 0;
  std::size_t triangles = 0, full = 0;
  for_each_map(maps, [&](const DenseSphere& sphere, double tolerance) {
    const DepthMesh mesh = rule(sphere, tolerance);
    triangles += mesh.triangles.size();
    full += build_full_mesh(sphere, 1).triangles.size();
    worst = worse(worst, check_mesh(mesh, sphere).largest_error / tolerance);
  });
  return {worst,
          fmt::format("{} maps, {:.0f} % of full density's triangles", maps.count, 100.0 * triangles / full)};
}

Finding try_holes(const RandomMaps& maps, const BoundRule& rule) {
  int lost = 0, covered = 0, away = 0;
  for_each_map(maps, [&](const DenseSphere& sphere, double tolerance) {
    const MeshCheck check = check_mesh(rule(sphere, tolerance), sphere);
    const MeshCheck full = check_mesh(build_full_mesh(sphere, 1), sphere);
    lost += std::max(0, check.rays_without_hit - full.rays_without_hit);  // a lone vertex carries no triangle
    covered += check.holes_covered;
    away += check.facing_away;
  });
  return {static_cast<double>(lost + covered + away),
          fmt::format("{} maps, {} rays lost, {} holes covered, {} triangles face away", maps.count, lost,
                      covered, away)};
}

Finding try_reported_error(const RandomMaps& maps, const BoundRule& rule) {
  double worst = 0;
  for_each_map(maps, [&](const DenseSphere& sphere, double tolerance) {
    const DepthMesh mesh = rule(sphere, tolerance);
    worst = worse(worst, (check_mesh(mesh, sphere).largest_error - mesh.max_relative_error) / tolerance);
  });
  return {worst, fmt::format("{} maps", maps.count)};
}

Finding try_watertight(const RandomMaps& maps, const BoundRule& rule) {
  int open = 0, repeated = 0;
  for_each_map(maps, [&](const DenseSphere& sphere, double tolerance) {
    const EdgeCheck check = check_edges(rule(sphere, tolerance));
    open += check.open;
    repeated += check.repeated;
  });
  return {static_cast<double>(open + repeated),
          fmt::format("{} maps, {} open edges, {} repeated", maps.count, open, repeated)};
}

Finding try_threads(const RandomMaps& maps) {
  int different = 0;
  for_each_map(maps, [&](const DenseSphere& sphere, double tolerance) {
    const DepthMesh one = build_adaptive_mesh(sphere, tolerance, 1),
                    three = build_adaptive_mesh(sphere, tolerance, 3);
    different += one.vertices_m == three.vertices_m && one.triangles == three.triangles ? 0 : 1;
  });
  return {static_cast<double>(different), fmt::format("{} of {} maps differ", different, maps.count)};
}

Finding try_tolerance_0(const RandomMaps& maps, const BoundRule& rule) {
  int different = 0;
  for_each_map(maps, [&](const DenseSphere& sphere, double) {
    different += rule(sphere, 0).triangles.size() == build_full_mesh(sphere, 1).triangles.size() ? 0 : 1;
  });
  return {static_cast<double>(different), fmt::format("{} of {} maps differ", different, maps.count)};
}

StabilityCases bound_cases() {
  const auto bound = [](const std::string& name, const RandomMaps& maps, const std::string& tried) {
    return StabilityCase{
        .group = "bounds",
        .name = name,
        .tried = fmt::format("{} random maps {}, adaptive meshes within 1e-5 to 0.1", maps.count, tried),
        .expected = "no ray of the dense sphere beyond the tolerance asked for",
        .unit = "of the tolerance",
        .tolerance = 1 + 1e-6,
        .reason = "the bound is a promise; the check's own double precision may see 1e-6 of it otherwise",
        .run = [maps](const StabilityOptions&) { return try_bound(maps); }};
  };
  const auto count = [](const std::string& name, const RandomMaps& maps, const std::string& tried,
                        const std::string& expected, const std::string& unit,
                        Finding (*attempt)(const RandomMaps&, const BoundRule&)) {
    return StabilityCase{
        .group = "bounds",
        .name = name,
        .tried = fmt::format("{} random maps {}", maps.count, tried),
        .expected = expected,
        .unit = unit,
        .tolerance = 0,
        .reason = exact_count,
        .run = [maps, attempt](const StabilityOptions&) { return attempt(maps, bounded_as_product); }};
  };
  return {
      bound("bound-smooth", {.count = 700, .seed = 11, .kind = {.holes = false, .jumps = false}},
            "without jumps"),
      bound("bound-jumps", {.count = 700, .seed = 12, .kind = {.holes = false}},
            "with boxes at 1e-3 to 1e6 m"),
      bound("bound-holes", {.count = 700, .seed = 13}, "with boxes and holes"),
      count("holes-stay-holes", {.count = 300, .seed = 14}, "with boxes and holes",
            "no valid ray lost, no hole covered, no triangle turned", "rays and triangles", try_holes),
      {.group = "bounds",
       .name = "reported-error",
       .tried = "400 random maps with boxes and holes: what a mesh says of its own largest error",
       .expected = "at least what brute force finds",
       .unit = "of the tolerance",
       .tolerance = 1e-6,
       .reason = "both see the corners as they are rounded in the mesh, and compute in double precision",
       .run = [](const StabilityOptions&) { return try_reported_error({.count = 400, .seed = 15}); }},
      count("watertight", {.count = 1000, .seed = 16, .kind = {.holes = false}}, "with boxes, without holes",
            "every edge shared by exactly two triangles", "edges", try_watertight),
      count("tolerance-0", {.count = 300, .seed = 17}, "with tolerance 0", "full density", "maps",
            try_tolerance_0),
      {.group = "bounds",
       .name = "threads",
       .tried = "300 random maps, one thread and three",
       .expected = "the same bits",
       .unit = "maps",
       .tolerance = 0,
       .reason = exact_count,
       .run = [](const StabilityOptions&) { return try_threads({.count = 300, .seed = 18}); }},
  };
}

}  // namespace seamline::stability
