// Paths followed together against paths followed one at a time.
#include "renderer/transport/path_batch.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace seamline::renderer {
namespace {

/// A ball over a floor, under a sun and a sky.
class PathBatchTest : public testing::Test {
 protected:
  PathBatchTest() {
    light_.suns.push_back({Eigen::Vector3f(1, 2, 1).normalized(), Rgb::Constant(8.0F), 0.01F});
    light_.environment_radiance = {0.55F, 0.7F, 1.0F};
    light_.sky_rays = 2;
  }

  /// What the camera sees of the floor in sample `number`.
  [[nodiscard]] SurfacePoint point(int number) const {
    const Sampler sampler(5, number, 1, 0);
    const Eigen::Array2f p = sampler.point(dimension::pixel) - 0.5F;
    return *floor_.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(p[0], -0.5F, -1 + p[1]).normalized()});
  }
  [[nodiscard]] PathStart start(int number, bool has_tail) const {
    return {
        worlds_.all(), point(number), Sampler(5, number, 1, 0), {.has_tail = has_tail, .tail_weight = 4.0F}};
  }

  const Geometry floor_{std::vector{test::floor(-1, 20, 0.5F)}};
  const Geometry ball_{std::vector{test::sphere({0, -0.6F, -2}, 0.4F, 32, 0.7F, 1)}};
  const Worlds worlds_{.room = &floor_, .objects = &ball_, .others = {}, .object_count = 1};
  Light light_;
};

TEST_F(PathBatchTest, APathFindsTheSameAloneAndAmongOthers) {
  constexpr int count = 100;
  PathBatch together, alone;
  together.begin(worlds_, light_);
  for (int i = 0; i < count; ++i) together.add(start(i, i % 4 == 0));
  const std::span<const PathLight> found = together.trace();
  ASSERT_EQ(found.size(), static_cast<std::size_t>(count));
  int parted = 0;
  for (int i = 0; i < count; ++i) {
    alone.begin(worlds_, light_);
    alone.add(start(i, i % 4 == 0));
    const PathLight one = alone.trace().front();
    const PathLight& other = found[static_cast<std::size_t>(i)];
    for (const std::size_t world : {0U, 1U}) {
      EXPECT_TRUE(one.light[world].direct.isApprox(other.light[world].direct, 1e-4F)) << i;
      EXPECT_TRUE(one.light[world].bounce.isApprox(other.light[world].bounce, 1e-4F)) << i;
    }
    parted += (one.light[0].total() != one.light[1].total()).any() ? 1 : 0;
  }
  EXPECT_GT(parted, 5);  // some meet the ball
  EXPECT_LT(parted, count);
}

TEST_F(PathBatchTest, MeansAreThoseOfPathsTracedToTheirEnds) {
  constexpr int count = 40000, tail_every = 4;
  light_.bounces = 3;
  PathBatch paths;
  paths.begin(worlds_, light_);
  std::array<double, 2> found{}, expected{}, squares{};
  for (int i = 0; i < count; ++i) paths.add(start(i, i % tail_every == 0));
  const std::span<const PathLight> lights = paths.trace();
  Light one_sky_ray = light_;
  one_sky_ray.sky_rays = 1;
  for (int i = 0; i < count; ++i) {
    const PathStart from = start(i, true);
    const RadiancePair pair =
        radiance_with_and_without(floor_, &ball_, from.point, one_sky_ray, from.sampler);
    const std::array reference = {double{pair.with_object.total()[1]},
                                  double{pair.without_object.total()[1]}};
    for (std::size_t world = 0; world < 2; ++world) {
      const double light = lights[static_cast<std::size_t>(i)].light[world].total()[1];
      found[world] += light / count;
      expected[world] += reference[world] / count;
      squares[world] += std::pow(light - reference[world], 2) / count;
    }
  }
  for (std::size_t world = 0; world < 2; ++world)
    EXPECT_NEAR(found[world], expected[world], 4 * std::sqrt(squares[world] / count) + 1e-5);
}

TEST_F(PathBatchTest, ABatchCanBeUsedAgainAndMayBeEmpty) {
  PathBatch paths;
  paths.begin(worlds_, light_);
  EXPECT_TRUE(paths.trace().empty());
  paths.begin(worlds_, light_);
  paths.add(start(1, true));
  EXPECT_EQ(paths.trace().size(), 1U);
  paths.begin(worlds_, light_);
  EXPECT_EQ(paths.size(), 0U);
}

}  // namespace
}  // namespace seamline::renderer
