#include "renderer/depth/adaptive_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

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

using Position = std::tuple<float, float, float>;

std::set<std::pair<Position, Position>> boundary_positions(const DepthMesh& mesh) {
  const auto position = [&](std::uint32_t i) {
    const Eigen::Vector3f& v = mesh.vertices_m[i];
    return Position{v.x(), v.y(), v.z()};
  };
  std::set<std::pair<Position, Position>> edges;
  for (const auto& [from, to] : count_edges(mesh).boundary) edges.insert({position(from), position(to)});
  return edges;
}

bool has_holes(const DepthMap& map) {
  return std::any_of(map.distance_m.begin(), map.distance_m.end(), is_hole);
}

/// All laws of an adaptive mesh, on one map over a dense sphere of at least this width.
void expect_laws(const DepthMap& map, int smallest_width, double tolerance) {
  const DenseSphere sphere = make_dense_sphere(map, 0, 1, smallest_width);
  const DepthMesh mesh = build_adaptive_mesh(sphere, tolerance, 1);
  const auto rays = check_rays(mesh, sphere);
  EXPECT_LE(rays.largest_error, tolerance * (1 + 1e-9));
  EXPECT_LE(mesh.max_relative_error, tolerance);
  EXPECT_EQ(rays.holes_covered, 0);
  EXPECT_EQ(rays.wrong_side, 0);
  const auto edges = count_edges(mesh);
  EXPECT_FALSE(edges.repeated);
  if (!has_holes(map)) {
    EXPECT_EQ(rays.rays_without_hit, 0);
    EXPECT_TRUE(edges.boundary.empty());
    EXPECT_EQ(mesh.vertices_m.size() + mesh.triangles.size(), edges.edges + 2);  // Euler: a sphere
  } else {
    EXPECT_EQ(boundary_positions(mesh), boundary_positions(build_full_mesh(sphere, 1)));
  }
}

TEST(AdaptiveMesh, HoldsItsLawsOnRandomMaps) {
  std::mt19937_64 random(20240607);
  for (int i = 0; i < 7 * 5 * 4; ++i) {  // every width with every sphere and tolerance
    SCOPED_TRACE(i);
    const int width = std::array{2, 8, 16, 30, 32, 50, 64}[static_cast<std::size_t>(i % 7)];
    const int sphere_width = std::array{32, 64, 36, 64, 50}[static_cast<std::size_t>(i % 5)];
    const double tolerance = std::array{1e-4, 1e-3, 1e-2, 0.1}[static_cast<std::size_t>(i % 4)];
    expect_laws(random_map(width, random), sphere_width, tolerance);
    if (HasFailure()) return;
  }
}

// Between the dense vertices the two meshes can part cells by different diagonals, but only where that
// changes nothing: cells that a larger triangle covers in part agree with its plane in all their corners.
// What is left are slivers along bent edges.
TEST(AdaptiveMesh, AgreesWithTheFullMeshAlongAnyRay) {
  std::mt19937_64 random(31);
  int rays = 0, apart = 0;
  for (int i = 0; i < 40; ++i) {
    const double tolerance = i % 2 == 0 ? 1e-3 : 1e-2;
    const DepthMap map = random_map(64, random);
    const DenseSphere sphere = make_dense_sphere(map, 0, 1, 64);
    const DepthMesh full = build_full_mesh(sphere, 1), adaptive = build_adaptive_mesh(sphere, tolerance, 1);
    for (int k = 0; k < 500; ++k, ++rays) {
      std::normal_distribution<double> normal;
      const Eigen::Vector3d d = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
      const double wanted_m = test::hit_distance_m(full, d), found_m = test::hit_distance_m(adaptive, d);
      if (wanted_m == found_m) continue;
      const double error = std::abs(found_m - wanted_m) / wanted_m;
      if (!(error <= tolerance * 1.001)) ++apart;
    }
  }
  EXPECT_LE(apart, rays / 10000);
}

TEST(AdaptiveMesh, HoldsItsLawsOnLargerMaps) {
  std::mt19937_64 random(99);
  for (const int width : {128, 150, 256}) {
    SCOPED_TRACE(width);
    expect_laws(random_map(width, random), width, 1e-3);
  }
  expect_laws(room_map(256), 256, 1e-4);
}

// Large triangles on a curved surface: near the poles, rays hit other triangles there than the grid's lines
// suggest.
TEST(AdaptiveMesh, HoldsItsLawsOnSmoothMapsWithLargeTriangles) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const Eigen::Vector3d k(uniform(random), uniform(random), uniform(random));
    const double phase = uniform(random);
    const DepthMap map = make_map(128, [&](int column, int row) {
      return 2 + std::sin(phase + k.dot(panorama_direction(column + 0.5, row + 0.5, 128, 64)));
    });
    expect_laws(map, 128, std::array{0.01, 0.03, 0.1}[static_cast<std::size_t>(i % 3)]);
  }
}

TEST(AdaptiveMesh, AConstantSphereNeedsFewTriangles) {
  const DepthMap map = make_map(64, [](int, int) { return 3.0; });
  const DepthMesh mesh = build_depth_mesh(map, {});
  // Of 4 million. A triangle may be as large as its circle of radius sqrt(2 tolerance) allows: 4 pi / (2
  // tolerance) is 63,000.
  EXPECT_LT(mesh.triangles.size(), 130000U);
  EXPECT_GT(mesh.max_relative_error, 0);
  EXPECT_LE(mesh.max_relative_error, 1e-4);
  for (const auto& v : mesh.vertices_m) EXPECT_NEAR(v.norm(), 3, 1e-6);
}

TEST(AdaptiveMesh, OneValidTexelAndAllSky) {
  const DepthMap sky = make_map(64, [](int, int) { return hole; });
  EXPECT_TRUE(build_depth_mesh(sky, {}).triangles.empty());
  EXPECT_TRUE(build_depth_mesh(sky, {}).vertices_m.empty());
  const DepthMap one =
      make_map(64, [](int column, int row) { return column == 5 && row == 9 ? 2.0F : hole; });
  // Its 32 x 32 vertices are a patch of 31 x 31 cells.
  const DepthMesh full = build_depth_mesh(one, {.density = MeshDensity::full});
  EXPECT_EQ(full.triangles.size(), 2U * 31 * 31);
  const DepthMesh mesh = build_depth_mesh(one, {});
  EXPECT_GT(mesh.triangles.size(), 0U);
  EXPECT_EQ(boundary_positions(mesh), boundary_positions(full));
}

TEST(AdaptiveMesh, ToleranceZeroIsFullDensityWhereNothingIsPlane) {
  std::mt19937_64 random(5);
  DepthMap map = make_map(64, [&](int, int) { return std::uniform_real_distribution<double>(1, 2)(random); });
  const DenseSphere sphere = make_dense_sphere(map, 0, 1, 64);
  const auto sorted = [](const DepthMesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> triangles = mesh.triangles;
    for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  const DepthMesh full = build_full_mesh(sphere, 1), adaptive = build_adaptive_mesh(sphere, 0, 1);
  EXPECT_EQ(sorted(full), sorted(adaptive));
  EXPECT_EQ(full.vertices_m, adaptive.vertices_m);
  EXPECT_EQ(adaptive.max_relative_error, 0);
}

TEST(AdaptiveMesh, IsTheSameForAnyNumberOfThreads) {
  std::mt19937_64 random(7);
  const DepthMap map = random_map(512, random);
  const DepthMesh one = build_depth_mesh(map, {.threads = 1});
  for (const int threads : {2, 3, 8}) {
    const DepthMesh many = build_depth_mesh(map, {.threads = threads});
    EXPECT_EQ(one.vertices_m, many.vertices_m);
    EXPECT_EQ(one.triangles, many.triangles);
    EXPECT_EQ(one.max_relative_error, many.max_relative_error);
  }
}

TEST(AdaptiveMesh, JumpsOfAMillionStayWithinTheBound) {
  const DepthMap checks =
      make_map(64, [](int column, int row) { return (column / 8 + row / 8) % 2 == 0 ? 1e-3 : 1e6; });
  expect_laws(checks, 64, 1e-4);
  const DepthMap tiny = make_map(32, [](int column, int) { return column % 3 == 0 ? 1e-38 : 9e8; });
  expect_laws(tiny, 32, 1e-4);
}

TEST(AdaptiveMesh, KeepsItsLawsAtTheDensityOfTheStudy) {
  for (const int width : {426, 2048, 3000}) {
    SCOPED_TRACE(width);
    const DepthMap map = room_map(width);
    const DepthMesh mesh = build_depth_mesh(map, {});
    const auto edges = count_edges(mesh);
    EXPECT_FALSE(edges.repeated);
    EXPECT_TRUE(edges.boundary.empty());
    EXPECT_EQ(mesh.vertices_m.size() + mesh.triangles.size(), edges.edges + 2);
    EXPECT_LE(mesh.max_relative_error, 1e-4);
    EXPECT_LT(mesh.triangles.size(), 400000U);
  }
}

}  // namespace
}  // namespace seamline::renderer
