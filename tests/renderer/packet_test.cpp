// Rays asked in one call find what they find alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "raytracer/light/light.h"
#include "renderer/depth/capture.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

/// Many facets at many distances, and sky between them.
Geometry pebbles() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-5, 5), size(0.2F, 1.5F);
  std::vector<std::shared_ptr<const SurfaceMesh>> parts;
  for (int i = 0; i < 60; ++i) {
    auto pebble = std::make_shared<SurfaceMesh>(
        *test::sphere({place(random), place(random), place(random)}, size(random), 16, 0.3F, i % 4));
    if (i % 2 == 0) pebble->normals = std::vector<Eigen::Vector3f>(pebble->positions_m.size(), {0, 1, 0});
    parts.push_back(pebble);
  }
  return Geometry(parts);
}

std::vector<Ray> random_rays(std::size_t count) {
  std::mt19937 random(11);
  std::normal_distribution<float> normal;
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i)
    rays.push_back({Eigen::Vector3f(normal(random), normal(random), normal(random)) * 5.0F,
                    Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized(),
                    i % 3 == 0 ? 4.0F : std::numeric_limits<float>::infinity()});
  return rays;
}

/// Of a million rays from inside a closed ball of 8,000 facets, those that meet nothing.
int slipped(Edges edges) {
  const std::vector<std::shared_ptr<const SurfaceMesh>> ball = {test::sphere({0, 0, 0}, 3.0F, 128, 0.5F)};
  const Geometry geometry(ball, edges);
  constexpr int calls = 1000, rays_at_once = 1000;
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::vector<Ray> rays(rays_at_once);
  std::vector<std::uint8_t> blocked(rays_at_once);
  int missed = 0;
  for (int call = 0; call < calls; ++call) {
    for (Ray& ray : rays)
      ray = {Eigen::Vector3f(normal(random), normal(random), normal(random)) * 0.5F,
             Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized()};
    geometry.occluded(rays, blocked, Coherence::scattered);
    missed += static_cast<int>(std::count(blocked.begin(), blocked.end(), 0));
  }
  return missed;
}

TEST(Edges, NoRaySlipsThroughTightOnesAndFewThroughLooseOnes) {
  EXPECT_EQ(slipped(Edges::tight), 0);
  EXPECT_LE(slipped(Edges::loose), 20);
}

class Packets : public testing::TestWithParam<Coherence> {};

TEST_P(Packets, FindWhatSingleRaysFind) {
  const Geometry geometry = pebbles();
  for (const std::size_t count : {0U, 1U, 3U, 7U, 8U, 9U, 16U, 100U, 4001U}) {
    const std::vector<Ray> rays = random_rays(count);
    std::vector<std::optional<SurfacePoint>> hits(count);
    std::vector<std::uint8_t> blocked(count, 7);
    std::vector<float> distance_m(count, -1.0F);
    geometry.nearest(std::vector<Ray>(rays.rbegin(), rays.rend()), hits, GetParam());  // left over: replaced
    geometry.nearest(rays, hits, GetParam());
    geometry.occluded(rays, blocked, GetParam());
    geometry.distances(rays, distance_m);
    for (std::size_t i = 0; i < count; ++i) {
      const auto wanted = geometry.nearest(rays[i]);
      ASSERT_EQ(wanted.has_value(), hits[i].has_value()) << i;
      ASSERT_EQ(blocked[i], geometry.occluded(rays[i]) ? 1 : 0) << i;
      ASSERT_EQ(std::isinf(distance_m[i]), !wanted) << i;
      if (!wanted) continue;
      ASSERT_NEAR(hits[i]->distance_m, wanted->distance_m, 1e-5F * wanted->distance_m + 1e-6F);
      ASSERT_NEAR(distance_m[i], wanted->distance_m, 1e-5F * wanted->distance_m + 1e-6F);
      ASSERT_EQ(hits[i]->mesh, wanted->mesh);
      ASSERT_EQ(hits[i]->object_index, wanted->object_index);
      ASSERT_LT((hits[i]->normal - wanted->normal).norm(), 1e-4F);
      ASSERT_LT((hits[i]->geometric_normal - wanted->geometric_normal).norm(), 1e-4F);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Packets, testing::Values(Coherence::together, Coherence::scattered));

TEST(PacketCount, EveryRayIsCountedOnce) {
  const Geometry geometry = pebbles();
  const std::vector<Ray> rays = random_rays(29);
  std::vector<std::optional<SurfacePoint>> hits(29);
  std::vector<std::uint8_t> blocked(29);
  RayCounts counts;
  geometry.nearest(rays, hits, Coherence::together, &counts);
  geometry.occluded(rays, blocked, Coherence::scattered, &counts);
  geometry.nearest_from_centre(rays, hits, &counts);
  EXPECT_EQ(counts.traced, 3 * 29);
}

TEST(PacketCapture, IsTheSameMapForAnyNumberOfThreadsAndAnyWidth) {
  const Geometry geometry = pebbles();
  for (const int width : {2, 6, 10, 64, 130}) {
    const DepthMap one = capture_depth(geometry, width, 3, 1), three = capture_depth(geometry, width, 3, 3);
    EXPECT_EQ(one.distance_m, three.distance_m);
    for (int row = 0; row < one.height_px; ++row)
      for (int column = 0; column < width; ++column) {
        const auto hit = geometry.nearest(
            {Eigen::Vector3f::Zero(),
             panorama_direction(column + 3.5, row + 0.5, width, one.height_px).cast<float>()});
        if (hit)
          ASSERT_NEAR(one.at(column, row), hit->distance_m, 1e-5F * hit->distance_m);
        else
          ASSERT_TRUE(std::isinf(one.at(column, row)));
      }
  }
}

}  // namespace
}  // namespace seamline::renderer
