// Stimuli as other eyes see them: both estimators, the depth map's own centre, and views made of depth beside
// them.
#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "raytracer/scene/eyes.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "sets/stimulus_scene.h"
#include "shapes.h"
#include "stimuli/pictures/difference.h"

namespace seamline::renderer {
namespace {

View eyes_of(int views, double separation_m, double zero_parallax_m) {
  return {.kind = ViewKind::interleaved,
          .views = views,
          .separation_m = separation_m,
          .zero_parallax_m = zero_parallax_m,
          .sheet = five_views_sheet};
}

/// Three balls on a floor, a bar before the first; one sun and a little sky.
TruthScene small_scene(const View& view) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 8, 0.5F), test::box({-1.7F, -1, -3.1F}, {-1.5F, 0.6F, -2.9F}, 0.5F)};
  for (std::size_t i = 0; i < 3; ++i)
    parts.objects[i] = {test::sphere({-1.9F + 1.9F * static_cast<float>(i), -0.6F, -4}, 0.4F, 40, 0.5F,
                                     static_cast<int>(i) + 1)};
  Light light;
  light.bounces = 1;
  light.environment_radiance = Rgb::Constant(0.2F);
  light.suns.push_back({Eigen::Vector3f(-0.5F, 0.8F, 0.1F).normalized(), Rgb::Constant(3.0F), 0});
  TruthScene scene = test::scene_of(std::move(parts), std::move(light), 96, 54);
  scene.definition.view = view;
  scene.camera = view_camera(scene.camera, view);
  return scene;
}

std::unique_ptr<SceneEstimator> estimator_of(const TruthScene& scene, Estimator kind) {
  auto estimator = make_estimator(
      kind, scene, {.spp = 16, .seed = 1, .threads = 2, .who_is_in_front = true, .depth_bounces = true});
  estimator->take_object(1, {});
  return estimator;
}

TEST(Views, AtNoSeparationTheLeftEyeSeesThePictureOfOneByteForByte) {
  const TruthScene mono = small_scene({}), two = small_scene(eyes_of(2, 0.0, 3));
  const Image one = estimator_of(mono, Estimator::path)->reference({}).radiance;
  const Image both = estimator_of(two, Estimator::path)->reference({}).radiance;
  ASSERT_EQ(both.width_px, 2 * one.width_px);
  for (int y = 0; y < one.height_px; ++y)
    for (int x = 0; x < one.width_px; ++x)
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_EQ(both.at(x, y, channel), one.at(x, y, channel)) << x << " " << y;
}

TEST(Views, OtherEyesSeeTheSeamsOfTheCentresDepthMapAndBothEstimatorsShowThemAlike) {
  const TruthScene scene = small_scene(eyes_of(2, 0.4, 3));
  std::map<std::pair<Artifact, int>, std::vector<double>> errors;  // by path, by fast
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const auto estimator = estimator_of(scene, kind);
    const auto picture = [&](int width_px, Artifact artifact) {
      const LocalScene local = stimulus_scene(scene, *estimator, {.width_px = width_px}, true, 2);
      return compose(estimator->stimulus(recipe(artifact, Isolation::query), local.world(), {}).sums).picture;
    };
    const Image reference = picture(64, Artifact::none);
    for (const Artifact artifact : {Artifact::receiver, Artifact::occlusion, Artifact::all})
      for (const int width_px : {32, 2048})
        errors[{artifact, width_px}].push_back(display_rmse(picture(width_px, artifact), reference, 0));
  }
  for (const auto& [what, both] : errors)
    EXPECT_NEAR(both[1], both[0], 0.1 * both[0] + 0.001) << word(what.first) << " " << what.second;
  // What the map never saw, because it was captured from between the eyes, is missing at any width.
  for (const Artifact artifact : {Artifact::receiver, Artifact::occlusion, Artifact::all})
    EXPECT_LT(errors[std::pair(artifact, 2048)][0],
              (artifact == Artifact::receiver ? 0.5 : 0.8) * errors[std::pair(artifact, 32)][0])
        << word(artifact);
}

}  // namespace
}  // namespace seamline::renderer
