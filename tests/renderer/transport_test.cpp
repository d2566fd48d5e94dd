// Laws of light: what a renderer must give whatever the pixels look like.
#include "renderer/transport/transport.h"

#include <gtest/gtest.h>

#include "renderer/transport/uncovered_light.h"
#include "shapes.h"
#include "tests/renderer/sample_mean.h"

namespace seamline::renderer {
namespace {

using test::sample_mean;
using test::SampleMean;

TEST(Transport, ConvexBodyUnderAConstantEnvironmentReflectsAlbedoTimesRadiance) {
  const float albedo = 0.37F, radiance = 2.5F;
  const Geometry ball(std::vector{test::sphere({0, 0, -5}, 1.0F, 96, albedo)});
  Light light;
  light.environment_radiance = Rgb::Constant(radiance);
  const SampleMean found = sample_mean(20000, [&](int i) {
    const Sampler sampler(7, i, 0, 0);
    const Eigen::Array2f p = sampler.point(dimension::pixel) * 0.3F - 0.15F;
    const auto hit = ball.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(p[0], p[1], -1).normalized()});
    return hit ? double{radiance_with_and_without(ball, nullptr, *hit, light, sampler)
                            .without_object.total()[1]}
               : double{albedo * radiance};
  });
  EXPECT_NEAR(found.mean, albedo * radiance, 3 * found.standard_error + 1e-6);
}

class EmissiveSphere : public testing::TestWithParam<int> {};

TEST_P(EmissiveSphere, GivesEmissionTimesTheSumOfAlbedoPowers) {
  const int bounces = GetParam();
  const float albedo = 0.6F, emission = 1.5F;
  const Geometry furnace(std::vector{test::sphere({0, 0, 0}, 3.0F, 64, albedo, 0, emission)});
  Light light;
  light.bounces = bounces;
  // Emission seen directly is power 0, light scattered once power 1, and each bounce adds one scattering.
  double expected = 0;
  for (int power = 0; power <= bounces + 1; ++power) expected += emission * std::pow(albedo, power);
  const SampleMean found = sample_mean(4000, [&](int i) {
    const Sampler sampler(3, i, 0, 0);
    const auto hit = furnace.nearest({Eigen::Vector3f::Zero(), cosine_weighted({0, 1, 0}, sampler.point(0))});
    return double{
        radiance_with_and_without(furnace, nullptr, *hit, light, sampler).without_object.total()[0]};
  });
  EXPECT_NEAR(found.mean, expected, 3 * found.standard_error + 1e-4 * expected);
}

INSTANTIATE_TEST_SUITE_P(Bounces, EmissiveSphere, testing::Values(0, 1, 4, 16));

TEST(Transport, HardSunOnAPlaneIsIrradianceTimesCosineTimesAlbedoOverPi) {
  const Geometry plane(std::vector{test::floor(-1, 20, 0.5F)});
  Light light;
  light.suns.push_back({Eigen::Vector3f(1, 1, 0).normalized(), Rgb::Constant(8.0F), 0.0F});
  const auto hit = plane.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, -0.3F, -1).normalized()});
  ASSERT_TRUE(hit);
  const double found =
      radiance_with_and_without(plane, nullptr, *hit, light, Sampler(1, 0, 0, 0)).without_object.total()[0];
  EXPECT_NEAR(found, 8 * std::sqrt(0.5) * 0.5 / std::numbers::pi, 1e-5);
}

TEST(Transport, SoftSunHasTheHardSunsMeanOnAPlane) {
  const Geometry plane(std::vector{test::floor(-1, 20, 0.5F)});
  Light soft;
  soft.suns.push_back({Eigen::Vector3f(1, 1, 0).normalized(), Rgb::Constant(8.0F), 0.02F});
  const auto hit = plane.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, -0.3F, -1).normalized()});
  const SampleMean found = sample_mean(4000, [&](int i) {
    return double{
        radiance_with_and_without(plane, nullptr, *hit, soft, Sampler(1, i, 0, 0)).without_object.total()[0]};
  });
  EXPECT_NEAR(found.mean, 8 * std::sqrt(0.5) * 0.5 / std::numbers::pi, 3 * found.standard_error + 2e-4);
}

TEST(Transport, AmbientOcclusionSeesOnlyWhatIsNear) {
  // A ceiling over the whole floor: dark within the distance, bright beyond it.
  for (const float height : {1.0F, 10.0F}) {
    const Geometry geometry(std::vector{test::floor(-1, 50, 0.5F), test::floor(-1 + height, 500, 0.5F)});
    Light light;
    light.ambient_occlusion = true;
    light.bounces = 0;
    light.sky_distance_m = 2.0F;
    light.environment_radiance = Rgb::Ones();
    SurfacePoint point;
    point.position_m = {0, -1, -4};
    point.normal = point.geometric_normal = {0, 1, 0};
    point.distance_m = 4;
    point.albedo = Rgb::Constant(0.5F);
    const SampleMean found = sample_mean(4000, [&](int i) {
      return double{radiance_with_and_without(geometry, nullptr, point, light, Sampler(5, i, 0, 0))
                        .without_object.total()[0]};
    });
    // Rays with cosine over height / 2 reach the ceiling: a share of 1 - (height / 2)^2 of a cosine-weighted
    // hemisphere.
    const double expected = height < 2 ? 0.5 * 0.25 : 0.5;
    EXPECT_NEAR(found.mean, expected, 3 * found.standard_error + 1e-6);
  }
}

TEST(Transport, AnObjectThatNoLightPathReachesChangesNothing) {
  const Geometry room(std::vector{test::box({-3, -1, -6}, {3, 3, 2}, 0.7F),
                                  test::box({10, 0, 0}, {12, 2, 2}, 0.7F),
                                  test::sphere({0, 2, -3}, 0.3F, 16, 0.5F, 0, 4.0F)});
  const Geometry object(std::vector{test::sphere({11, 1, 1}, 0.5F, 32, 0.5F, 1)});
  Light light;
  light.bounces = 6;
  for (int i = 0; i < 3000; ++i) {
    const Sampler sampler(11, i, 0, 0);
    const auto hit = room.nearest({Eigen::Vector3f::Zero(), cosine_weighted({0, 0, -1}, sampler.point(0))});
    ASSERT_TRUE(hit);
    const RadiancePair pair = radiance_with_and_without(room, &object, *hit, light, sampler);
    EXPECT_TRUE((pair.without_object.total() == pair.with_object.total()).all());
  }
}

TEST(Transport, CoupledPairHasTheMeanOfIndependentPaths) {
  // Without coupling: the same scene with the object as a plain part.
  const auto room = test::box({-3, -1, -6}, {3, 3, 2}, 0.6F);
  const auto lamp = test::sphere({0, 2, -3}, 0.4F, 24, 0.5F, 0, 5.0F);
  const auto ball = test::sphere({0.5F, -0.4F, -3}, 0.6F, 48, 0.5F, 1);
  const Geometry truth(std::vector{room, lamp}), object(std::vector{ball}),
      everything(std::vector{room, lamp, ball});
  Light light;
  light.bounces = 3;
  const auto hit = truth.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(-0.35F, -0.45F, -1).normalized()});
  ASSERT_TRUE(hit);
  const SampleMean coupled = sample_mean(40000, [&](int i) {
    return double{
        radiance_with_and_without(truth, &object, *hit, light, Sampler(1, i, 0, 0)).with_object.total()[0]};
  });
  const SampleMean plain = sample_mean(40000, [&](int i) {
    return double{radiance_with_and_without(everything, nullptr, *hit, light, Sampler(2, i, 0, 0))
                      .without_object.total()[0]};
  });
  EXPECT_NEAR(coupled.mean, plain.mean, 3 * std::hypot(coupled.standard_error, plain.standard_error));
}

TEST(Transport, SplittingTheQuestionsBetweenEqualGeometriesChangesNothingOnAverage) {
  const auto room = test::box({-3, -1, -6}, {3, 3, 2}, 0.6F);
  const Geometry truth(std::vector{room}), twin(std::vector{room}),
      object(std::vector{test::sphere({0.5F, -0.4F, -3}, 0.6F, 48, 0.5F, 1)});
  Light light;
  light.environment_radiance = Rgb::Ones();
  light.suns.push_back({Eigen::Vector3f(0.2F, 1, 0.1F).normalized(), Rgb::Constant(3.0F), 0.0F});
  const auto real = truth.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0.1F, -0.45F, -1).normalized()});
  for (int i = 0; i < 2000; ++i) {
    const Sampler sampler(9, i, 0, 0);
    const RadiancePair pair = radiance_with_and_without(truth, &object, *real, light, sampler);
    const UncoveredPoint asked{&*real, {&twin, &*real}, &*real, sampler};
    RadiancePair direct;
    LightRays rays;
    direct_on_uncovered({&asked, 1}, object, light, {&direct, 1}, rays);
    EXPECT_NEAR(pair.without_object.direct[0], direct.without_object.direct[0], 1e-6);
    EXPECT_NEAR(pair.with_object.direct[0], direct.with_object.direct[0], 1e-6);
  }
}

}  // namespace
}  // namespace seamline::renderer
