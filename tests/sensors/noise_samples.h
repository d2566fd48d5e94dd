// A million measurements of one pixel.
#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "sensors/noise/measurement.h"
#include "tests/sensors/distributions.h"

namespace seamline::sensors::testing {

inline constexpr int million = 1'000'000;

inline SeenPixel head_on(double distance_m, double albedo = 0.5, double cosine = 1) {
  return {.centre = {.radial_m = distance_m, .albedo = albedo, .cosine = cosine}, .planar_m = distance_m};
}

/// What `count` pixels of one frame measure that all see the same.
template <class Model>
std::vector<MeasuredPixel> measure_many(const Model& model, const SeenPixel& seen, double scale = 1,
                                        int count = million, const NoiseKey& key = {11, 3}) {
  std::vector<MeasuredPixel> pixels;
  pixels.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    pixels.push_back(measure_pixel(model, seen, NoiseStream(key, static_cast<std::uint64_t>(i)), scale));
  return pixels;
}

inline std::vector<double> depths_of(const std::vector<MeasuredPixel>& pixels,
                                     PixelState state = PixelState::measured) {
  std::vector<double> depths_m;
  for (const MeasuredPixel& pixel : pixels)
    if (pixel.state == state) depths_m.push_back(static_cast<double>(pixel.depth_m));
  return depths_m;
}

inline double share_of(const std::vector<MeasuredPixel>& pixels, PixelState state) {
  return static_cast<double>(depths_of(pixels, state).size()) / static_cast<double>(pixels.size());
}

/// Four standard deviations of a share that was counted.
inline double four_sigma_of_share(double share, double count) {
  return 4 * std::sqrt(share * (1 - share) / count);
}

/// Expects a normal distribution of this mean and sigma, in mean, sigma and shape.
inline void expect_normal(const std::vector<double>& samples, double mean, double sigma) {
  const double n = static_cast<double>(samples.size());
  const Moments found = moments(samples);
  EXPECT_NEAR(found.mean, mean, 4 * sigma / std::sqrt(n));
  EXPECT_NEAR(found.sigma, sigma, 4 * sigma / std::sqrt(2 * n));
  EXPECT_LT(kolmogorov_ratio(samples, [&](double x) { return normal_cdf((x - mean) / sigma); }), 1);
}

}  // namespace seamline::sensors::testing
