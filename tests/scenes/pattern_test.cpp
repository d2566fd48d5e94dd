// Patterns repeat without a seam, and lie on surfaces without stretching.
#include "scenes/shapes/pattern.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "scenes/builtin.h"
#include "scenes/rooms/car.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace {

class Patterns : public testing::TestWithParam<const char*> {};

/// Root mean square difference between two columns or rows.
double difference(const ByteImage& image, bool rows, int first, int second) {
  double sum = 0;
  for (int i = 0; i < image.width_px; ++i)
    for (int channel = 0; channel < 3; ++channel) {
      const auto code = [&](int line) {
        const int x = rows ? i : line, y = rows ? line : i;
        return static_cast<int>(
            image.values[static_cast<std::size_t>((y * image.width_px + x) * 3 + channel)]);
      };
      sum += std::pow(code(first) - code(second), 2);
    }
  return std::sqrt(sum / (3.0 * image.width_px));
}

TEST_P(Patterns, GoOnAcrossTheirEdges) {
  const PatternPictures pattern = make_pattern(GetParam());
  const int last = pattern.colour.width_px - 1;
  for (const bool rows : {false, true}) {
    double most = 0;
    for (int line = 0; line < last; ++line)
      most = std::max(most, difference(pattern.colour, rows, line, line + 1));
    EXPECT_LE(difference(pattern.colour, rows, last, 0), 1.05 * most) << (rows ? "rows" : "columns");
  }
}

TEST_P(Patterns, NormalsHaveUnitLengthAndPointOutOnTheWhole) {
  const PatternPictures pattern = make_pattern(GetParam());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < pattern.normal.values.size(); i += 3) {
    Eigen::Vector3d normal;
    for (std::size_t c = 0; c < 3; ++c)
      normal[static_cast<int>(c)] = pattern.normal.values[i + c] / 127.5 - 1;
    ASSERT_NEAR(normal.norm(), 1, 0.01);
    ASSERT_GT(normal.z(), 0);
    sum += normal;
  }
  EXPECT_LT(std::abs(sum.x()), 0.02 * sum.z());
  EXPECT_LT(std::abs(sum.y()), 0.02 * sum.z());
}

INSTANTIATE_TEST_SUITE_P(Every, Patterns, testing::Values("planks", "weave", "plaster", "concrete"),
                         [](const auto& each) { return std::string(each.param); });

TEST(Pattern, RefusesAnUnknownName) {
  EXPECT_THROW((void)make_pattern("tartan"), std::invalid_argument);
}

TEST(Patterned, KeepsLengthsOnEveryFaceOfABox) {
  const ScenePart part = patterned({"box", box({0, 0, 0}, {1, 2, 3})}, "planks");
  ASSERT_EQ(part.surface.pattern_m.size(), part.mesh.positions_m.size());
  for (const auto& triangle : part.mesh.triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto from = triangle[corner], to = triangle[(corner + 1) % 3];
      EXPECT_NEAR((part.mesh.positions_m[from] - part.mesh.positions_m[to]).norm(),
                  (part.surface.pattern_m[from] - part.surface.pattern_m[to]).norm(), 1e-12);
    }
}

/// Depth jumps at the wheels because one sees past them: nothing of the body is between tyre and arch.
TEST(Car, StandsOnItsWheelsWithAGapAroundEach) {
  double lowest_m = 1;
  for (const ScenePart& part : make_car()) {
    const Eigen::AlignedBox3d size = bounds(part.mesh);
    lowest_m = std::min(lowest_m, size.min().y());
    EXPECT_LT(size.sizes().x(), 3.8) << part.name;
    if (part.name != "car_paint") continue;
    for (const Eigen::Vector3d& place : part.mesh.positions_m)
      for (const double axle_m : {-1.1, 1.1})
        EXPECT_GT(std::hypot(place.x() - axle_m, place.y() - 0.29), 0.29 + 0.03);
  }
  EXPECT_NEAR(lowest_m, 0, 1e-9);
}

TEST(Loft, GlowsWithPanesOrIsOpenWithALamp) {
  const SceneContents glowing = builtin_scene("loft"), open = builtin_scene("loft_open");
  const auto panes = [](const SceneContents& room) {
    return std::count_if(room.parts.begin(), room.parts.end(),
                         [](const ScenePart& part) { return part.surface.emission_w_m2_sr[0] > 0; });
  };
  EXPECT_EQ(panes(glowing), 3);
  EXPECT_EQ(panes(open), 0);
  EXPECT_EQ(glowing.parts.size(), open.parts.size() + 3);
  EXPECT_FALSE(glowing.lamp.has_value());
  EXPECT_TRUE(open.lamp.has_value());
}

TEST(Furniture, TheChairStandsOnTheGround) {
  EXPECT_NEAR(bounds(builtin_furniture("chair").mesh).min().y(), 0, 1e-12);
  EXPECT_THROW((void)builtin_furniture("throne"), std::invalid_argument);
}

}  // namespace
}  // namespace seamline::scenes
