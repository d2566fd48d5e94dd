// What a body touches: few places, out to its corners, whatever the order in which the ground was asked.
#include "physics/touching.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "falling_bodies.h"
#include "physics/ground_edges.h"
#include "physics/solid.h"

namespace seamline {
namespace {

using renderer::Touch;

std::vector<Touch> many_touches() {
  std::vector<Touch> touches;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const bool is_corner = i % 40 == 0 && j % 40 == 0;
      touches.push_back({.on_body_m = {0.01 * i - 0.2, -0.1, 0.01 * j - 0.2},
                         .distance_m = 1e-6 * ((7 * i + 3 * j) % 11),
                         .is_corner = is_corner});
    }
  return touches;
}

TEST(Touching, FewAreKeptAllCornersAmongThem) {
  const std::vector<Touch> all = many_touches(), kept = renderer::spread_touches(all, 0.05);
  EXPECT_LE(kept.size(), 100U);
  EXPECT_EQ(std::count_if(kept.begin(), kept.end(), [](const Touch& t) { return t.is_corner; }), 4);
}

TEST(Touching, TheOrderOfTheGroundMakesNoDifference) {
  std::vector<Touch> touches = many_touches();
  const std::vector<Touch> kept = renderer::spread_touches(touches, 0.05);
  std::reverse(touches.begin(), touches.end());
  const std::vector<Touch> again = renderer::spread_touches(touches, 0.05);
  ASSERT_EQ(kept.size(), again.size());
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].on_body_m, again[i].on_body_m) << i;
}

TEST(Touching, AnImpulseIsGivenOnceToTheNearest) {
  const std::vector<Touch> before = {
      {.on_body_m = {0, 0, 0}, .impulse = 3},
      {.on_body_m = {1, 0, 0}, .push = Eigen::Vector3d::UnitX(), .impulse = 5}};
  std::vector<Touch> now = {
      {.on_body_m = {0.01, 0, 0}}, {.on_body_m = {0.02, 0, 0}}, {.on_body_m = {1, 0, 0}}};
  renderer::keep_impulses(before, 0.1, now);
  EXPECT_EQ(now[0].impulse, 3);
  EXPECT_EQ(now[1].impulse, 0);
  EXPECT_EQ(now[2].impulse, 0) << "another side";
}

TEST(Solid, ABoxHasItsVolumeAndMoments) {
  const Eigen::Vector3d half_m(0.1, 0.2, 0.3);
  const renderer::Solid box{.corners_m = test::box_corners(half_m),
                            .triangles = {{0, 2, 1},
                                          {1, 2, 3},
                                          {4, 5, 6},
                                          {5, 7, 6},
                                          {0, 1, 4},
                                          {1, 5, 4},
                                          {2, 6, 3},
                                          {3, 6, 7},
                                          {0, 4, 2},
                                          {2, 4, 6},
                                          {1, 3, 5},
                                          {3, 7, 5}}};
  const renderer::VolumeMoments moments = renderer::moments_of(box);
  const double volume_m3 = 8 * half_m.prod();
  EXPECT_NEAR(moments.volume_m3, volume_m3, 1e-12);
  EXPECT_LT(moments.first.norm(), 1e-12);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(moments.second(axis, axis), volume_m3 * half_m[axis] * half_m[axis] / 3, 1e-12);
  for (const auto& [normal, distance_m] : renderer::faces_of(box))
    EXPECT_NEAR(distance_m, normal.cwiseAbs().dot(half_m), 1e-12);
}

TEST(GroundEdges, CornersInOnePlaceAreOneWhateverTheirNumbers) {
  const renderer::Ground shared = test::flat_floor(3);
  renderer::Ground apart;
  for (const auto& corners : shared.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.vertices_m.size());
    for (const std::uint32_t corner : corners) apart.vertices_m.push_back(shared.vertices_m[corner]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  const renderer::JoinedGround one = renderer::joined_ground(shared), other = renderer::joined_ground(apart);
  for (std::size_t t = 0; t < shared.triangles.size(); ++t)
    for (std::size_t side = 0; side < 3; ++side)
      EXPECT_EQ(one.neighbours[t][side].triangle, other.neighbours[t][side].triangle);
}

}  // namespace
}  // namespace seamline
