#include "renderer/bounce_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace seamline {
namespace {

constexpr int levels = 2;
constexpr std::array<float, 5> kernel = {1.0F / 16, 4.0F / 16, 6.0F / 16, 4.0F / 16, 1.0F / 16};  // cubic B-spline
constexpr float depth_tolerance = 0.05F;  // relative

float likeness(const Guide& a, const Guide& b) {
  const float cosine = std::max(0.0F, a.normal.dot(b.normal));
  const float normal_weight = std::pow(cosine, 32.0F);
  const float depth_step = std::abs(a.distance_m - b.distance_m) / (depth_tolerance * std::max(a.distance_m, b.distance_m) + 1e-30F);
  return normal_weight * std::exp(-depth_step * depth_step);
}

}  // namespace

std::vector<Rgb> filtered_bounce(const std::vector<StimulusSums>& sums, const std::vector<Guide>& guides, int width_px,
                                 int height_px) {
  // Light and number of samples are filtered apart, so that pixels with few uncovered samples count for as much as they saw.
  struct Texel {
    Rgb light;
    float samples;
  };
  std::vector<Texel> from(sums.size()), to(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) from[i] = {sums[i].no.bounce, static_cast<float>(sums[i].rest)};
  for (int level = 0; level < levels; ++level, std::swap(from, to)) {
    const int step = 1 << level;
    for (int y = 0; y < height_px; ++y)
      for (int x = 0; x < width_px; ++x) {
        const std::size_t centre = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
        Texel sum{Rgb::Zero(), 0.0F};
        for (int dy = -2; dy <= 2; ++dy)
          for (int dx = -2; dx <= 2; ++dx) {
            const int column = x + dx * step, row = y + dy * step;
            if (column < 0 || row < 0 || column >= width_px || row >= height_px) continue;
            const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(column);
            const float weight = kernel[static_cast<std::size_t>(dx + 2)] * kernel[static_cast<std::size_t>(dy + 2)] *
                                 (i == centre ? 1.0F : likeness(guides[centre], guides[i]));
            sum.light += weight * from[i].light;
            sum.samples += weight * from[i].samples;
          }
        to[centre] = sum;
      }
  }
  std::vector<Rgb> mean(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) mean[i] = from[i].samples > 0 ? Rgb(from[i].light / from[i].samples) : Rgb::Zero();
  return mean;
}

}  // namespace seamline
