// Laws of the spots that lamps light on surfaces close to them: where paths go more often, nothing but noise
// changes.
#include "raytracer/light/bright_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "raytracer/light/light_sample.h"
#include "renderer/transport/path_batch.h"
#include "renderer/transport/transport.h"
#include "shapes.h"
#include "tests/renderer/sample_mean.h"

namespace seamline::renderer {
namespace {

using test::sample_mean;
using test::SampleMean;
using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

/// A floor, and a lamp above it.
Geometry lit_floor() {
  return Geometry(std::vector{test::floor(0, 4, 0.5F), test::sphere({0, 1, -3}, 0.5F, 32, 0.5F)});
}
Light lamp_at(float height_m) {
  Light light;
  light.bounces = 2;
  light.lamps.push_back({.position_m = {0.5F, height_m, -1}, .intensity_w_sr = Rgb::Constant(2)});
  return light;
}

SurfacePoint hanging_point(bool glossy) {
  SurfacePoint point;
  point.position_m = Eigen::Vector3f(-0.2F, 1.5F, -0.8F);
  point.normal = point.geometric_normal = Eigen::Vector3f(0.3F, -0.9F, 0.1F).normalized();
  point.to_viewer = Eigen::Vector3f(-0.5F, -0.8F, 0.2F).normalized();
  point.distance_m = 1;
  point.albedo = Rgb::Constant(0.6F);
  if (glossy) point.f0 = Rgb::Constant(0.3F), point.alpha = 0.3F;
  return point;
}

TEST(BrightPatches, AreFoundWhereALampStandsCloseToASurfaceAndNowhereElse) {
  const Geometry everything = lit_floor();
  const auto close = find_bright_patches(lamp_at(0.05F), everything);
  ASSERT_TRUE(close);
  ASSERT_EQ(close->patches.size(), 1U);
  const BrightPatch& patch = close->patches.front();
  EXPECT_LT((patch.foot_m - Eigen::Vector3f(0.5F, 0, -1)).norm(), 1e-4F);
  EXPECT_GT(patch.normal.y(), 0.9999F);
  EXPECT_NEAR(patch.height_m, 0.05F, 1e-5F);
  // Half of 4 pi times 2 W/sr falls on the floor, of albedo 0.5, which sends a pi-th along its normal.
  EXPECT_NEAR(patch.strength_w_sr, 2, 0.1);
  EXPECT_FALSE(find_bright_patches(lamp_at(1.5F), everything));
}

TEST(BrightPatches, AreAimedAtWithTheDensityThatIsSaid) {
  const auto bright = find_bright_patches(lamp_at(0.3F), lit_floor());
  ASSERT_TRUE(bright);
  const SurfacePoint from = hanging_point(false);
  const PatchAim aim = aim_at_patches(*bright, from);
  ASSERT_GT(aim.sum, 0.1F);
  EXPECT_LE(aim.sum, 0.5F);
  double sum = 0;
  constexpr int rings = 1500, turns = 1500;
  std::array<double, 4> expected = {}, found = {};
  const auto quarter = [&](const Eigen::Vector3f& d) {
    const Eigen::Vector3f centre = (bright->patches.front().foot_m - from.position_m).normalized();
    return static_cast<std::size_t>((d.x() > centre.x() ? 1 : 0) + (d.z() > centre.z() ? 2 : 0));
  };
  for (int r = 0; r < rings; ++r)
    for (int t = 0; t < turns; ++t) {
      const double y = -(r + 0.5) / rings, angle = 2 * std::numbers::pi * (t + 0.5) / turns;
      const double flat = std::sqrt(1 - y * y);
      const Eigen::Vector3f d =
          Eigen::Vector3d(flat * std::cos(angle), y, flat * std::sin(angle)).cast<float>();
      const double share =
          2 * std::numbers::pi / (rings * turns) * double{patch_density_sr(*bright, aim, from, d)};
      sum += share;
      expected[quarter(d)] += share / double{aim.sum};
    }
  EXPECT_NEAR(sum, double{aim.sum}, 2e-3);
  constexpr int samples = 40000;
  for (int i = 0; i < samples; ++i)
    found[quarter(direction_to_patch(*bright, aim, from, Sampler(5, i, 0, 0).point(0)))] += 1.0 / samples;
  for (std::size_t q = 0; q < 4; ++q) EXPECT_NEAR(found[q], expected[q], 4 * 0.5 / std::sqrt(samples)) << q;
}

TEST(BrightPatches, ChangeNoLightAndTakeAwayItsNoise) {
  const Geometry everything = lit_floor();
  for (const bool glossy : {false, true})
    for (const float height_m : {0.03F, 0.3F}) {
      const Light plain = lamp_at(height_m);
      Light aimed = plain;
      aimed.emitters = std::make_shared<EmittingSurfaces>(Meshes{}, find_bright_patches(plain, everything));
      ASSERT_TRUE(aimed.emitters->patches());
      const auto bounced = [&](const Light& light, int samples) {
        return sample_mean(samples, [&](int i) {
          const Split sent = radiance_with_and_without(everything, nullptr, hanging_point(glossy), light,
                                                       Sampler(3, i, 0, 0))
                                 .without_object;
          return double{sent.bounce[1] + sent.mirrored[1]};
        });
      };
      const SampleMean before = bounced(plain, 200000), after = bounced(aimed, 20000);
      EXPECT_NEAR(after.mean, before.mean, 4 * std::hypot(before.standard_error, after.standard_error))
          << height_m << glossy;
      EXPECT_LT(after.standard_error * std::sqrt(20000.0), 0.5 * before.standard_error * std::sqrt(200000.0))
          << height_m << glossy;
    }
}

TEST(BrightPatches, ChangeNoLightOfASkyOrAMapEither) {
  const Geometry nothing(std::vector{test::sphere({0, 9, -3}, 0.1F, 8, 0.5F)});
  const auto patches = find_bright_patches(lamp_at(0.1F), lit_floor());
  for (const bool is_mapped : {false, true}) {
    Light light;
    light.bounces = 0;
    light.environment_radiance = Rgb::Constant(2.5F);
    if (is_mapped) {
      light.environment_radiance = Rgb::Zero();
      light.environment = std::make_shared<EnvironmentMap>(Image(16, 8, 3, 2.5F), 0.0F);
    }
    light.emitters = std::make_shared<EmittingSurfaces>(Meshes{}, patches);
    const SampleMean sent = sample_mean(20000, [&](int i) {
      return double{
          radiance_with_and_without(nothing, nullptr, hanging_point(false), light, Sampler(7, i, 0, 0))
              .without_object.total()[1]};
    });
    EXPECT_NEAR(sent.mean, 0.6 * 2.5, 4 * sent.standard_error + 2e-3) << is_mapped;
  }
}

}  // namespace
}  // namespace seamline::renderer
