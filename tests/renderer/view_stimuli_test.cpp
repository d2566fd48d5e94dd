// Stimuli as other eyes see them: both estimators, the depth map's own centre, and views made of depth beside
// them.
#include <gtest/gtest.h>

#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "renderer/scene/eyes.h"
#include "renderer/set/stimulus_scene.h"
#include "renderer/views/depth_image.h"
#include "renderer/views/synthesised_views.h"
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

TEST(Views, OtherEyesSeeTheSeamsOfTheCentresDepthMapAndThoseFadeAsItGrows) {
  const TruthScene scene = small_scene(eyes_of(2, 0.4, 3));
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const auto estimator = estimator_of(scene, kind);
    const auto picture = [&](int width_px, Artifact artifact) {
      const LocalScene local = stimulus_scene(scene, *estimator, {.width_px = width_px}, true, 2);
      return compose(estimator->stimulus(recipe(artifact, Isolation::query), local.world(), {}).sums).picture;
    };
    const Image reference = picture(64, Artifact::none);
    for (const Artifact artifact : {Artifact::receiver, Artifact::occlusion, Artifact::all}) {
      const double coarse = display_rmse(picture(32, artifact), reference, 0);
      const double fine = display_rmse(picture(2048, artifact), reference, 0);
      EXPECT_LT(fine, 0.5 * coarse) << word(artifact) << " " << word(kind);
    }
  }
}

TEST(Views, BothEstimatorsShowOtherEyesTheSame) {
  const TruthScene scene = small_scene(eyes_of(2, 0.4, 3));
  const auto path = estimator_of(scene, Estimator::path), fast = estimator_of(scene, Estimator::fast);
  const LocalScene local = stimulus_scene(scene, *path, {.width_px = 256}, true, 2);
  for (const Artifact artifact : {Artifact::receiver, Artifact::occlusion, Artifact::all}) {
    const Recipe how = recipe(artifact, Isolation::query);
    EXPECT_LT(display_rmse(compose(path->stimulus(how, local.world(), {}).sums).picture,
                           compose(fast->stimulus(how, local.world(), {}).sums).picture, 0),
              0.02)
        << word(artifact);
  }
}

TEST(SynthesisedViews, ComeNearTheRenderedEyes) {
  const View view = eyes_of(2, 0.1, 4);
  const TruthScene mono = small_scene({}), two = small_scene(view);
  const Image seen = estimator_of(mono, Estimator::fast)->reference({}).radiance;
  const Image eyes = estimator_of(two, Estimator::fast)->reference({}).radiance;
  const Geometry everything = mono.geometry(true, {1, 2, 3});
  PictureWithDepth from{.colour = seen, .planar_m = planar_depth_m(mono.camera, [&](const Ray& ray) {
                                          const auto hit = everything.nearest(ray);
                                          return hit ? std::optional(hit->distance_m) : std::nullopt;
                                        })};
  const double focal_px = 0.5 * seen.width_px / static_cast<double>(mono.camera.tan_half_horizontal);
  double apart = 0, unmoved = 0;
  for (int eye = 0; eye < 2; ++eye) {
    const SynthesisedView made =
        view_from_depth(from, {.right_m = (eye - 0.5) * 0.1, .zero_parallax_m = 4, .focal_px = focal_px});
    Image rendered(seen.width_px, seen.height_px, 3);
    for (int y = 0; y < seen.height_px; ++y)
      for (int x = 0; x < seen.width_px; ++x) rendered.set_rgb(x, y, eyes.rgb(eye * seen.width_px + x, y));
    apart += display_rmse(made.picture, rendered, 0);
    unmoved += display_rmse(seen, rendered, 0);
  }
  EXPECT_LT(apart, 0.6 * unmoved);
}

}  // namespace
}  // namespace seamline::renderer
