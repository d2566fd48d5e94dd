#include "renderer/depth/depth_mesh.h"

#include <gtest/gtest.h>

#include <numbers>

#include "renderer/depth/full_mesh.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

using test::check_rays;
using test::count_edges;
using test::hole;
using test::make_map;
using test::random_map;
using test::room_map;

constexpr MeshOptions full{.density = MeshDensity::full};

TEST(FullMesh, IsAClosedSphereWithoutHoles) {
  for (const int width : {2, 426, 2048}) {
    const DepthMesh mesh = build_depth_mesh(room_map(width), full);
    EXPECT_EQ(mesh.vertices_m.size(), 2048U * 1024 + 2);
    EXPECT_EQ(mesh.triangles.size(), 2U * 2048 * 1024);
    EXPECT_EQ(mesh.vertices_m.capacity(), mesh.vertices_m.size());
    EXPECT_EQ(mesh.triangles.capacity(), mesh.triangles.size());
    EXPECT_EQ(mesh.max_relative_error, 0);
  }
  const DepthMap map = room_map(128);
  const DepthMesh mesh = build_full_mesh(make_dense_sphere(map, 0, 1, 128), 1);
  const auto edges = count_edges(mesh);
  EXPECT_FALSE(edges.repeated);
  EXPECT_TRUE(edges.boundary.empty());
  EXPECT_EQ(mesh.vertices_m.size() + mesh.triangles.size(), edges.edges + 2);  // Euler: a sphere
}

TEST(FullMesh, FacesTheCentreAndTouchesNoHole) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 30; ++i) {
    const DepthMap map = random_map(32, random);
    const DenseSphere sphere = make_dense_sphere(map, 0, 1, 32);
    const DepthMesh mesh = build_full_mesh(sphere, 1);
    const auto rays = check_rays(mesh, sphere);
    EXPECT_EQ(rays.holes_covered, 0);
    EXPECT_EQ(rays.wrong_side, 0);
    EXPECT_EQ(rays.largest_error, 0);  // every dense vertex is a corner
    EXPECT_FALSE(count_edges(mesh).repeated);
    std::vector<bool> used(mesh.vertices_m.size());
    for (const auto& t : mesh.triangles)
      for (const std::uint32_t v : t) used.at(v) = true;
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
    for (const auto& v : mesh.vertices_m) EXPECT_TRUE(v.allFinite());
  }
}

TEST(FullMesh, UncleanValuesAreHoles) {
  const auto with = [](float value) {
    return build_depth_mesh(make_map(64, [&](int column, int) { return column == 3 ? value : 2.0F; }), full);
  };
  const DepthMesh wanted = with(hole);
  EXPECT_LT(wanted.triangles.size(), 2U * 2048 * 1024);
  for (const float value : {-1.0F, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_EQ(with(value).triangles, wanted.triangles) << value;
}

TEST(FullMesh, IsTheSameForAnyNumberOfThreads) {
  std::mt19937_64 random(13);
  const DepthMap map = random_map(64, random);
  const DepthMesh one = build_depth_mesh(map, {.density = MeshDensity::full, .threads = 1});
  const DepthMesh many = build_depth_mesh(map, {.density = MeshDensity::full, .threads = 5});
  EXPECT_EQ(one.vertices_m, many.vertices_m);
  EXPECT_EQ(one.triangles, many.triangles);
}

/// The vertices of a closed full mesh by row and column of the unturned panorama; the column of each is found
/// from its direction.
std::vector<Eigen::Vector3f> by_direction(const DepthMesh& mesh) {
  constexpr int w = 2048, h = 1024;
  std::vector<Eigen::Vector3f> grid(std::size_t{w} * h, Eigen::Vector3f::Zero());
  for (const auto& v : mesh.vertices_m) {
    const Eigen::Vector3d d = v.cast<double>().normalized();
    if (std::abs(d.y()) > 1 - 1e-9) continue;  // a pole
    const double azimuth_rad = std::atan2(d.x(), -d.z());
    const auto column = static_cast<int>(std::floor((azimuth_rad / (2 * std::numbers::pi) + 0.5) * w));
    const auto row = static_cast<int>(std::floor((0.5 - std::asin(d.y()) / std::numbers::pi) * h));
    grid.at(static_cast<std::size_t>(row * w + column)) = v;
  }
  return grid;
}

TEST(FullMesh, YawTurnsTheMapAndLeavesTheWorldWhereItIs) {
  for (const int width : {64, 2048}) {
    std::mt19937_64 random(17);
    const DepthMap map =
        make_map(width, [&](int, int) { return std::uniform_real_distribution<double>(1, 3)(random); });
    const auto wanted = by_direction(build_depth_mesh(map, full));
    for (const int yaw : {width == 64 ? 7 : 1, width / 2 + 3}) {
      // Captured with directions turned by yaw: texel c sees what texel c + yaw of the unturned map sees.
      const DepthMap turned = make_map(width, [&](int c, int r) {
        return static_cast<double>(map.at(((c + yaw) % width + width) % width, r));
      });
      const auto found = by_direction(
          build_depth_mesh(turned, {.density = MeshDensity::full, .yaw_texels = static_cast<double>(yaw)}));
      float largest = 0;
      for (std::size_t i = 0; i < wanted.size(); ++i)
        largest = std::max(largest, (wanted[i] - found[i]).norm());
      EXPECT_LT(largest, 1e-6) << width << " turned by " << yaw;
    }
  }
}

}  // namespace
}  // namespace seamline::renderer
