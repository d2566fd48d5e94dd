// Rays from the panorama's centre find without search what Embree finds.
#include "raytracer/tracing/direction_table.h"

#include <gtest/gtest.h>

#include "raytracer/tracing/geometry.h"
#include "raytracer/tracing/triangle_neighbours.h"
#include "renderer/depth/adaptive_mesh.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

std::vector<Ray> rays_from_centre(int count, std::mt19937_64& random) {
  std::normal_distribution<float> normal;
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i)
    rays.push_back({Eigen::Vector3f::Zero(),
                    Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized()});
  // The poles, and along the seam, which lies at +Z.
  for (const float y : {-1.0F, 1.0F})
    for (const float x : {-1e-3F, 0.0F, 1e-6F, 2e-2F})
      rays.push_back({Eigen::Vector3f::Zero(), Eigen::Vector3f(x, y, x * 0.3F).normalized()});
  for (int i = 0; i < 200; ++i)
    rays.push_back({Eigen::Vector3f::Zero(),
                    Eigen::Vector3f(static_cast<float>(i % 3 - 1) * 1e-4F, normal(random), 1).normalized()});
  // Along the edges of the cube of cells.
  for (int i = 0; i < 100; ++i)
    rays.push_back(
        {Eigen::Vector3f::Zero(),
         Eigen::Vector3f(1, i % 2 == 0 ? 1 : -1, 0.02F * static_cast<float>(i - 50)).normalized()});
  return rays;
}

/// Depth jumps up to 1e9 times: the truth is sought in double precision, since Embree in single precision is
/// off by more than the tolerance in one of 400 rays here.
TEST(DirectionTable, FindsTheNearestTriangleOnRandomMeshesWithJumpsAndHoles) {
  std::mt19937_64 random(77);
  int other_hit = 0, other_distance = 0, rays_traced = 0;
  for (int i = 0; i < 18; ++i) {
    const DepthMap map = test::random_map(std::array{16, 30, 64}[static_cast<std::size_t>(i % 3)], random);
    const DenseSphere sphere = make_dense_sphere(map, 0, 1, 64);
    const DepthMesh mesh = build_adaptive_mesh(sphere, 1e-3, 1);
    const Geometry geometry(mesh, Rgb::Constant(0.5F));
    const std::vector<Ray> rays = rays_from_centre(200, random);
    std::vector<std::optional<SurfacePoint>> found(rays.size());
    geometry.nearest_from_centre(rays, found);
    for (std::size_t k = 0; k < rays.size(); ++k, ++rays_traced) {
      const double wanted_m = test::hit_distance_m(mesh, rays[k].direction.cast<double>());
      if (found[k].has_value() != std::isfinite(wanted_m)) {
        ++other_hit;
        continue;
      }
      if (!found[k]) continue;
      // A surface seen at a grazing angle magnifies rounding.
      const double cosine = -static_cast<double>(found[k]->geometric_normal.dot(rays[k].direction));
      const double error = std::abs(static_cast<double>(found[k]->distance_m) - wanted_m) / wanted_m;
      other_distance += error > 1e-5 + 1e-6 / cosine ? 1 : 0;
    }
  }
  // Within rounding of an edge, or of a hole's border.
  EXPECT_LE(other_hit, rays_traced / 1000);
  EXPECT_LE(other_distance, rays_traced / 1000);
}

TEST(DirectionTable, FindsWhatEmbreeFindsInARoom) {
  std::mt19937_64 random(5);
  const Geometry room(build_depth_mesh(test::room_map(512), {}), Rgb::Constant(0.4F));
  const std::vector<Ray> rays = rays_from_centre(20000, random);
  std::vector<std::optional<SurfacePoint>> found(rays.size());
  room.nearest_from_centre(rays, found);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto wanted = room.nearest(rays[i]);
    if (!wanted) continue;  // Embree without its robust flag slips through an edge now and then
    ASSERT_TRUE(found[i].has_value());
    EXPECT_NEAR(found[i]->distance_m / wanted->distance_m, 1, 1e-5);
    EXPECT_LT((found[i]->position_m - wanted->position_m).norm(), 1e-4);
    EXPECT_GT(found[i]->geometric_normal.dot(wanted->geometric_normal), 0.99);
    EXPECT_EQ(found[i]->normal, found[i]->geometric_normal);
    EXPECT_EQ(found[i]->albedo[0], 0.4F);
  }
}

TEST(DirectionTable, RespectsTheEndOfTheRay) {
  const DepthMesh mesh = build_depth_mesh(test::make_map(64, [](int, int) { return 3.0; }), {});
  const Geometry geometry(mesh, Rgb::Constant(0.5F));
  const std::vector<Ray> rays = {{Eigen::Vector3f::Zero(), {0, 0, -1}, 2.9F},
                                 {Eigen::Vector3f::Zero(), {0, 0, -1}, 3.1F}};
  std::vector<std::optional<SurfacePoint>> hits(2);
  geometry.nearest_from_centre(rays, hits);
  EXPECT_FALSE(hits[0].has_value());
  ASSERT_TRUE(hits[1].has_value());
  EXPECT_NEAR(hits[1]->distance_m, 3, 1e-3);
}

TEST(DirectionTable, AnswersNearlyAllRaysItself) {
  const DepthMesh mesh = build_depth_mesh(test::room_map(512), {});
  const auto table = make_direction_table(mesh.vertices_m, mesh.triangles,
                                          triangle_neighbours(mesh.vertices_m.size(), mesh.triangles));
  ASSERT_TRUE(table.has_value());
  std::mt19937_64 random(3);
  int not_found = 0;
  const auto rays = rays_from_centre(20000, random);
  for (const Ray& ray : rays) {
    const std::uint32_t triangle = find_triangle(*table, ray.direction, DirectionTable::nothing);
    EXPECT_NE(triangle, DirectionTable::nothing);
    not_found += triangle == DirectionTable::not_found ? 1 : 0;
  }
  EXPECT_LE(not_found, 40);  // 0.2 %
}

TEST(DirectionTable, RefusesWhatIsNoTriangulationOfDirections) {
  const std::vector<Eigen::Vector3f> vertices = {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2},
                                                 {-1, -1, -3}, {1, -1, -3}, {0, 1, -3}};
  const auto has_table = [&](const std::vector<Triangle>& triangles) {
    return make_direction_table(vertices, triangles, triangle_neighbours(vertices.size(), triangles))
        .has_value();
  };
  EXPECT_TRUE(has_table({{0, 1, 2}}));
  EXPECT_FALSE(has_table({{0, 2, 1}}));
  EXPECT_FALSE(has_table({{0, 1, 2}, {3, 4, 5}}));
}

}  // namespace
}  // namespace seamline::renderer
