// What small emitters in view send to the camera, beside the area that they cover by hand.
#include "renderer/estimators/seen_emission.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace seamline::renderer {
namespace {

constexpr float lamp_radiance = 200.0F;

/// A square lamp that faces the camera, in front of a wall of 1 m more depth.
TruthScene wall_with_lamp(float half_size_m, float radiance) {
  test::SceneParts parts;
  parts.background = {
      test::plane_shape({.centre_m = {0, 0, -5}, .v = Eigen::Vector3d::UnitY(), .half_size_m = 9}),
      test::plane_shape(
          {.centre_m = {0.313, 0.171, -4}, .v = Eigen::Vector3d::UnitY(), .half_size_m = half_size_m},
          {.emission = radiance})};
  for (int k = 1; k <= 3; ++k)
    parts.objects[static_cast<std::size_t>(k - 1)] = {
        test::sphere({static_cast<float>(k) - 2.0F, -0.9F, -3}, 0.2F, 8, 0.5F, k)};
  return test::scene_of(std::move(parts), Light{});
}

TEST(SeenEmission, IsTheCoveredAreaTimesTheRadianceHoweverSmall) {
  for (const float half_size_m : {0.001F, 0.01F, 0.03F}) {
    const TruthScene scene = wall_with_lamp(half_size_m, lamp_radiance);
    const auto seen = find_seen_emission(scene, 1);
    ASSERT_NE(seen, nullptr);
    double sum = 0;
    for (int y = 0; y < scene.camera.height_px; ++y)
      for (int x = 0; x < scene.camera.width_px; ++x) {
        SurfacePoint wall;
        seen->even_out(x, y, 0, wall);
        sum += static_cast<double>(wall.emission[0]);
      }
    const double side_px = 2 * static_cast<double>(half_size_m) / 4 * scene.camera.width_px /
                           (2 * static_cast<double>(scene.camera.tan_half_horizontal));
    const double expected = side_px * side_px * static_cast<double>(lamp_radiance);
    EXPECT_NEAR(sum, expected, 0.12 * expected) << half_size_m;
  }
}

TEST(SeenEmission, IsNotLookedForWhereNothingSmallShines) {
  EXPECT_EQ(find_seen_emission(wall_with_lamp(1.0F, lamp_radiance), 1), nullptr);
  EXPECT_EQ(find_seen_emission(wall_with_lamp(0.01F, 0.0F), 1), nullptr);
}

TEST(SeenEmission, LampBehindAnObjectIsSeenOnlyWhereTheObjectIsNot) {
  TruthScene scene = wall_with_lamp(0.01F, lamp_radiance);
  scene.objects[1] = {test::sphere({0.235F, 0.128F, -3}, 0.1F, 16, 0.5F, 2)};
  const auto seen = find_seen_emission(scene, 1);
  ASSERT_NE(seen, nullptr);
  double in_front = 0, behind = 0;
  for (int y = 0; y < scene.camera.height_px; ++y)
    for (int x = 0; x < scene.camera.width_px; ++x) {
      SurfacePoint wall;
      seen->even_out(x, y, 0, wall);
      in_front += static_cast<double>(wall.emission[0]);
      seen->even_out(x, y, 2, wall);
      behind += static_cast<double>(wall.emission[0]);
    }
  EXPECT_EQ(in_front, 0);
  EXPECT_GT(behind, 0);
}

}  // namespace
}  // namespace seamline::renderer
