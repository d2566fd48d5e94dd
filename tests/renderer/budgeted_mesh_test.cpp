#include "renderer/depth/budget/budgeted_mesh.h"

#include <gtest/gtest.h>

#include "renderer/depth/budget/budgeted_panorama.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

using test::check_rays;
using test::count_edges;
using test::random_map;
using test::room_map;

/// A quarter of the view matters, as what people see in front of something does.
ShownWeights quarter_weights(DepthRole role) {
  ShownWeights weights{.width_px = 64, .height_px = 32, .texels = {}};
  weights.texels.resize(64 * 32);
  for (std::size_t row = 8; row < 24; ++row)
    for (std::size_t column = 24; column < 40; ++column)
      weights.texels[row * 64 + column][static_cast<std::size_t>(role)] = 1;
  return weights;
}

double wrong_share(const DepthMesh& mesh, const DenseSphere& sphere, int first_column, int last_column) {
  int wrong = 0, all = 0;
  for (int row = sphere.height / 4; row < sphere.height * 3 / 4; row += 3)
    for (int column = first_column; column < last_column; column += 3, ++all) {
      const double r = static_cast<double>(sphere.at(row, column));
      const double found_m = test::hit_distance_m(mesh, sphere.direction(row, column));
      wrong += std::abs(found_m - r) > 0.01 * r ? 1 : 0;
    }
  return static_cast<double>(wrong) / all;
}

TEST(BudgetedMesh, SpendsExactlyWhatIsAskedWithoutCracks) {
  for (const std::int64_t samples : {512, 1500, 3001}) {
    for (const bool weighs : {false, true}) {
      SCOPED_TRACE(samples);
      const DepthMap map = room_map(128);
      DenseSphere sphere = make_dense_sphere(map, 0, 1, 128);
      const ShownWeights weights = quarter_weights(DepthRole::blocker);
      const BudgetedMesh made = build_budgeted_mesh(sphere, samples, weighs ? &weights : nullptr, 0, 1);
      EXPECT_EQ(made.measured + made.holes, samples);
      EXPECT_EQ(std::ssize(made.mesh.vertices_m), samples + 2);  // and the poles
      const auto edges = count_edges(made.mesh);
      EXPECT_FALSE(edges.repeated);
      EXPECT_TRUE(edges.boundary.empty());
      EXPECT_EQ(made.mesh.vertices_m.size() + made.mesh.triangles.size(), edges.edges + 2);  // a sphere
      const auto rays = check_rays(made.mesh, sphere);
      EXPECT_EQ(rays.rays_without_hit, 0);
      EXPECT_EQ(rays.wrong_side, 0);
    }
  }
}

TEST(BudgetedMesh, IsTheFullMeshWhereSamplesAreEnough) {
  const DepthMap map = room_map(64);
  DenseSphere sphere = make_dense_sphere(map, 0, 1, 64);
  const BudgetedMesh made = build_budgeted_mesh(sphere, 64 * 32 + 1000, nullptr, 0, 1);
  EXPECT_EQ(made.measured, 64 * 32);
  EXPECT_LT(check_rays(made.mesh, sphere).largest_error, 1e-6);
}

TEST(BudgetedMesh, SamplesAreFewerWrongWhereItShows) {
  const DepthMap map = room_map(512);
  const auto share = [&](const ShownWeights* weights, int first, int last) {
    DenseSphere sphere = make_dense_sphere(map, 0, 1, 512);
    return wrong_share(build_budgeted_mesh(sphere, 2048, weights, 0, 1).mesh, sphere, first, last);
  };
  const ShownWeights weights = quarter_weights(DepthRole::blocker);
  EXPECT_LT(share(&weights, 200, 310), share(nullptr, 200, 310));
  EXPECT_GE(share(&weights, 0, 110), share(nullptr, 0, 110));
}

// Weights are about the camera; a map turned by its own columns is the same map.
TEST(BudgetedMesh, TurnsWithTheMap) {
  const DepthMap map = room_map(512);
  DepthMap turned = map;
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < map.width_px; ++column)
      turned.distance_m[static_cast<std::size_t>(row * map.width_px + column)] =
          map.at((column + 128) % map.width_px, row);
  const ShownWeights weights = quarter_weights(DepthRole::occluder);
  DenseSphere here = make_dense_sphere(map, 0, 1, 512), there = make_dense_sphere(turned, 128, 1, 512);
  const DepthMesh one = build_budgeted_mesh(here, 3000, &weights, 0, 1).mesh,
                  other = build_budgeted_mesh(there, 3000, &weights, 0.25, 1).mesh;
  EXPECT_NEAR(wrong_share(one, here, 200, 310), wrong_share(other, here, 200, 310), 0.02);
}

TEST(BudgetedMesh, IsTheSameForAnyNumberOfThreads) {
  const DepthMap map = room_map(256);
  const auto mesh = [&](int threads) {
    DenseSphere sphere = make_dense_sphere(map, 0, threads, 256);
    return build_budgeted_mesh(sphere, 4096, nullptr, 0, threads).mesh;
  };
  const DepthMesh one = mesh(1), three = mesh(3);
  EXPECT_EQ(one.triangles, three.triangles);
  EXPECT_EQ(one.vertices_m, three.vertices_m);
}

TEST(BudgetedMesh, HolesStayHoles) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 4; ++i) {
    DepthMap map = random_map(256, random);
    for (int row = 20; row < 60; ++row)
      for (int column = 30; column < 90; ++column)
        map.distance_m[static_cast<std::size_t>(row * map.width_px + column)] = test::hole;
    DenseSphere sphere = make_dense_sphere(map, 0, 1, 256);
    const BudgetedMesh made = build_budgeted_mesh(sphere, 8000, nullptr, 0, 1);
    EXPECT_EQ(made.measured + made.holes, 8000);
    EXPECT_GT(made.holes, 0);
    EXPECT_FALSE(count_edges(made.mesh).repeated);
    EXPECT_EQ(test::hit_distance_m(made.mesh, sphere.direction(40, 60)),
              std::numeric_limits<double>::infinity());
  }
}

TEST(BudgetedMesh, PeopleSeeLessAtFinerWidths) {
  EXPECT_NEAR(share_seen(DepthRole::receiver, role_threshold_px[0]), 0.5, 1e-12);
  EXPECT_NEAR(share_seen(DepthRole::occluder, 2 * role_threshold_px[2]), 1 / (1 + std::exp(2.0)), 1e-12);
}

}  // namespace
}  // namespace seamline::renderer
