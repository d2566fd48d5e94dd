// What a virtual object emits is in its picture once, whoever answers for its light.
#include <gtest/gtest.h>

#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

constexpr float ball_emission = 1.5F;

TruthScene dark_room_with_a_glowing_ball() {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 4), test::box({-1, -1, -6}, {1, 1, -5.5F}, 0.5F)};
  parts.objects[0] = {test::sphere({-1.6F, 0, -4}, 0.5F, 24, 0.3F, 1)};
  parts.objects[1] = {test::sphere({0, 0, -4}, 0.5F, 24, 0.0F, 2, ball_emission)};  // black: it only emits
  parts.objects[2] = {test::sphere({1.6F, 0, -4}, 0.5F, 24, 0.3F, 3)};
  Light light;
  light.bounces = 1;
  return test::scene_of(std::move(parts), light);
}

TEST(GlowingObject, IsAsBrightAsItsEmissionInEveryStimulus) {
  const TruthScene scene = dark_room_with_a_glowing_ball();
  const Geometry depth(std::vector{test::floor(-1, 4), test::box({-1, -1, -6}, {1, 1, -5.5F}, 0.5F)});
  for (const Estimator kind : {Estimator::fast, Estimator::path}) {
    const auto estimator = make_estimator(kind, scene, {.spp = 8, .seed = 1, .threads = 2});
    estimator->take_object(2, {});
    for (const Artifact artifact :
         {Artifact::receiver, Artifact::shadow, Artifact::overlap, Artifact::bounce, Artifact::none}) {
      const Image picture =
          compose(estimator->stimulus(recipe(artifact, Isolation::query), &depth, {}).sums).picture;
      EXPECT_NEAR(picture.at(picture.width_px / 2, picture.height_px / 2, 1), ball_emission, 1e-4F)
          << word(kind) << " " << word(artifact);
    }
  }
}

}  // namespace
}  // namespace seamline::renderer
