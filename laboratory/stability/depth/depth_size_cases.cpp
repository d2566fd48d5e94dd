#include "laboratory/stability/depth/depth_size_cases.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/worst.h"
#include "laboratory/stability/depth/mesh_check.h"
#include "raytracer/tracing/geometry.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

/// Largest error of rays in random directions.
double largest_error(const DepthMesh& mesh, int rays,
                     const std::function<double(const Eigen::Vector3d&)>& expected_m) {
  const Geometry geometry(mesh, Rgb::Constant(0.5F));
  Random random(6);
  double error = 0;
  for (int i = 0; i < rays; ++i) {
    const double y = 2 * random.uniform() - 1, azimuth = 2 * std::numbers::pi * random.uniform(),
                 across = std::sqrt(1 - y * y);
    const Eigen::Vector3d d(across * std::cos(azimuth), y, across * std::sin(azimuth));
    const auto hit = geometry.nearest({Eigen::Vector3f::Zero(), d.cast<float>()});
    error = worse(error, hit ? relative_error(hit->distance_m, expected_m(d)) : nan);
  }
  return error;
}

}  // namespace

Finding try_wrong_sizes(bool odd, const ReadRule& read) {
  struct Size {
    int width, height, channels;
  };
  const std::vector<Size> sizes =
      odd ? std::vector<Size>{{1, 1, 1}, {3, 1, 1}, {5, 2, 1}, {63, 31, 1}, {2049, 1024, 1}}
          : std::vector<Size>{{2, 2, 1}, {4, 4, 1}, {64, 33, 1}, {64, 31, 1}, {32, 64, 1}, {64, 32, 3}};
  const TemporaryFolder folder;
  int accepted = 0;
  std::string said;
  for (const Size& size : sizes) {
    write_exr(folder.path() / "map.exr", Image(size.width, size.height, size.channels, 2.0F));
    try {
      (void)read(folder.path() / "map.exr");
      ++accepted;
    } catch (const InputError& error) {
      said = error.what();
    }
  }
  return {static_cast<double>(accepted), fmt::format("{} of {} accepted", accepted, sizes.size())};
}

Finding try_widths(const std::vector<int>& widths_px, int threads) {
  double error = 0;
  for (const int width_px : widths_px) {
    const auto mesh_of = [&](MeshDensity density) {
      return build_depth_mesh(constant_map(width_px, 2), {.density = density, .threads = threads});
    };
    error = worse(error, largest_error(mesh_of(MeshDensity::adaptive), 2000,
                                       [](const Eigen::Vector3d&) { return 2.0; }));
    const DepthMesh full = mesh_of(MeshDensity::full);
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d d =
          panorama_direction(0.05 * i * width_px, (0.05 * i + 0.02) * width_px / 2, width_px, width_px / 2);
      error = worse(error, relative_error(brute_force_distance_m(full, d), 2));
    }
  }
  return {error, fmt::format("{} widths, largest error {:.2g}", widths_px.size(), error)};
}

Finding try_largest_width(int threads) {
  constexpr int width_px = 16384;
  const DepthMesh mesh = build_depth_mesh(room_map(width_px), {.threads = threads});
  const double error = largest_error(mesh, 20000, room_distance_m);
  return {error, fmt::format("{} triangles, largest error {:.2g}", mesh.triangles.size(), error)};
}

Finding try_alternating(int threads) {
  constexpr double near_m = 2, far_m = 4;
  constexpr std::size_t most_triangles = 2UL * 2048 * 1024;  // of the dense sphere
  const DepthMap map =
      make_depth_map(64, [](int column, int row) { return (column + row) % 2 == 0 ? near_m : far_m; });
  const auto mesh_of = [&](double tolerance) {
    return build_depth_mesh(map, {.tolerance = tolerance, .threads = threads});
  };
  const std::size_t fine = mesh_of(1e-4).triangles.size();
  const DepthMesh coarse = mesh_of(0.01);
  const double outside = largest_error(coarse, 20000, [](const Eigen::Vector3d&) { return 3.0; });
  const std::string found =
      fmt::format("{} triangles within 1e-4, {} within 0.01; distances within {:.3g} of 3 m", fine,
                  coarse.triangles.size(), outside);
  if (fine > most_triangles || coarse.triangles.size() >= fine) return {nan, found};
  return {outside, found};
}

StabilityCases depth_size_cases() {
  const auto widths = [](const std::string& name, const std::vector<int>& widths_px,
                         const std::string& tried) {
    return StabilityCase{
        .group = "depth",
        .name = name,
        .tried = "a sphere of 2 m in maps of width " + tried + ", both densities",
        .expected = "2 m along every ray",
        .unit = "relative",
        .tolerance = 1.03e-4,
        .reason = "the mesh's bound 1e-4 at the dense sphere's vertices; 2.4e-6 more between them",
        .run = [widths_px](const StabilityOptions& options) {
          return try_widths(widths_px, options.threads);
        }};
  };
  const auto refused = [](const std::string& name, bool odd, const std::string& tried) {
    return StabilityCase{.group = "depth",
                         .name = name,
                         .tried = tried,
                         .expected = "refused by a sentence",
                         .unit = "files accepted",
                         .tolerance = 0,
                         .reason = exact_count,
                         .run = [odd](const StabilityOptions&) { return try_wrong_sizes(odd); }};
  };
  return {
      widths("width-2", {2, 4, 6}, "2, 4 and 6"),
      widths("width-uneven", {10, 426, 2050}, "10, 426 and 2050, no powers of two"),
      {.group = "depth",
       .name = "width-16384",
       .tried = "a room in a map of 16384 x 8192, adaptive mesh",
       .expected = "the walls' distance along every ray",
       .unit = "relative",
       .tolerance = 1.01e-4 + 4e-4,
       .reason = "the mesh's bound 1e-4; a cell of 3.8e-4 rad cuts a crease of two walls by up to as much",
       .run = [](const StabilityOptions& options) { return try_largest_width(options.threads); },
       .slow = true},
      {.group = "depth",
       .name = "alternating-texels",
       .tried = "2,048 texels that are 2 and 4 m away by turns, meshes within 1e-4 and 0.01",
       .expected = "surfaces from 2 to 4 m along every ray; no more triangles than the dense sphere has, and "
                   "fewer within 0.01",
       .unit = "of 3 m",
       .tolerance = 0.3334 + 0.01,
       .reason = "2 and 4 m lie a third off 3 m; the mesh's bound of 0.01",
       .run = [](const StabilityOptions& options) { return try_alternating(options.threads); },
       .slow = true},
      refused("width-odd-refused", true, "files of odd width: 1, 3, 5, 63 and 2049 px"),
      refused("width-not-2-to-1-refused", false,
              "files that are not twice as wide as high, or of three channels"),
  };
}

}  // namespace seamline::stability
