// Time of flight: its noise has the size and shape that shot noise of four samples gives, it mixes, it wraps.
#include "sensors/noise/time_of_flight.h"

#include <complex>

#include "tests/sensors/noise_samples.h"

namespace seamline::sensors {
namespace {

using namespace testing;

constexpr double light_m_s = 299792458, pi = std::numbers::pi;

TEST(TimeOfFlight, NoiseOfStrongLightIsNormalWithLangeAndSeitzSigma) {
  TimeOfFlightNoise model;
  model.wraps = false;
  const double albedo = 0.6, cosine = 0.8, distance_m = 1.3;
  const double amplitude = model.amplitude_at_1m_e * albedo * cosine / (distance_m * distance_m);
  const double variance = amplitude / model.contrast + model.background_e + model.readout_e * model.readout_e;
  const double sigma_m =
      light_m_s / (4 * pi * std::sqrt(2.0) * model.modulation_hz) * std::sqrt(variance) / amplitude;
  const SeenPixel seen = head_on(distance_m, albedo, cosine);
  EXPECT_NEAR(noise_sigma_m(model, seen, 1), sigma_m, 1e-12);
  for (const double scale : {1.0, 0.25})
    expect_normal(depths_of(measure_many(model, seen, scale)), distance_m, scale * sigma_m);
}

TEST(TimeOfFlight, SigmaIsWhatFourPoissonSamplesGive) {
  // The camera's own way: four samples, each a normal of the mean's variance, and the arctangent of their
  // differences.
  TimeOfFlightNoise model;
  model.wraps = false;
  model.readout_e = 0;
  const double distance_m = 2.1, amplitude = model.amplitude_at_1m_e * 0.5 / (distance_m * distance_m);
  const double offset = amplitude / model.contrast + model.background_e;
  const double phase = 4 * pi * model.modulation_hz * distance_m / light_m_s;
  Random random(5);
  std::vector<double> depths_m;
  for (int i = 0; i < 200000; ++i) {
    double sample[4] = {};
    for (int j = 0; j < 4; ++j) {
      const double mean = offset + amplitude * std::cos(phase - j * pi / 2);
      sample[j] = mean + std::sqrt(mean) * random.normal();
    }
    const double found = std::atan2(sample[1] - sample[3], sample[0] - sample[2]);
    depths_m.push_back(light_m_s / (4 * pi * model.modulation_hz) * (found < 0 ? found + 2 * pi : found));
  }
  const double sigma_m = noise_sigma_m(model, head_on(distance_m), 1);
  EXPECT_NEAR(moments(depths_m).sigma, sigma_m, 0.01 * sigma_m);
  EXPECT_NEAR(moments(depths_m).mean, distance_m, 0.02 * sigma_m);
}

/// Density of the phase of a constant of amplitude a plus complex normal noise of sigma 1 a component.
double phase_density(double phase, double a) {
  const double g = a * a / 2, c = std::cos(phase), s = std::sin(phase);
  return std::exp(-g) / (2 * pi) +
         std::sqrt(g / pi) * c * std::exp(-g * s * s) * normal_cdf(std::sqrt(2 * g) * c);
}

TEST(TimeOfFlight, PhaseOfDrowningLightHasItsExactDistributionRoundTheRange) {
  for (const double ratio : {1.0, 0.2}) {
    TimeOfFlightNoise model;
    model.weakest_amplitude_e = 0;
    model.readout_e = 0;
    model.contrast = 1;
    const double distance_m = 3, amplitude = 100;
    model.amplitude_at_1m_e = amplitude * 9 / 0.5;
    model.background_e = 2 * (amplitude / ratio) * (amplitude / ratio) - amplitude;
    const double range_m = light_m_s / (2 * model.modulation_hz);
    EXPECT_NEAR(ambiguity_range_m(model), range_m, 1e-12);
    const std::vector<double> depths_m = depths_of(measure_many(model, head_on(distance_m)));
    ASSERT_EQ(depths_m.size(), static_cast<std::size_t>(million));
    constexpr int bins = 64;
    std::vector<double> found(bins), expected(bins);
    for (const double depth_m : depths_m) {
      ASSERT_LE(depth_m, range_m);
      found[std::min<std::size_t>(bins - 1, static_cast<std::size_t>(depth_m / range_m * bins))] += 1;
    }
    constexpr int steps = 200;
    for (int i = 0; i < bins * steps; ++i)
      expected[static_cast<std::size_t>(i / steps)] +=
          million * phase_density(2 * pi * ((i + 0.5) / (bins * steps) - distance_m / range_m), ratio) *
          (2 * pi / (bins * steps));
    EXPECT_LT(chi_squared_ratio(found, expected), 1) << ratio;
  }
}

TEST(TimeOfFlight, AmplitudeFallsWithTheSquareOfTheDistanceAndCarriesTheNoisesPower) {
  TimeOfFlightNoise model;
  EXPECT_NEAR(amplitude_e(model, {.radial_m = 4, .albedo = 0.5, .cosine = 0.5}),
              amplitude_e(model, {.radial_m = 1, .albedo = 1, .cosine = 1}) / 64, 1e-9);
  const double distance_m = 5, amplitude = model.amplitude_at_1m_e * 0.5 / 25;
  const double variance = amplitude / model.contrast + model.background_e + model.readout_e * model.readout_e;
  double power = 0;
  for (const MeasuredPixel& pixel : measure_many(model, head_on(distance_m)))
    power += static_cast<double>(pixel.amplitude) * static_cast<double>(pixel.amplitude) / million;
  EXPECT_NEAR(power, amplitude * amplitude + variance, 4 * amplitude * std::sqrt(2 * variance) / 1000);
}

TEST(TimeOfFlight, ConfidenceFallsWithTheLightThatComesBack) {
  TimeOfFlightNoise model;
  double before = 1;
  for (const double distance_m : {0.5, 1.0, 2.0, 4.0, 7.0}) {
    double mean = 0;
    for (const MeasuredPixel& pixel : measure_many(model, head_on(distance_m), 1, 1000))
      mean += static_cast<double>(pixel.confidence) / 1000;
    EXPECT_LT(mean, before) << distance_m;
    EXPECT_GT(mean, 0);
    before = mean;
  }
}

TEST(TimeOfFlight, WrapsAtTheAmbiguityRangeUnlessSwitchedOff) {
  TimeOfFlightNoise model;
  model.modulation_hz = 30e6;  // 4.997 m
  const double range_m = light_m_s / (2 * 30e6);
  for (const double distance_m : {1.0, 6.0, 11.0}) {
    model.wraps = true;
    const MeasuredPixel wrapped = measure_pixel(model, head_on(distance_m, 1), NoiseStream({1, 1}, 1), 1e-9);
    EXPECT_NEAR(static_cast<double>(wrapped.depth_m), std::fmod(distance_m, range_m), 1e-6);
    model.wraps = false;
    const MeasuredPixel resolved = measure_pixel(model, head_on(distance_m, 1), NoiseStream({1, 1}, 1), 1e-9);
    EXPECT_NEAR(static_cast<double>(resolved.depth_m), distance_m, 1e-6);
  }
}

double mixed_depth_m(const TimeOfFlightNoise& model, const std::vector<SubRay>& rays) {
  SeenPixel seen{.centre = rays.front(), .planar_m = rays.front().radial_m, .sub_rays = rays};
  return static_cast<double>(measure_pixel(model, seen, NoiseStream({1, 1}, 1), 1e-12).depth_m);
}

TEST(TimeOfFlight, AFlyingPixelIsThePhaseOfTheSumOfItsSurfaces) {
  TimeOfFlightNoise model;
  const SubRay near{.radial_m = 1, .albedo = 0.4, .cosine = 0.9};
  const SubRay far{.radial_m = 2.5, .albedo = 0.8, .cosine = 0.7};
  double before = 0;
  for (int far_rays = 0; far_rays <= 16; ++far_rays) {
    std::vector<SubRay> rays(static_cast<std::size_t>(16 - far_rays), near);
    rays.insert(rays.end(), static_cast<std::size_t>(far_rays), far);
    std::complex<double> sum;
    for (const SubRay& ray : rays)
      sum += ray.albedo * ray.cosine / (ray.radial_m * ray.radial_m) *
             std::exp(std::complex<double>(0, 4 * pi * model.modulation_hz * ray.radial_m / light_m_s));
    const double found = mixed_depth_m(model, rays);
    EXPECT_NEAR(found, std::arg(sum) * light_m_s / (4 * pi * model.modulation_hz), 1e-6);
    EXPECT_GT(found, before);
    before = found;
  }
  EXPECT_NEAR(before, 2.5, 1e-6);
  model.mixes = false;
  EXPECT_NEAR(mixed_depth_m(model, {near, far, far, far}), 1, 1e-6);
}

TEST(TimeOfFlight, SurfacesHalfARangeApartThatAreEquallyBrightCancelToAHole) {
  TimeOfFlightNoise model;
  model.modulation_hz = 30e6;
  const double half_m = light_m_s / (4 * 30e6);
  const std::vector<SubRay> rays = {
      {.radial_m = 1, .albedo = 0.5 / ((1 + half_m) * (1 + half_m)), .cosine = 1},
      {.radial_m = 1 + half_m, .albedo = 0.5, .cosine = 1}};
  const SeenPixel seen{.centre = rays[0], .planar_m = 1, .sub_rays = rays};
  EXPECT_EQ(measure_pixel(model, seen, NoiseStream({1, 1}, 1), 1).state, PixelState::too_weak);
}

TEST(TimeOfFlight, WeakAndBlindingLightGiveHoles) {
  TimeOfFlightNoise model;
  model.full_well_e = 1e6;
  const auto state = [&](double distance_m, double albedo, double cosine) {
    return measure_pixel(model, head_on(distance_m, albedo, cosine), NoiseStream({2, 2}, 7), 1).state;
  };
  EXPECT_EQ(state(2, 0.5, 1), PixelState::measured);
  EXPECT_EQ(state(2, 0, 1), PixelState::too_weak);
  EXPECT_EQ(state(2, 0.5, 0), PixelState::too_weak);
  EXPECT_EQ(state(200, 0.5, 1), PixelState::too_weak);
  EXPECT_EQ(state(0.05, 0.5, 1), PixelState::saturated);
  EXPECT_EQ(state(std::numeric_limits<double>::infinity(), 0, 0), PixelState::nothing);
}

TEST(TimeOfFlight, OutliersHaveTheirShareAndAreUniformOverTheirRange) {
  TimeOfFlightNoise model;
  model.outliers = {.share = 0.01, .nearest_m = 0.5, .farthest_m = 6};
  for (const double scale : {1.0, 2.5}) {
    const auto pixels = measure_many(model, head_on(2), scale);
    const double share = 0.01 * scale;
    EXPECT_NEAR(share_of(pixels, PixelState::outlier), share, four_sigma_of_share(share, million));
    const auto uniform = [](double x) { return (x - 0.5) / 5.5; };
    EXPECT_LT(kolmogorov_ratio(depths_of(pixels, PixelState::outlier), uniform), 1);
  }
}

}  // namespace
}  // namespace seamline::sensors
