// Masks, mattes and layers that stand in for the depth mesh, or that it is made of.
#include "renderer/estimators/mitigation_masks.h"

#include <gtest/gtest.h>

#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/local_scene.h"
#include "renderer/depth/panorama_layers.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

/// Three balls on a floor; before the first one stands a slanting bar, and a roof beside it casts a shadow
/// over its feet. Sun and a little sky, no bounces.
TruthScene barred_scene() {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 8, 0.5F), test::box({-1.7F, -1, -3.1F}, {-1.5F, 0.6F, -2.9F}, 0.5F),
                      test::box({-3.2F, 0.4F, -5.2F}, {-1.2F, 0.5F, -3.4F}, 0.5F)};
  for (std::size_t i = 0; i < 3; ++i)
    parts.objects[i] = {test::sphere({-1.9F + 1.9F * static_cast<float>(i), -0.6F, -4}, 0.4F, 40, 0.5F,
                                     static_cast<int>(i) + 1)};
  Light light;
  light.bounces = 0;
  light.environment_radiance = Rgb::Constant(0.2F);
  light.suns.push_back({Eigen::Vector3f(-0.5F, 0.8F, 0.1F).normalized(), Rgb::Constant(3.0F), 0});
  return test::scene_of(std::move(parts), std::move(light), 96, 54);
}

struct Barred {
  TruthScene scene = barred_scene();
  std::unique_ptr<SceneEstimator> estimator;

  explicit Barred(Estimator kind = Estimator::path)
      : estimator(
            make_estimator(kind, scene, {.spp = 32, .seed = 1, .threads = 2, .who_is_in_front = true})) {
    estimator->take_object(1, {});
  }
  [[nodiscard]] LocalScene local(int width_px, Blockers blockers = Blockers::sheets) const {
    DepthSettings settings{.width_px = width_px, .mesh_tolerance = 1e-3};
    settings.mitigation.blockers = blockers;
    return make_local_scene(estimator->geometry().truth, settings, {.albedo = 0.5, .threads = 2});
  }
  [[nodiscard]] double error(Artifact artifact, const DepthWorld& world) const {
    const Image picture =
        compose(estimator->stimulus(recipe(artifact, Isolation::query), world, {}).sums).picture;
    const Image reference = reference_image(estimator->truth());
    double squares = 0;
    for (std::size_t i = 0; i < picture.values.size(); ++i)
      squares += std::pow(double{picture.values[i]} - double{reference.values[i]}, 2);
    return std::sqrt(squares / static_cast<double>(picture.values.size()));
  }
};

TEST(OcclusionMask, HidesWhatTheTruthHidesHoweverCoarseTheDepth) {
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const Barred barred(kind);
    LocalScene local = barred.local(64);
    const double without = barred.error(Artifact::occlusion, local.world());
    const MaskedObject object(barred.estimator->geometry().object);
    double before = without;
    for (const int width_px : {512, 4096}) {
      local.occlusion.emplace();
      local.occlusion->mask = occlusion_mask(barred.estimator->geometry().truth, object, width_px, 2);
      const double with = barred.error(Artifact::occlusion, local.world());
      EXPECT_LT(with, 0.7 * before) << width_px;
      before = with;
    }
    EXPECT_LT(before, 0.1 * without) << word(kind);
  }
}

TEST(OcclusionMask, IsNothingAwayFromTheObjectAndAShareOfATexelAtEdges) {
  const Barred barred;
  const DirectionMask mask = occlusion_mask(barred.estimator->geometry().truth,
                                            MaskedObject(barred.estimator->geometry().object), 512, 2);
  EXPECT_EQ(mask.at({1, 0, -1}), 0);
  EXPECT_EQ(mask.at({0, 0, 1}), 0);
  EXPECT_TRUE(masks(mask, {-1.6F, -0.5F, -3})) << "the bar";
  EXPECT_FALSE(masks(mask, {-1.7F, -0.5F, -4})) << "beside it";
  int shares = 0;
  for (const float texel : mask.texels) shares += texel > 0 && texel < 1 ? 1 : 0;
  EXPECT_GT(shares, 20);
}

TEST(OcclusionMask, OfTheMeshOnThePhotographsEdgesIsBetterThanTheMesh) {
  const Barred barred;
  const LocalScene mesh = barred.local(128);
  LocalScene moved = barred.local(128);
  const Image photograph = background_image(barred.estimator->truth());
  moved.occlusion.emplace();
  moved.occlusion->mask = detected_mask(moved.geometry, MaskedObject(barred.estimator->geometry().object),
                                        128, 2048, {photograph, barred.scene.camera, 2});
  EXPECT_LT(barred.error(Artifact::occlusion, moved.world()),
            barred.error(Artifact::occlusion, mesh.world()));
}

TEST(ShadowMatte, LightsWhatTheTruthLightsHoweverCoarseTheDepth) {
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const Barred barred(kind);
    LocalScene local = barred.local(64);
    const double without = barred.error(Artifact::overlap, local.world());
    local.matte =
        shadow_matte(barred.estimator->geometry().truth, barred.scene.light, barred.scene.camera, 4096, 2);
    const double with = barred.error(Artifact::overlap, local.world());
    EXPECT_LT(with, 0.6 * without) << "what remains is the sky past the coarse mesh; " << word(kind);
  }
}

TEST(ShadowMatte, AnswersOnlyTheQuestionOfRealSurfaces) {
  const Barred barred;
  LocalScene local = barred.local(64);
  const double shadow = barred.error(Artifact::shadow, local.world());
  local.matte =
      shadow_matte(barred.estimator->geometry().truth, barred.scene.light, barred.scene.camera, 256, 2);
  EXPECT_EQ(barred.error(Artifact::shadow, local.world()), shadow) << "coarse blockers stay";
  EXPECT_LT(barred.error(Artifact::none, local.world()), 1e-6);
}

TEST(ShadowMatte, OfASoftSunHasHalfLight) {
  TruthScene scene = barred_scene();
  scene.light.suns[0].angular_radius_rad = 0.1F;
  const Geometry truth = scene.geometry_without(1);
  const ShadowMatte matte = shadow_matte(truth, scene.light, scene.camera, 1024, 2);
  int between = 0, lit = 0, dark = 0;
  for (std::size_t i = 0; i < matte.of_suns[0].texels.size(); ++i) {
    if (matte.of_suns[0].known[i] == 0) continue;
    const float share = matte.of_suns[0].texels[i];
    (share == 0 ? lit : share == 1 ? dark : between) += 1;  // of the sun, what does not arrive
  }
  EXPECT_GT(between, 500);
  EXPECT_GT(lit, 1000);
  EXPECT_GT(dark, 100);
}

TEST(ShadowMatte, ThatIsDetectedCorrectsACoarseMesh) {
  const Barred barred;
  const LocalScene mesh = barred.local(64);
  LocalScene corrected = barred.local(64);
  const Image photograph = background_image(barred.estimator->truth());
  corrected.matte =
      detected_matte(corrected.geometry, barred.scene.light, 2048, {photograph, barred.scene.camera, 2});
  EXPECT_LT(barred.error(Artifact::overlap, corrected.world()),
            barred.error(Artifact::overlap, mesh.world()));
}

TEST(ShadowMatte, EverythingFromTheMeshTakesItToo) {
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const Barred barred(kind);
    LocalScene local = barred.local(1024);
    const double without = barred.error(Artifact::all, local.world());
    local.matte =
        shadow_matte(barred.estimator->geometry().truth, barred.scene.light, barred.scene.camera, 4096, 2);
    const double with = barred.error(Artifact::all, local.world());
    EXPECT_LE(with, 1.05 * without) << word(kind);
  }
}

TEST(Layers, ASlopeIsNoJumpAndAWallBehindIsOne) {
  // A floor 1.6 m below, texels of 5.6 degrees, towards the horizon.
  const auto floor_m = [](double degrees) {
    return static_cast<float>(1.6 / std::sin(degrees * 3.14159265358979 / 180));
  };
  EXPECT_GT(floor_m(9), 1.5F * floor_m(15));
  EXPECT_FALSE(is_segment_border(floor_m(20.2), floor_m(14.6), floor_m(9), floor_m(3.4)));
  EXPECT_TRUE(is_segment_border(2, 2.02F, 5, 5.1F));
  EXPECT_TRUE(is_segment_border(5.1F, 5, 2.02F, 2));
  EXPECT_FALSE(is_segment_border(2, 2, 2.1F, 2.1F)) << "a tenth";
  const float sky = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(is_segment_border(2, 2, sky, sky));
  EXPECT_FALSE(is_segment_border(sky, sky, sky, sky));
}

TEST(Layers, SegmentsKeepTheirTexelsOutlines) {
  DepthMap map{.width_px = 16, .height_px = 8, .distance_m = std::vector<float>(128, 5.0F)};
  for (const int row : {3, 4})
    for (const int column : {7, 8}) map.distance_m[static_cast<std::size_t>(row * 16 + column)] = 2.0F;
  const DepthMap finer = segmented(map, 128, 2);
  int near = 0;
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 128; ++column) {
      const bool inside = row >= 24 && row < 40 && column >= 56 && column < 72;
      near += finer.at(column, row) < 3 ? 1 : 0;
      EXPECT_EQ(finer.at(column, row), inside ? 2.0F : 5.0F) << column << ", " << row;
    }
  EXPECT_EQ(near, 16 * 16);
}

TEST(Layers, LightPassesBehindWhatBlocksIt) {
  const Barred barred;
  const LocalScene sheets = barred.local(256), layers = barred.local(256, Blockers::layers);
  // Short ways beside and behind the bar that are free: sheets from its edges to the floor are in some of
  // them.
  int in_sheets = 0, in_layers = 0;
  for (float z = -6.0F; z < -3.3F; z += 0.1F)
    for (float y = -0.9F; y < 0.4F; y += 0.05F)
      for (float x = -3.0F; x < -1.0F; x += 0.1F) {
        const Ray across{{x, y, z}, Eigen::Vector3f(1, 0, 0), 0.1F};
        if (barred.estimator->geometry().truth.occluded(across)) continue;
        in_sheets += sheets.geometry.occluded(across) ? 1 : 0;
        in_layers += layers.geometry.occluded(across) ? 1 : 0;
      }
  EXPECT_GT(in_sheets, 50);
  EXPECT_LT(in_layers, in_sheets / 2);
  // From the camera there are no holes around it.
  int missing = 0;
  for (int y = 0; y < 54; ++y)
    for (int x = 0; x < 96; ++x) {
      const Ray ray = centre_ray(barred.scene.camera, x, y);
      missing += barred.estimator->geometry().truth.occluded(ray) && !layers.geometry.occluded(ray) ? 1 : 0;
    }
  EXPECT_LE(missing, 60) << "of 5184, where a layer ends";
}

}  // namespace
}  // namespace seamline::renderer
