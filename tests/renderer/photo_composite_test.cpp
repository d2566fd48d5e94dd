// Laws of a composite onto a photograph: who hides, who shades, and what a given mask or matte answers.
#include "composites/photo_composite.h"

#include <gtest/gtest.h>

#include "composites/fast_photo.h"
#include "composites/objects/photo_objects.h"
#include "composites/seamless_width.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/seen_emission.h"
#include "shapes.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

/// A floor and a box under a sun and a sky, as a depth map knows them, and a photograph of one colour.
class PhotoComposite : public testing::Test {
 protected:
  PhotoComposite() {
    camera_.width_px = 64;
    camera_.height_px = 48;
    light_.bounces = 1;
    light_.environment_radiance = Rgb::Constant(0.5F);
    light_.suns = {{Eigen::Vector3f(0.6F, 1, 0.2F).normalized(), Rgb::Constant(4.0F), 0.0F}};
    world({test::floor(-1, 20), test::box({-2.2F, -1, -5}, {-1.2F, 0.6F, -4}, 0.5F)});
  }
  void world(const Meshes& meshes) {
    mesh_ = build_depth_mesh(capture_depth(Geometry(meshes), 1024, 0, 2), {.threads = 2});
    depth_.emplace(mesh_, Rgb::Constant(0.5F));
  }
  PhotoScene scene(const Geometry& objects) const {
    return {
        .photograph = photograph_, .camera = camera_, .depth = *depth_, .objects = objects, .light = light_};
  }
  static Image picture(const PhotoScene& scene, int spp = 16) {
    return compose(photo_by_path(scene, {}, 0, {.spp = spp, .threads = 2}).sums).picture;
  }
  static double sum(const Image& image) {
    double total = 0;
    for (const float value : image.values) total += double{value};
    return total;
  }

  Camera camera_;
  Image photograph_{64, 48, 3, 0.4F};
  Light light_;
  DepthMesh mesh_;
  std::optional<Geometry> depth_;
};

TEST_F(PhotoComposite, WhatNoObjectTouchesStaysThePhotograph) {
  light_.environment_radiance = Rgb::Zero();
  light_.bounces = 0;
  const Geometry objects(Meshes{test::sphere({0.5F, -0.4F, -4}, 0.5F, 32, 0.5F, 1)});
  const Image made = picture(scene(objects));
  std::size_t same = 0;
  for (std::size_t i = 0; i < made.values.size(); ++i)
    same += std::abs(made.values[i] - photograph_.values[i]) < 1e-6F ? 1 : 0;
  EXPECT_GT(same, made.values.size() / 2);
  EXPECT_LT(same, made.values.size());
}

/// Depth of a camera errs: a floor whose distances are off by a hundredth, each on its own.
DepthMesh noisy_mesh() {
  DepthMap map = capture_depth(Geometry(Meshes{test::floor(-1, 20)}), 512, 0, 2);
  Random random(3);
  for (float& distance_m : map.distance_m) distance_m *= static_cast<float>(1 + 0.02 * random.normal());
  return build_depth_mesh(map, {.density = MeshDensity::full, .threads = 2});
}

// 002, section 5: only who is in front is asked; the photograph is left alone.
TEST_F(PhotoComposite, OcclusionOnlyLeavesThePhotographAloneOnNoisyDepth) {
  Random random(5);
  for (float& value : photograph_.values) value = static_cast<float>(random.uniform());
  mesh_ = noisy_mesh();
  depth_.emplace(mesh_, Rgb::Constant(0.5F));
  const Geometry objects(Meshes{test::sphere({0.5F, 0.1F, -4}, 0.5F, 32, 0.5F, 1)});
  PhotoScene asked = scene(objects);
  asked.shadows = false;
  EXPECT_FALSE(fast_can_render(asked));
  const Image kept = picture(asked, 4);
  asked.shadows = true;
  const Image shaded = picture(asked, 4);
  int object = 0, outside = 0, changed = 0, darker_by_shadows = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      bool touches = false;  // any of 9 x 9 places in the pixel
      for (int i = 0; i < 81; ++i) {
        const float right = static_cast<float>(x) + static_cast<float>(i % 9) / 8,
                    down = static_cast<float>(y) + static_cast<float>(i / 9) / 8;
        const Ray ray{Eigen::Vector3f::Zero(), camera_.direction(right, down)};
        touches = touches || objects.nearest(ray).has_value();
      }
      const Rgb before = photograph_.rgb(x, y);
      const bool same = ((kept.rgb(x, y) - before).abs() <= 2e-5F * before).all();  // what sums round
      if (touches) {
        object += same ? 0 : 1;
        continue;
      }
      ++outside;
      changed += same ? 0 : 1;
      darker_by_shadows += shaded.rgb(x, y).mean() < 0.7F * before.mean() ? 1 : 0;
    }
  EXPECT_GT(object, 100);
  EXPECT_GT(outside, 2000);
  EXPECT_EQ(changed, 0);
  EXPECT_GT(darker_by_shadows, 20);
}

TEST_F(PhotoComposite, SeveralObjectsShadeEachOther) {
  light_.environment_radiance = Rgb::Zero();
  light_.bounces = 0;
  const auto low = test::sphere({0, -0.7F, -4}, 0.3F, 32, 0.5F, 1);
  // Up the sun's ray from the low one, and out of the picture.
  const Eigen::Vector3f above = Eigen::Vector3f(0, -0.7F, -4) + 6 * light_.suns[0].to_sun;
  const auto high = test::sphere(above, 0.6F, 32, 0.5F, 1);
  const Geometry alone(Meshes{low}), both(Meshes{low, high});
  const Image one = picture(scene(alone)), two = picture(scene(both));
  const int x = 32, y = 33;  // the low ball
  EXPECT_GT(one.at(x, y), 0.1F);
  EXPECT_EQ(two.at(x, y), 0.0F);
}

TEST_F(PhotoComposite, FastAndPathAgreeWithinTheirErrors) {
  const Meshes ball = {test::sphere({-0.4F, -0.4F, -4}, 0.6F, 48, 0.6F, 1)};
  const Geometry objects(ball);
  const PhotoScene asked = scene(objects);
  const PhotoEstimate fast =
      photo_by_fast(asked, {surface_of_depth(mesh_, 0.5), ball}, 0.01, 0, {.seed = 5, .threads = 2});
  const PhotoEstimate path = photo_by_path(asked, {}, 0, {.spp = 512, .seed = 9, .threads = 2});
  ASSERT_LE(fast.error.rmse(), 0.01);
  const Image a = compose(fast.sums).picture, b = compose(path.sums).picture;
  double square = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double difference = double{srgb_from_linear(a.values[i])} - double{srgb_from_linear(b.values[i])};
    square += difference * difference;
  }
  EXPECT_LT(std::sqrt(square / static_cast<double>(a.values.size())), 0.012 + path.error.rmse());
  EXPECT_NEAR(sum(a) / sum(b), 1, 0.01);
}

TEST_F(PhotoComposite, TheErrorIsOfThePictureThatIsMade) {
  const Meshes ball = {test::sphere({-0.4F, -0.4F, -4}, 0.6F, 48, 0.6F, 1)};
  const Geometry objects(ball);
  PhotoScene asked = scene(objects);
  asked.compositing = Compositing::additive;
  const PhotoEstimate path = photo_by_path(asked, {}, 0, {.spp = 16, .threads = 2});
  const PhotoEstimate fast =
      photo_by_fast(asked, {surface_of_depth(mesh_, 0.5), ball}, 0.02, 0, {.seed = 5, .threads = 2});
  EXPECT_EQ(path.sums.compositing, Compositing::additive);
  EXPECT_EQ(fast.sums.compositing, Compositing::additive);
  EXPECT_NE(path.error.rmse(), photo_by_path(scene(objects), {}, 0, {.spp = 16, .threads = 2}).error.rmse());
}

TEST_F(PhotoComposite, ManyThinBarsReachALargeErrorWithNoMoreSamplesThanASmallOne) {
  // Every pixel is partly covered: 16 samples of coverage alone would be further off than was asked.
  Meshes bars;
  for (int bar = 0; bar < 70; ++bar) {
    const float left_m = -1.5F + 3.0F * static_cast<float>(bar) / 70;
    bars.push_back(test::box({left_m, -0.9F, -2.01F}, {left_m + 0.012F, 0.9F, -2}, 0.9F, 1));
  }
  photograph_ = Image(64, 48, 3, 0.02F);
  const Geometry objects(bars);
  const auto made = [&](double error) {
    return photo_by_fast(scene(objects), {surface_of_depth(mesh_, 0.5), bars}, error, 0,
                         {.seed = 5, .threads = 2});
  };
  const PhotoEstimate large = made(0.034), small = made(0.0199);
  EXPECT_LE(large.error.rmse(), 0.034);
  EXPECT_LE(large.taken.most, small.taken.most);
}

TEST_F(PhotoComposite, TheErrorThatIsAskedForIsReached) {
  const Geometry objects(Meshes{test::sphere({-0.4F, -0.4F, -4}, 0.6F, 48, 0.6F, 1)});
  const PhotoEstimate made = photo_by_path(scene(objects), 0.003, 0, {.threads = 2});
  EXPECT_LE(made.error.rmse(), 0.003);
  EXPECT_GT(made.sums.spp, 16);
}

TEST_F(PhotoComposite, PathsFindTheSmallLampOfAnObject) {
  // It covers a hundredth of a pixel: most pictures of 64 samples a pixel meet it never, or once.
  constexpr float half_size_m = 0.003F, radiance = 300;
  light_ = {};
  light_.bounces = 0;
  const Meshes lamp = {
      test::box({-0.2F, -0.4F, -4.5F}, {0.8F, 0.6F, -4.01F}, 0.0F, 1),
      test::plane_shape(
          {.centre_m = {0.313, 0.171, -4}, .v = Eigen::Vector3d::UnitY(), .half_size_m = half_size_m},
          {.albedo = 0, .emission = radiance, .object_index = 1})};
  const Geometry objects(lamp);
  PhotoScene asked = scene(objects);
  const PhotoMeshes meshes{surface_of_depth(mesh_, 0.5), lamp};
  const auto light_of = [&](const PhotoScene& shown, std::uint64_t seed) {
    const PhotoEstimate made = photo_by_path(shown, {}, 0, {.spp = 64, .seed = seed, .threads = 2});
    double sum = 0;
    for (const auto& half : made.sums.halves)
      for (const StimulusPixel& pixel : half) sum += double{pixel.object[1]} / 64;
    return sum;
  };
  const double pixels_a_metre = camera_.width_px / (2 * double{camera_.tan_half_horizontal} * 4);
  const double expected = double{radiance} * std::pow(2 * double{half_size_m} * pixels_a_metre, 2);
  const auto seen = seen_objects(asked, meshes, 2);
  ASSERT_NE(seen, nullptr);
  PhotoScene evened = asked;
  evened.seen = seen.get();
  double spread = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    spread += std::pow(light_of(asked, seed) / expected - 1, 2) / 8;
    EXPECT_NEAR(light_of(evened, seed) / expected, 1, 0.12) << seed;
  }
  EXPECT_GT(spread, 0.1);
  const OcclusionTest test;
  asked.occlusion.test = &test;
  EXPECT_EQ(seen_objects(asked, meshes, 2), nullptr);
}

TEST_F(PhotoComposite, AMatteThatSaysWhatTheLocalSceneSaysChangesNothing) {
  // Nothing real shades anything here, so the true matte is black.
  world({test::floor(-1, 20)});
  const Geometry objects(Meshes{test::sphere({0, -0.4F, -4}, 0.5F, 32, 0.5F, 1)});
  PhotoScene asked = scene(objects);
  const Image without = picture(asked);
  const Mask none = even_mask(8, 0.0F);
  asked.shadow_matte = &none;
  const Image with = picture(asked);
  for (std::size_t i = 0; i < with.values.size(); ++i) ASSERT_NEAR(with.values[i], without.values[i], 2e-3F);
}

TEST_F(PhotoComposite, WhereTheMatteSaysShadowAnObjectTakesNoSunlight) {
  world({test::floor(-1, 20)});
  light_.bounces = 0;
  const Geometry objects(Meshes{test::sphere({0, 0.6F, -4}, 0.4F, 32, 0.5F, 1)});
  PhotoScene asked = scene(objects);
  const Image sunlit = picture(asked, 64);
  const Mask shadow = PhotographMask{Image(8, 6, 1, 1.0F)};
  asked.shadow_matte = &shadow;
  const Image shaded = picture(asked, 64);
  float darkest_sunlit = 1, darkest_shaded = 1;
  for (int y = 30; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      darkest_sunlit = std::min(darkest_sunlit, sunlit.at(x, y));
      darkest_shaded = std::min(darkest_shaded, shaded.at(x, y));
    }
  EXPECT_LT(darkest_sunlit, 0.25F);  // the sun's shadow
  EXPECT_GT(darkest_shaded, 0.32F);  // the sky's alone
}

TEST_F(PhotoComposite, AMaskDecidesWhoIsInFrontAtItsOwnResolution) {
  const Geometry objects(Meshes{test::sphere({0, 0, -6}, 1, 32, 0.5F, 1)});
  PhotoScene asked = scene(objects);
  PhotographMask half{Image(512, 384, 1, 0.0F)};
  for (int y = 0; y < 384; ++y)
    for (int x = 256; x < 512; ++x) half.values.at(x, y) = 1.0F;  // the right half is in front
  OcclusionTest test;
  test.mask = half;
  asked.occlusion.test = &test;
  light_.environment_radiance = Rgb::Zero();
  light_.suns.clear();
  const Image made = picture(asked);
  for (int x = 26; x < 32; ++x) EXPECT_EQ(made.at(x, 24), 0.0F) << x;           // a black ball
  for (int x = 32; x < 38; ++x) EXPECT_NEAR(made.at(x, 24), 0.4F, 1e-6F) << x;  // the photograph
}

TEST_F(PhotoComposite, MasksAreFoundByDirectionAroundTheSeamAndByPlace) {
  DirectionMask mask = even_mask(4, 0.0F);
  mask.texels[2] = 1.0F;  // up, just to the right of -Z
  const auto at = [&](const Eigen::Vector3f& direction) {
    return mask_at(mask, {direction.normalized(), Eigen::Array2f::Zero()});
  };
  EXPECT_NEAR(at({1, 1, -1}), std::clamp(at({1, 1, -1}), 0.5F, 1.0F), 0);
  EXPECT_NEAR(at({-1, 1, 1}), 0, 0.3F);
  mask.texels[2] = 0.0F;
  mask.texels[3] = mask.texels[0] = 1.0F;  // both sides of the seam behind
  EXPECT_NEAR(at({0, 1, 1}), at({0.001F, 1, 1}), 1e-2F);
  EXPECT_GT(at({0, 1, 1}), 0.7F);
}

TEST_F(PhotoComposite, ArtifactsArePresentWhereWhatMakesThemIs) {
  const auto found = [&](const Eigen::Vector3f& centre, float radius) {
    const Geometry objects(Meshes{test::sphere(centre, radius, 32, 0.5F, 1)});
    return present_artifacts(scene(objects), false, false);
  };
  light_.environment_radiance = Rgb::Zero();
  const PresentArtifacts free = found({1, -0.3F, -4}, 0.3F);
  EXPECT_TRUE(free.receiver);
  EXPECT_FALSE(free.occlusion || free.shadow || free.overlap);
  const PresentArtifacts behind = found({-2.4F, -0.2F, -6.5F}, 0.8F);  // the box before it
  EXPECT_TRUE(behind.occlusion);
  // In the box's shadow, which falls away from the sun, to the left.
  const PresentArtifacts shaded = found({-2.9F, -0.6F, -4.6F}, 0.3F);
  EXPECT_TRUE(shaded.shadow);
}

TEST(SeamlessWidth, IsThePapersForTheArtifactsThatArePresent) {
  const auto width = [](const PresentArtifacts& present) {
    return seamless_width(present, paper_thresholds()).width_px;
  };
  EXPECT_EQ(width({}), 64);
  EXPECT_EQ(width({.receiver = true}), 426);
  EXPECT_EQ(width({.shadow = true}), 206);
  EXPECT_EQ(width({.receiver = true, .shadow = true}), 426);
  EXPECT_EQ(width({.receiver = true, .occlusion = true}), 1126);
  EXPECT_EQ(width({.receiver = true, .overlap = true}), 1596);
  const SeamlessWidth none =
      seamless_width({.occlusion = true}, {{Artifact::occlusion, std::nullopt, std::nullopt}});
  EXPECT_FALSE(none.width_px.has_value());
  EXPECT_NE(none.needs.at(0).rule.find("occlusion_mask"), std::string::npos);
}

}  // namespace
}  // namespace seamline::renderer
