// Methods of real time in place of rays through the depth mesh, beside the traced answers.
#include <gtest/gtest.h>

#include "renderer/estimators/estimator.h"
#include "renderer/estimators/realtime_methods.h"
#include "renderer/picture/composite.h"
#include "renderer/realtime/realtime_world.h"
#include "sets/stimulus_scene.h"
#include "shapes.h"
#include "stimuli/pictures/difference.h"
#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

/// Of pictures whose pixels are counted or hold a penumbra; others are of two thirds of it.
constexpr int counted_width_px = 96, counted_height_px = 54;

/// Three balls on a floor, a bar before the first and a roof that shades its feet; one sun and a little sky.
TruthScene shaded_scene(float sun_radius_rad = 0, bool lamp = false,
                        int width_px = 2 * counted_width_px / 3) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 8, 0.5F), test::box({-1.7F, -1, -3.1F}, {-1.5F, 0.6F, -2.9F}, 0.5F),
                      test::box({-4.3F, 0.4F, -5.2F}, {-2.6F, 0.5F, -3.4F}, 0.5F)};
  for (std::size_t i = 0; i < 3; ++i)
    parts.objects[i] = {test::sphere({-1.9F + 1.9F * static_cast<float>(i), -0.6F, -4}, 0.4F, 40, 0.5F,
                                     static_cast<int>(i) + 1)};
  Light light;
  light.bounces = 1;
  light.environment_radiance = Rgb::Constant(0.2F);
  if (lamp)
    light.lamps.push_back({.position_m = {-3.0F, 3.0F, -3.0F}, .intensity_w_sr = Rgb::Constant(25.0F)});
  else
    light.suns.push_back(
        {Eigen::Vector3f(-0.5F, 0.8F, 0.1F).normalized(), Rgb::Constant(3.0F), sun_radius_rad});
  return test::scene_of(std::move(parts), std::move(light), width_px, width_px * 9 / 16);
}

struct Piped {
  TruthScene scene;
  std::unique_ptr<SceneEstimator> estimator;

  explicit Piped(Estimator kind = Estimator::path, TruthScene with = shaded_scene(), int spp = 32)
      : scene(std::move(with)),
        estimator(make_estimator(
            kind, scene,
            {.spp = spp, .seed = 1, .threads = 2, .who_is_in_front = true, .depth_bounces = true})) {
    estimator->take_object(1, {});
  }
  [[nodiscard]] LocalScene local(const Pipeline& pipeline, int width_px = 1024) const {
    // A tolerance so small because rays see the bumps that an adaptive mesh may have, and a bias does not.
    DepthSettings settings{.width_px = width_px, .mesh_tolerance = 2e-6};
    settings.pipeline = pipeline;
    return stimulus_scene(scene, *estimator, settings, true, 2);
  }
  [[nodiscard]] Image picture(Artifact artifact, const DepthWorld& world) const {
    return compose(estimator->stimulus(recipe(artifact, Isolation::query), world, {}).sums).picture;
  }
  /// Root mean square difference between a method and what it stands for.
  [[nodiscard]] double error(Artifact artifact, const LocalScene& world) const {
    return display_rmse(picture(artifact, world.world()), picture(artifact, world.traced_world()), 0);
  }
};

Pipeline maps(int width_px, ShadowFilter filter = ShadowFilter::none) {
  return {.shadows = PipelineShadows::shadow_map, .shadow_filter = filter, .shadow_map_px = width_px};
}

TEST(RealtimeMethods, ShadowMapsComeNearTracedShadowsInEveryArtifactTheyAnswer) {
  for (const Estimator kind : {Estimator::path, Estimator::fast})
    for (const bool lamp : {false, true}) {
      const Piped piped(kind, shaded_scene(0, lamp));
      const LocalScene coarse = piped.local(maps(16)), fine = piped.local(maps(1024));
      for (const Artifact artifact :
           {Artifact::receiver, Artifact::shadow, Artifact::overlap, Artifact::all}) {
        const double first = piped.error(artifact, coarse), last = piped.error(artifact, fine);
        EXPECT_LT(last, std::max(0.4 * first, 0.0015))
            << word(artifact) << " " << word(kind) << (lamp ? " lamp" : " sun");
        EXPECT_LT(last, 0.003) << word(artifact) << " " << word(kind) << (lamp ? " lamp" : " sun");
      }
    }
}

TEST(RealtimeMethods, BothEstimatorsShowTheSame) {
  const Piped path, fast(Estimator::fast);
  Pipeline cut = maps(256, ShadowFilter::pcf);
  cut.lights = PipelineLights::median_cut;
  cut.light_count = 8;
  for (const Pipeline& pipeline :
       {maps(128), cut, Pipeline{.normals = PipelineNormals::triangle_mean},
        Pipeline{.compositing = PipelineCompositing::additive},
        Pipeline{.shadows = PipelineShadows::shadow_map, .compositing = PipelineCompositing::dark_layer}}) {
    const LocalScene of_path = path.local(pipeline), of_fast = fast.local(pipeline);
    for (const Artifact artifact : {Artifact::receiver, Artifact::shadow, Artifact::overlap, Artifact::all})
      EXPECT_LT(
          display_rmse(path.picture(artifact, of_path.world()), fast.picture(artifact, of_fast.world()), 0),
          0.02)
          << canonical_text(pipeline) << " " << word(artifact);
  }
}

TEST(RealtimeMethods, TheTracedPipelineIsNoneAtAll) {
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const Piped piped(kind);
    EXPECT_EQ(piped.local({}).realtime, nullptr);
    // And one that says nothing has the same bytes.
    LocalScene local = piped.local({}, 256);
    const Image before = piped.picture(Artifact::all, local.world());
    auto nothing = std::make_shared<RealtimeWorld>();
    nothing->light = piped.scene.light;
    local.realtime = nothing;
    EXPECT_EQ(piped.picture(Artifact::all, local.world()).values, before.values);
  }
}

TEST(RealtimeMethods, SoftShadowsAreNearerToASoftSunThanHardOnes) {
  const Piped piped(Estimator::path, shaded_scene(0.06F, false, counted_width_px), 64);
  for (const Artifact artifact : {Artifact::receiver, Artifact::shadow}) {
    const double soft = piped.error(artifact, piped.local(maps(1024, ShadowFilter::pcss)));
    const double hard = piped.error(artifact, piped.local(maps(1024)));
    EXPECT_LT(soft, 0.8 * hard) << word(artifact);
  }
}

TEST(RealtimeMethods, GhostsAndDepthTestsHideWhatTheMeshHidesButForPixelsOnEdges) {
  const Piped piped(Estimator::path, shaded_scene(0, false, counted_width_px));
  const Image mesh = piped.picture(Artifact::occlusion, piped.local({}, 2048).world());
  for (const Occlusion method : {Occlusion::ghosts, Occlusion::depth_test}) {
    const LocalScene local = piped.local({.occlusion = method}, 2048);
    const Image shown = piped.picture(Artifact::occlusion, local.world());
    int differ = 0, large = 0;
    for (int y = 0; y < counted_height_px; ++y)
      for (int x = 0; x < counted_width_px; ++x) {
        const float most = (shown.rgb(x, y) - mesh.rgb(x, y)).abs().maxCoeff();
        differ += most > 1e-4F ? 1 : 0;
        large += most > 0.3F ? 1 : 0;
      }
    EXPECT_GT(differ, 0) << word(method);
    EXPECT_LT(differ, 60) << word(method) << ", of some 500 that show the ball";
    EXPECT_LT(large, 30) << word(method);
  }
}

TEST(RealtimeMethods, NormalsOfTheRealChangeWhatTheMeshReceives) {
  const Piped piped;
  for (const PipelineNormals normals :
       {PipelineNormals::truth, PipelineNormals::cross_products, PipelineNormals::triangle_mean}) {
    const double fine = piped.error(Artifact::all, piped.local({.normals = normals}, 2048));
    const double coarse = piped.error(Artifact::all, piped.local({.normals = normals}, 64));
    EXPECT_LT(fine, 0.02) << word(normals);
    EXPECT_GT(coarse, 1e-4) << word(normals);
  }
}

TEST(RealtimeMethods, MoreLightsComeNearerToTheEnvironment) {
  const Piped piped(Estimator::path, shaded_scene(), 64);
  const auto cut = [&](int count) {
    return piped.error(Artifact::receiver,
                       piped.local({.lights = PipelineLights::median_cut, .light_count = count}));
  };
  const double one = cut(1), many = cut(64);
  EXPECT_LT(many, 0.5 * one);
  EXPECT_LT(many, 0.02);
}

TEST(RealtimeMethods, ADarkLayerDarkensByItsOpacityAndNotWhereNothingIsShaded) {
  const Piped piped(Estimator::path, shaded_scene(0, false, counted_width_px));
  const LocalScene local =
      piped.local({.compositing = PipelineCompositing::dark_layer, .shadow_opacity = 0.4});
  const Composite composite =
      compose(piped.estimator->stimulus(recipe(Artifact::all, Isolation::query), local.world(), {}).sums);
  int full = 0;
  for (int y = 0; y < counted_height_px; ++y)
    for (int x = 0; x < counted_width_px; ++x) {
      const float ratio = composite.ratio.rgb(x, y)[0];
      EXPECT_GT(ratio, 0.6F - 1e-4F);
      EXPECT_LT(ratio, 1.0F + 1e-4F);
      full += ratio < 0.6F + 1e-4F ? 1 : 0;
    }
  EXPECT_GT(full, 20);
  // It knows nothing of the roof's shadow, in which the traced ratio stays near 1.
  const Image layered = piped.picture(Artifact::overlap, local.world()),
              traced = piped.picture(Artifact::overlap, local.traced_world());
  EXPECT_GT(display_rmse(layered, traced, 0), 0.005);
}

TEST(RealtimeMethods, AddingIsTheRatioWhereTheMeshIsTheTruth) {
  const Piped piped;
  const LocalScene local = piped.local({.compositing = PipelineCompositing::additive}, 4096);
  EXPECT_LT(piped.error(Artifact::receiver, local), 0.004);
  EXPECT_GT(piped.error(Artifact::all, piped.local({.compositing = PipelineCompositing::additive}, 64)),
            1e-4);
}

TEST(RealtimeMethods, OcclusionFieldsDarkenAroundTheObjectAndOnIt) {
  TruthScene sky = shaded_scene();
  sky.light.suns.clear();
  sky.light.environment_radiance = Rgb::Constant(1.0F);
  const Piped piped(Estimator::path, std::move(sky), 64);
  const auto field = [](int bands, int shells) {
    return Pipeline{
        .shadows = PipelineShadows::occlusion_field, .field_bands = bands, .field_shells = shells};
  };
  const double without = display_rmse(piped.picture(Artifact::none, piped.local({}).world()),
                                      background_image(piped.estimator->truth()), 0);
  for (const Artifact artifact : {Artifact::receiver, Artifact::shadow}) {
    const double coarse = piped.error(artifact, piped.local(field(2, 2)));
    const double fine = piped.error(artifact, piped.local(field(6, 16)));
    EXPECT_LT(fine, coarse) << word(artifact);
    EXPECT_LT(fine, 0.012) << word(artifact);
  }
  EXPECT_GT(without, 0.02);
}

TEST(RealtimeMethods, ShadowMapsNeedALight) {
  TruthScene dark = shaded_scene();
  dark.light.suns.clear();
  const Piped piped(Estimator::path, std::move(dark), 4);
  EXPECT_NE(test::complaint_of([&] { (void)piped.local(maps(64)); }).find("median_cut"), std::string::npos);
}

}  // namespace
}  // namespace seamline::renderer
