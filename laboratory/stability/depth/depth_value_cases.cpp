#include "laboratory/stability/depth/depth_value_cases.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/small_render.h"
#include "laboratory/stability/depth/mesh_check.h"
#include "support/arithmetic/grid_index.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

constexpr int map_width_px = 64, first_column = 20, first_row = 10, patch_px = 4;
constexpr float infinite = std::numeric_limits<float>::infinity();

/// Through a file, as a measured map would come.
DepthMap through_file(const DepthMap& map) {
  const TemporaryFolder folder;
  Image image(map.width_px, map.height_px, 1);
  image.values = map.distance_m;
  write_exr(folder.path() / "depth.exr", image);
  return read_depth_map(folder.path() / "depth.exr");
}

int vertices_off(const DepthMesh& mesh, double distance_m) {
  int off = 0;
  for (const Eigen::Vector3f& vertex : mesh.vertices_m)
    off += std::abs(vertex.cast<double>().norm() - distance_m) <= 1e-6 * distance_m ? 0 : 1;
  return off;
}

Ray ray_through(double column, double row) {
  return {Eigen::Vector3f::Zero(),
          panorama_direction(column, row, map_width_px, map_width_px / 2).cast<float>()};
}

StabilityCase value_case(const std::string& name, float value, const std::string& tried) {
  return {.group = "depth",
          .name = name,
          .tried = "a sphere of 2 m in which 4 x 4 texels are " + tried,
          .expected = "a hole there, everything else at 2 m, texels counted as cleaned",
          .unit = "vertices, rays and texels",
          .tolerance = 0,
          .reason = exact_count,
          .run = [value](const StabilityOptions&) { return try_bad_texels(value, value != infinite); }};
}

}  // namespace

Finding try_bad_texels(float value, bool counted, const MeshRule& rule) {
  DepthMap map = constant_map(map_width_px, 2);
  for (int row = first_row; row < first_row + patch_px; ++row)
    for (int column = first_column; column < first_column + patch_px; ++column)
      map.distance_m[grid_index(row, column, map_width_px)] = value;
  const std::int64_t cleaned = through_file(map).cleaned_texels;
  int wrong = cleaned == (counted ? patch_px * patch_px : 0) ? 0 : 1;
  for (const MeshDensity density : {MeshDensity::adaptive, MeshDensity::full}) {
    // By hand, not through the file: whoever builds the mesh has to see to it.
    const DepthMesh mesh = rule(map, {.density = density, .threads = 1});
    wrong += vertices_off(mesh, 2);
    const auto hits = [&](double column, double row) {
      return std::isfinite(
          brute_force_distance_m(mesh, panorama_direction(column, row, map_width_px, map_width_px / 2)));
    };
    for (double at = 0.25; at < patch_px; at += 0.5) wrong += hits(first_column + at, first_row + at) ? 1 : 0;
    wrong += hits(first_column - 1, first_row - 1) ? 0 : 1;
  }
  return {static_cast<double>(wrong), fmt::format("{} wrong, {} texels cleaned", wrong, cleaned)};
}

Finding try_all_sky(int threads) {
  int wrong = 0;
  for (const MeshDensity density : {MeshDensity::adaptive, MeshDensity::full}) {
    const DepthMesh mesh =
        build_depth_mesh(constant_map(map_width_px, infinity), {.density = density, .threads = 1});
    wrong += static_cast<int>(mesh.triangles.size() + mesh.vertices_m.size());
    const Geometry geometry(mesh, Rgb::Constant(0.5F));
    for (int i = 0; i < map_width_px; ++i)
      wrong += geometry.nearest(ray_through(i + 0.5, 0.5 * i + 0.25)) ? 1 : 0;
  }
  SmallScene scene{.background = {},
                   .object = {ball_shape({0, 0, -4}, 1, 48, {.object_index = 1})},
                   .light = sun_and_sky({1, 1, 1}, 3, 0.5F, 1)};
  const SmallPicture picture =
      render_small(truth_scene_of(scene), {.artifact = Artifact::all, .threads = threads});
  for (std::size_t i = 0; i < picture.reference.values.size(); ++i)
    wrong += std::abs(picture.composite.picture.values[i] - picture.reference.values[i]) <= 1e-6F ? 0 : 1;
  return {static_cast<double>(wrong), fmt::format("{} wrong", wrong)};
}

Finding try_one_texel(const MeshRule& rule) {
  DepthMap map = constant_map(map_width_px, infinity);
  map.distance_m[first_row * map_width_px + first_column] = 2;
  int wrong = 0;
  std::size_t triangles = 0;
  for (const MeshDensity density : {MeshDensity::adaptive, MeshDensity::full}) {
    const DepthMesh mesh = rule(map, {.density = density, .threads = 1});
    triangles = mesh.triangles.size();
    wrong += vertices_off(mesh, 2);
    if (wrong > 0) break;  // a mesh that is elsewhere may be large, and is wrong without rays
    const Geometry geometry(mesh, Rgb::Constant(0.5F));
    for (int row = 0; row < map_width_px / 2; ++row)
      for (int column = 0; column < map_width_px; ++column) {
        const bool hit = geometry.nearest(ray_through(column + 0.5, row + 0.5)).has_value();
        wrong += hit == (row == first_row && column == first_column) ? 0 : 1;
      }
  }
  return {static_cast<double>(wrong),
          fmt::format("{} wrong, {} triangles at full density", wrong, triangles)};
}

StabilityCases depth_value_cases() {
  return {value_case("depth-0", 0, "0"),
          value_case("depth-negative", -1.5F, "-1.5 m"),
          value_case("depth-nan", std::numeric_limits<float>::quiet_NaN(), "no numbers"),
          value_case("depth-infinite", infinite, "infinite"),
          value_case("depth-minus-infinite", -infinite, "minus infinity"),
          value_case("depth-1e9", 1e9F, "1e9 m and so meant as nothing"),
          {.group = "depth",
           .name = "all-sky",
           .tried = "a map of nothing but sky, and an object before it",
           .expected = "an empty mesh, rays that meet nothing, the reference as the composite",
           .unit = "vertices, rays and values",
           .tolerance = 0,
           .reason = exact_count + " (values that differ by more than 1e-6)",
           .run = [](const StabilityOptions& options) { return try_all_sky(options.threads); }},
          {.group = "depth",
           .name = "one-valid-texel",
           .tried = "a map of which one texel is measured",
           .expected = "a surface inside that texel and nowhere else",
           .unit = "vertices and rays",
           .tolerance = 0,
           .reason = exact_count,
           .run = [](const StabilityOptions&) { return try_one_texel(); }}};
}

}  // namespace seamline::stability
