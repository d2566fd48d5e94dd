// Laws of lamps, emitting surfaces and environment maps: what is sampled is what is there.
#include "raytracer/light/light_sample.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "renderer/transport/transport.h"
#include "shapes.h"
#include "tests/renderer/sample_mean.h"

namespace seamline::renderer {
namespace {

using test::sample_mean;
using test::SampleMean;

constexpr double pi = std::numbers::pi;

SurfacePoint floor_point(float albedo = 0.5F) {
  SurfacePoint point;
  point.position_m = Eigen::Vector3f(0.2F, 0, -0.3F);
  point.normal = point.geometric_normal = Eigen::Vector3f::UnitY();
  point.distance_m = 1;
  point.albedo = Rgb::Constant(albedo);
  return point;
}

/// A sky with a small bright sun, a coloured horizon and black texels.
Image test_sky(int width_px) {
  Image sky(width_px, width_px / 2, 3);
  for (int y = 0; y < sky.height_px; ++y)
    for (int x = 0; x < sky.width_px; ++x) {
      const float up = 1.0F - static_cast<float>(y) / static_cast<float>(sky.height_px);
      sky.set_rgb(x, y, x % 5 == 0 ? Rgb::Zero() : Rgb(0.2F + 0.1F * up, 0.3F * up, 0.5F));
    }
  sky.set_rgb(width_px / 3, width_px / 8, {300, 250, 200});
  return sky;
}

/// Irradiance on a plane, summed over a fine grid of directions.
Rgb brute_force_irradiance(const EnvironmentMap& map, const Eigen::Vector3f& normal) {
  constexpr int rows = 1024, columns = 2048;
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (int row = 0; row < rows; ++row) {
    const double elevation = (0.5 - (row + 0.5) / rows) * pi;
    const double texel_sr =
        2 * pi / columns *
        (std::sin((0.5 - static_cast<double>(row) / rows) * pi) - std::sin((0.5 - (row + 1.0) / rows) * pi));
    for (int column = 0; column < columns; ++column) {
      const double azimuth = ((column + 0.5) / columns - 0.5) * 2 * pi;
      const Eigen::Vector3d d(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                              -std::cos(azimuth) * std::cos(elevation));
      const double cosine = std::max(0.0, d.dot(normal.cast<double>()));
      if (cosine > 0) sum += map.radiance(d.cast<float>()).cast<double>() * (cosine * texel_sr);
    }
  }
  return sum.cast<float>();
}

TEST(EnvironmentMap, LooksAlongMinusZAtItsCentreAndTurnsAboutTheVertical) {
  Image sky(64, 32, 3);
  sky.set_rgb(32, 16, {1, 0, 0});  // just right of and below the centre
  sky.set_rgb(48, 16, {0, 1, 0});  // a quarter turn to the right: +X
  sky.set_rgb(10, 0, {0, 0, 1});   // at the zenith
  const EnvironmentMap map(sky, 0.0F);
  const auto at = [](double column, double row) {
    const double azimuth = (column / 64 - 0.5) * 2 * pi, elevation = (0.5 - row / 32) * pi;
    return Eigen::Vector3d(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                           -std::cos(azimuth) * std::cos(elevation))
        .cast<float>()
        .eval();
  };
  EXPECT_NEAR(map.radiance(at(32.5, 16.5))[0], 1, 1e-4);
  EXPECT_NEAR(map.radiance(at(48.5, 16.5))[1], 1, 1e-4);
  EXPECT_NEAR(map.radiance(at(10.5, 0.5))[2], 1, 1e-4);
  EXPECT_NEAR(map.radiance({1, 0, 0}).maxCoeff(), 0.25F, 1e-3) << "the corner between four texels";
  // A quarter turn counter-clockwise, seen from above: what was at +X is now at -Z.
  const EnvironmentMap turned(sky, static_cast<float>(pi / 2));
  EXPECT_NEAR(turned.radiance(at(32.5, 16.5))[1], 1, 1e-4);
}

TEST(EnvironmentMap, IsSampledByItsOwnDensity) {
  const EnvironmentMap map(test_sky(32), 0.7F);
  // 12 x 24 cells of equal solid angle, each with at least a few expected samples.
  constexpr int rows = 12, columns = 24, samples = 200000;
  std::vector<double> found(rows * columns), expected(rows * columns);
  const auto cell_of = [&](const Eigen::Vector3f& d) {
    const double azimuth = std::atan2(double{d.x()}, double{-d.z()}) / (2 * pi) + 0.5;
    const int column = std::clamp(static_cast<int>(azimuth * columns), 0, columns - 1);
    const int row = std::clamp(static_cast<int>((1 - double{d.y()}) / 2 * rows), 0, rows - 1);
    return row * columns + column;
  };
  for (int i = 0; i < samples; ++i) {
    const auto [direction, density_sr] = map.sample(Sampler(11, i, 0, 0).point(0));
    EXPECT_NEAR(direction.norm(), 1, 1e-5);
    ASSERT_NEAR(map.density_sr(direction) / density_sr, 1, 0.02) << "but for rounding at the edge of a texel";
    ++found[static_cast<std::size_t>(cell_of(direction))];
  }
  constexpr int fine = 40;
  double whole = 0;
  for (int row = 0; row < rows * fine; ++row)
    for (int column = 0; column < columns * fine; ++column) {
      const double y = 1 - 2 * (row + 0.5) / (rows * fine);
      const double azimuth = ((column + 0.5) / (columns * fine) - 0.5) * 2 * pi;
      const double flat = std::sqrt(1 - y * y);
      const Eigen::Vector3f d(static_cast<float>(std::sin(azimuth) * flat), static_cast<float>(y),
                              static_cast<float>(-std::cos(azimuth) * flat));
      const double share = double{map.density_sr(d)} * 4 * pi / (rows * columns * fine * fine);
      expected[static_cast<std::size_t>(cell_of(d))] += share * samples;
      whole += share;
    }
  EXPECT_NEAR(whole, 1, 5e-3);
  double chi_squared = 0;
  int cells = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (expected[i] < 10) continue;
    // The expectation is a sum over a grid, known to about 2 %: its own error is no evidence.
    const double variance = expected[i] + 0.0004 * expected[i] * expected[i];
    chi_squared += (found[i] - expected[i]) * (found[i] - expected[i]) / variance;
    ++cells;
  }
  ASSERT_GT(cells, 200);
  const boost::math::chi_squared distribution(cells - 1);
  EXPECT_GT(1 - boost::math::cdf(distribution, chi_squared), 1e-4) << chi_squared << " of " << cells;
}

TEST(EnvironmentMap, LightsAPlaneAsBruteForceDoesByEachStrategyAloneAndByBoth) {
  const EnvironmentMap map(test_sky(64), 0.3F);
  SurfacePoint point = floor_point(1.0F);
  point.normal = point.geometric_normal = Eigen::Vector3f(0.3F, 0.8F, -0.2F).normalized();
  const Rgb wanted = brute_force_irradiance(map, point.normal) * inverse_pi;
  Light light;
  light.environment = std::make_shared<EnvironmentMap>(map);
  const auto by_light = [&](const Sampler& sampler) {
    const auto [direction, density] = map.sample(sampler.point(5));
    const float cosine = std::max(0.0F, point.normal.dot(direction));
    return double{map.radiance(direction)[1] * cosine * inverse_pi / density};
  };
  const auto by_surface = [&](const Sampler& sampler) {
    return double{map.radiance(scatter(light, point, sampler.point(6))->direction)[1]};
  };
  const auto by_both = [&](const Sampler& sampler) {
    const auto sample = light_sample(light, 0, point, Rgb::Ones(), sampler, 0, EmissionHits::found);
    const auto next = scatter(light, point, sampler.point(6));
    return double{(sample ? sample->radiance[1] : 0.0F) + sky_found(light, point, next->direction)[1]};
  };
  std::vector<double> errors;
  for (const auto& strategy :
       {std::function<double(const Sampler&)>(by_light), std::function<double(const Sampler&)>(by_surface),
        std::function<double(const Sampler&)>(by_both)}) {
    const SampleMean found = sample_mean(40000, [&](int i) { return strategy(Sampler(2, i, 1, 0)); });
    EXPECT_NEAR(found.mean, wanted[1], 4 * found.standard_error + 2e-3 * wanted[1]);
    errors.push_back(found.standard_error);
  }
  EXPECT_LT(errors[2], 0.5 * errors[1]) << "a small sun in the map is what light samples are for";
}

TEST(EnvironmentMap, ConstantMapGivesWhatTheConstantEnvironmentGives) {
  const Geometry ball(std::vector{test::sphere({0, 0, -5}, 1.0F, 96, 0.4F)});
  Light light;
  light.environment = std::make_shared<EnvironmentMap>(Image(16, 8, 3, 2.5F), 0.0F);
  const auto hit = ball.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0.05F, 0.05F, -1).normalized()});
  const SampleMean found = sample_mean(20000, [&](int i) {
    return double{
        radiance_with_and_without(ball, nullptr, *hit, light, Sampler(7, i, 0, 0)).without_object.total()[1]};
  });
  EXPECT_NEAR(found.mean, 1.0, 4 * found.standard_error + 1e-3);
}

/// What a mirror sends on of a sun whose image stands at its middle: by light samples alone, or by them and
/// by the paths that go on.
SampleMean sun_in_a_mirror(Light light, float alpha, bool paths_look) {
  SurfacePoint mirror = floor_point(0.0F);
  mirror.f0 = Rgb::Constant(0.9F);
  mirror.alpha = alpha;
  mirror.to_viewer = Eigen::Vector3f(-0.6F, 0.8F, 0);
  light.suns[0].to_sun = Eigen::Vector3f(0.6F, 0.8F, 0);
  return sample_mean(100000, [&](int i) {
    const Sampler sampler(9, i, 0, 0);
    const auto sample = light_sample(light, 0, mirror, Rgb::Ones(), sampler, 0, EmissionHits::unknown,
                                     paths_look ? SunHits::found : SunHits::unknown);
    const auto next = scatter(light, mirror, sampler.point(dimension::direction(0)));
    const Rgb found =
        next && paths_look ? Rgb(next->weight * suns_found(light, mirror, next->direction)) : Rgb::Zero();
    return double{(sample ? sample->total()[1] : 0.0F) + found[1]};
  });
}

TEST(Suns, OfAnySizeAreInMirrorsWhatLightSamplesSayAndPathsCalmThem) {
  for (const double radius_deg : {0.0, 0.25, 3.0, 20.0})
    for (const float alpha : {0.01F, 0.06F, 0.25F}) {
      Light light;
      light.suns.push_back({.irradiance_w_m2 = Rgb::Constant(3),
                            .angular_radius_rad = static_cast<float>(radius_deg * pi / 180)});
      const SampleMean alone = sun_in_a_mirror(light, alpha, false),
                       both = sun_in_a_mirror(light, alpha, true);
      const double difference = std::hypot(alone.standard_error, both.standard_error);
      EXPECT_NEAR(both.mean, alone.mean, 4 * difference + 1e-4 * alone.mean) << radius_deg << " " << alpha;
      EXPECT_LE(both.standard_error, 1.2 * alone.standard_error) << radius_deg << " " << alpha;
      if (radius_deg == 0) {
        EXPECT_EQ(both.mean, alone.mean) << "nobody meets a point";
      }
      if (radius_deg >= 3 && alpha == 0.01F) {
        EXPECT_LT(both.standard_error, 0.5 * alone.standard_error) << radius_deg;
      }
    }
}

TEST(Suns, DiscsSendTheirIrradianceFromTheDirectionsTheyAreSampledBy) {
  const Eigen::Vector3f to_sun = Eigen::Vector3f(0.3F, 0.5F, -0.8F).normalized();
  for (const float radius_rad : {0.0046F, 0.05F, 0.7F}) {
    const Sun sun{.to_sun = to_sun, .irradiance_w_m2 = Rgb::Constant(3), .angular_radius_rad = radius_rad};
    const double solid_angle_sr = 2 * pi * (1 - std::cos(double{radius_rad}));
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3f direction = direction_to_sun(sun, 0.9999F * Sampler(4, i, 0, 0).point(0));
      EXPECT_NEAR(disc_radiance(sun, direction)[1] * solid_angle_sr / 3, 1, 1e-4);
    }
    const Eigen::Vector3f across = to_sun.unitOrthogonal();
    EXPECT_TRUE(
        disc_radiance(sun, std::cos(1.01F * radius_rad) * to_sun + std::sin(1.01F * radius_rad) * across)
            .isZero());
  }
  EXPECT_TRUE(disc_radiance({.to_sun = to_sun, .irradiance_w_m2 = Rgb::Ones()}, to_sun).isZero()) << "hard";
}

TEST(Lamps, ShineByTheInverseSquareAndTheCosine) {
  Light light;
  light.lamps.push_back({.position_m = Eigen::Vector3f(0.2F, 2, 0.7F), .intensity_w_sr = {5, 6, 7}});
  const auto sample =
      light_sample(light, 0, floor_point(), Rgb::Ones(), Sampler(1, 2, 3, 0), 0, EmissionHits::found);
  ASSERT_TRUE(sample);
  const double distance = std::sqrt(4 + 1), cosine = 2 / distance;
  EXPECT_NEAR(sample->radiance[1], 0.5 / pi * 6 * cosine / (distance * distance), 1e-5);
  EXPECT_LT(sample->far_m, distance);
  EXPECT_GT(sample->far_m, 0.999 * distance);
}

TEST(Lamps, SpotFadesBetweenItsCones) {
  Lamp spot{.intensity_w_sr = Rgb::Ones(),
            .is_spot = true,
            .axis = -Eigen::Vector3f::UnitY(),
            .inner_cosine = 0.9F,
            .outer_cosine = 0.7F};
  const auto at = [&](double cosine) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return double{intensity_towards(
        spot, Eigen::Vector3f(static_cast<float>(sine), static_cast<float>(-cosine), 0))[0]};
  };
  EXPECT_DOUBLE_EQ(at(1), 1);
  EXPECT_DOUBLE_EQ(at(0.95), 1);
  EXPECT_NEAR(at(0.8), 0.25, 1e-5);
  EXPECT_DOUBLE_EQ(at(0.65), 0);
  EXPECT_DOUBLE_EQ(at(-1), 0);
}

TEST(Lamps, SeveralGiveTheSumOfEach) {
  const SurfacePoint point = floor_point();
  for (const int count : {2, 16, 17, 60}) {
    std::vector<Lamp> lamps;
    for (int i = 0; i < count; ++i)
      lamps.push_back({.position_m = Eigen::Vector3f(std::sin(float(i)), 1 + 0.05F * i, std::cos(2.0F * i)),
                       .intensity_w_sr = {1.0F + i, 2, 0.1F * i}});
    double wanted = 0;
    Light light;
    for (const Lamp& lamp : lamps) {
      light.lamps = {lamp};
      const auto one =
          light_sample(light, 0, point, Rgb::Ones(), Sampler(1, 0, 0, 0), 0, EmissionHits::found);
      wanted += one ? double{one->radiance[0]} : 0;
    }
    light.lamps = lamps;
    const SampleMean found = sample_mean(20000, [&](int i) {
      const auto one =
          light_sample(light, 0, point, Rgb::Ones(), Sampler(5, i, 0, 0), 0, EmissionHits::found);
      return one ? double{one->radiance[0]} : 0.0;
    });
    EXPECT_NEAR(found.mean, wanted, 4 * found.standard_error + 1e-5 * wanted) << count;
  }
}

/// A floor under a emitting square, each of whose estimates may be asked for light samples or hits alone.
struct GlowingRoom {
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes;
  Light light;

  GlowingRoom() {
    meshes.push_back(test::floor(0, 4, 0.5F));
    auto square = std::make_shared<SurfaceMesh>();
    square->positions_m = {{-1, 1.5F, -1}, {1, 1.5F, -1}, {1, 1.5F, 1}, {-1, 1.5F, 1}};
    square->triangles = {{0, 1, 2}, {0, 2, 3}};
    square->albedo = Rgb::Zero();
    square->emission = Rgb(3, 2, 1);
    meshes.push_back(square);
    light.bounces = 0;
    light.emitters = std::make_shared<EmittingSurfaces>(meshes);
  }
};

TEST(EmittingSurfaces, LightAFloorAsTheFormFactorSays) {
  const GlowingRoom room;
  const Geometry geometry(room.meshes);
  SurfacePoint point = floor_point(1.0F);
  point.position_m = Eigen::Vector3f::Zero();
  // Form factor from a point to a parallel square over it, four corners of 1 x 1 at height 1.5 (Howell's
  // catalogue, B-3).
  const double x = 1 / 1.5, root = std::sqrt(1 + x * x);
  const double factor = 4 * (1 / (2 * pi)) * 2 * (x / root * std::atan(x / root));
  const double wanted = 3 * factor;  // albedo 1: irradiance / pi = emission * factor
  Light hits_only = room.light;
  hits_only.emitters.reset();
  std::vector<double> errors;
  for (const Light* light : {&room.light, const_cast<const Light*>(&hits_only)}) {
    const SampleMean found = sample_mean(30000, [&](int i) {
      return double{radiance_with_and_without(geometry, nullptr, point, *light, Sampler(3, i, 0, 0))
                        .without_object.total()[0]};
    });
    EXPECT_NEAR(found.mean, wanted, 4 * found.standard_error + 1e-4 * wanted);
    errors.push_back(found.standard_error);
  }
  EXPECT_LT(errors[0], errors[1]);
  const SampleMean light_alone = sample_mean(30000, [&](int i) {
    const auto sample =
        light_sample(room.light, 0, point, Rgb::Ones(), Sampler(4, i, 0, 0), 0, EmissionHits::unknown);
    return sample ? double{sample->radiance[0]} : 0.0;
  });
  EXPECT_NEAR(light_alone.mean, wanted, 4 * light_alone.standard_error + 1e-4 * wanted);
}

TEST(EmittingSurfaces, AreSampledByAreaAndLuminance) {
  GlowingRoom room;
  auto second = std::make_shared<SurfaceMesh>(*room.meshes[1]);
  for (Eigen::Vector3f& p : second->positions_m) p = 0.5F * p + Eigen::Vector3f(5, 0, 0);
  second->emission = Rgb::Constant(8.0F);
  room.meshes.push_back(second);
  const EmittingSurfaces emitters(room.meshes);
  EXPECT_EQ(emitters.triangles(), 4U);
  int in_second = 0;
  constexpr int samples = 40000;
  for (int i = 0; i < samples; ++i) {
    const Sampler sampler(9, i, 0, 0);
    const auto place = emitters.sample(sampler.point(0)[0], sampler.point(1));
    in_second += place.position_m.x() > 3 ? 1 : 0;
    EXPECT_GT(place.density_m2, 0);
  }
  const double first = 4 * (0.2126 * 3 + 0.7152 * 2 + 0.0722 * 1), other = 1 * 8.0;
  EXPECT_NEAR(in_second / double{samples}, other / (first + other), 0.01);
}

}  // namespace
}  // namespace seamline::renderer
