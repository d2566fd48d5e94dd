#include "stimuli/pictures/flip_filters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace seamline::inline stimuli {
namespace {

constexpr double pi = std::numbers::pi;

/// f(x) at the whole numbers from -radius to radius.
std::vector<double> sampled(int radius, const std::function<double(int x)>& f) {
  std::vector<double> values;
  for (int x = -radius; x <= radius; ++x) values.push_back(f(x));
  return values;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Positive values add up to 1 and negative ones to -1.
std::vector<double> with_unit_lobes(std::vector<double> values) {
  double positive = 0, negative = 0;
  for (const double value : values) (value > 0 ? positive : negative) += std::abs(value);
  for (double& value : values)
    if (value != 0) value /= value > 0 ? positive : negative;
  return values;
}

/// a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees: the transform of a exp(-b f^2).
struct SensitivityTerm {
  double a, b;
};
constexpr double widest_b = 0.04;

std::vector<WeightedFilter> sensitivity_filter(const std::vector<SensitivityTerm>& terms, double ppd) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest_b / (2 * pi * pi)) * ppd));
  std::vector<WeightedFilter> filters;
  double total = 0;
  for (const SensitivityTerm& term : terms) {
    std::vector<double> line =
        sampled(radius, [&](int x) { return std::exp(-pi * pi * (x / ppd) * (x / ppd) / term.b); });
    const double line_sum = sum(line);
    for (double& value : line) value /= line_sum;
    const double weight = term.a * std::sqrt(pi / term.b) * line_sum * line_sum;
    total += weight;
    filters.push_back({.weight = weight, .filter = {.along_x = line, .along_y = line}});
  }
  for (WeightedFilter& filter : filters) filter.weight /= total;
  return filters;
}

std::size_t clamped(int at, int size) {
  return static_cast<std::size_t>(std::clamp(at, 0, size - 1));
}

}  // namespace

std::vector<std::vector<WeightedFilter>> sensitivity_filters(double pixels_per_degree) {
  return {sensitivity_filter({{1, 0.0047}}, pixels_per_degree),
          sensitivity_filter({{1, 0.0053}}, pixels_per_degree),
          sensitivity_filter({{34.1, widest_b}, {13.5, 0.025}}, pixels_per_degree)};
}

FeatureFilters feature_filters(double pixels_per_degree) {
  constexpr double feature_width_deg = 0.082;  // w
  const double sd_px = 0.5 * feature_width_deg * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sd_px));
  const auto gaussian = [&](int x) { return std::exp(-x * x / (2 * sd_px * sd_px)); };
  std::vector<double> smooth = sampled(radius, gaussian);
  const double smooth_sum = sum(smooth);
  for (double& value : smooth) value /= smooth_sum;
  const std::vector<double> edge = with_unit_lobes(sampled(radius, [&](int x) { return -x * gaussian(x); }));
  const std::vector<double> point =
      with_unit_lobes(sampled(radius, [&](int x) { return (x * x / (sd_px * sd_px) - 1) * gaussian(x); }));
  return {.edge_x = {edge, smooth},
          .edge_y = {smooth, edge},
          .point_x = {point, smooth},
          .point_y = {smooth, point}};
}

Image filtered(const Image& one_channel, const SeparableFilter& filter) {
  assert(one_channel.channels == 1);
  assert(filter.along_x.size() % 2 == 1 && filter.along_y.size() % 2 == 1);
  const int width = one_channel.width_px, height = one_channel.height_px;
  const std::size_t row = static_cast<std::size_t>(width);
  const int radius_x = static_cast<int>(filter.along_x.size() / 2);
  const int radius_y = static_cast<int>(filter.along_y.size() / 2);
  Image half(width, height, 1), whole(width, height, 1);
  std::vector<double> padded(row + filter.along_x.size() - 1), sums(row);
  for (int y = 0; y < height; ++y) {
    const float* source = &one_channel.values[static_cast<std::size_t>(y) * row];
    for (int x = 0; x < static_cast<int>(padded.size()); ++x)
      padded[x] = double{source[clamped(x - radius_x, width)]};
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t tap = 0; tap < filter.along_x.size(); ++tap)
      for (std::size_t x = 0; x < row; ++x) sums[x] += filter.along_x[tap] * padded[x + tap];
    for (std::size_t x = 0; x < row; ++x)
      half.values[static_cast<std::size_t>(y) * row + x] = static_cast<float>(sums[x]);
  }
  for (int y = 0; y < height; ++y) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t tap = 0; tap < filter.along_y.size(); ++tap) {
      const float* source = &half.values[clamped(y + static_cast<int>(tap) - radius_y, height) * row];
      for (std::size_t x = 0; x < row; ++x) sums[x] += filter.along_y[tap] * double{source[x]};
    }
    for (std::size_t x = 0; x < row; ++x)
      whole.values[static_cast<std::size_t>(y) * row + x] = static_cast<float>(sums[x]);
  }
  return whole;
}

}  // namespace seamline::inline stimuli
