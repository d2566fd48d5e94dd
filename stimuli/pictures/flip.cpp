#include "stimuli/pictures/flip.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "stimuli/pictures/flip_colour.h"
#include "stimuli/pictures/flip_filters.h"

namespace seamline::inline stimuli {
namespace {

constexpr double feature_power = 0.5;  // q_f

std::array<double, 256> linear_of_code() {
  std::array<double, 256> linear;
  for (std::size_t code = 0; code < linear.size(); ++code)
    linear[code] = double{linear_from_srgb(static_cast<float>(code) / 255.0F)};
  return linear;
}

/// The three opponent channels Y, Cx, Cz, each a picture; `rgb_at` gives the linear colour of a pixel.
template <typename RgbAt>
std::array<Image, 3> opponent_channels(int width_px, int height_px, const RgbAt& rgb_at) {
  std::array<Image, 3> channels;
  for (Image& channel : channels) channel = Image(width_px, height_px, 1);
  for (std::size_t pixel = 0; pixel < channels[0].values.size(); ++pixel) {
    const Eigen::Array3d ycxcz = ycxcz_from_linear(rgb_at(pixel));
    for (std::size_t channel = 0; channel < 3; ++channel)
      channels[channel].values[pixel] = static_cast<float>(ycxcz[static_cast<Eigen::Index>(channel)]);
  }
  return channels;
}

std::array<Image, 3> opponent_channels(const ByteImage& srgb) {
  static const std::array<double, 256> linear = linear_of_code();
  const std::size_t step = static_cast<std::size_t>(srgb.channels);
  const bool grey = step == 1;
  return opponent_channels(srgb.width_px, srgb.height_px, [&](std::size_t pixel) -> Eigen::Array3d {
    const std::uint8_t* code = &srgb.values[pixel * step];
    return {linear[code[0]], linear[code[grey ? 0 : 1]], linear[code[grey ? 0 : 2]]};
  });
}

std::array<Image, 3> opponent_channels(const Image& linear) {
  const std::size_t step = static_cast<std::size_t>(linear.channels);
  const bool grey = step == 1;
  return opponent_channels(linear.width_px, linear.height_px, [&](std::size_t pixel) -> Eigen::Array3d {
    const float* value = &linear.values[pixel * step];
    return {double{value[0]}, double{value[grey ? 0 : 1]}, double{value[grey ? 0 : 2]}};
  });
}

/// One channel as it is seen, after its contrast sensitivity.
Image seen(const Image& channel, const std::vector<WeightedFilter>& filters) {
  Image result(channel.width_px, channel.height_px, 1);
  for (const WeightedFilter& part : filters) {
    const Image smooth = filtered(channel, part.filter);
    for (std::size_t i = 0; i < result.values.size(); ++i)
      result.values[i] += static_cast<float>(part.weight) * smooth.values[i];
  }
  return result;
}

Image seen_lab(const std::array<Image, 3>& channels, double ppd) {
  const std::vector<std::vector<WeightedFilter>> filters = sensitivity_filters(ppd);
  const std::array<Image, 3> smooth = {seen(channels[0], filters[0]), seen(channels[1], filters[1]),
                                       seen(channels[2], filters[2])};
  Image lab(channels[0].width_px, channels[0].height_px, 3);
  for (std::size_t pixel = 0; pixel < smooth[0].values.size(); ++pixel) {
    const Eigen::Array3d ycxcz{double{smooth[0].values[pixel]}, double{smooth[1].values[pixel]},
                               double{smooth[2].values[pixel]}};
    const Eigen::Array3d rgb = linear_from_ycxcz(ycxcz).max(0.0).min(1.0);
    const Eigen::Array3d colour = hunt_adjusted(lab_from_linear(rgb));
    for (std::size_t channel = 0; channel < 3; ++channel)
      lab.values[3 * pixel + channel] = static_cast<float>(colour[static_cast<Eigen::Index>(channel)]);
  }
  return lab;
}

Image features_of(Image lightness, double ppd) {
  for (float& value : lightness.values) value = (value + 16.0F) / 116.0F;
  const FeatureFilters filters = feature_filters(ppd);
  const Image edge_x = filtered(lightness, filters.edge_x), edge_y = filtered(lightness, filters.edge_y);
  const Image point_x = filtered(lightness, filters.point_x), point_y = filtered(lightness, filters.point_y);
  Image features(lightness.width_px, lightness.height_px, 2);
  for (std::size_t i = 0; i < lightness.values.size(); ++i) {
    features.values[2 * i] = std::hypot(edge_x.values[i], edge_y.values[i]);
    features.values[2 * i + 1] = std::hypot(point_x.values[i], point_y.values[i]);
  }
  return features;
}

Eigen::Array3d colour_at(const Image& lab, std::size_t pixel) {
  const float* value = &lab.values[3 * pixel];
  return {double{value[0]}, double{value[1]}, double{value[2]}};
}

/// (max(|d edges|, |d points|) / sqrt 2)^q_f, section 4.2, Eq. 11.
double feature_difference(const Image& reference, const Image& test, std::size_t pixel) {
  const float* a = &reference.values[2 * pixel];
  const float* b = &test.values[2 * pixel];
  const double most = std::max(std::abs(double{a[0]} - double{b[0]}), std::abs(double{a[1]} - double{b[1]}));
  return std::pow(most / std::numbers::sqrt2, feature_power);
}

FlipPicture flip_picture_of(std::array<Image, 3> channels, double pixels_per_degree) {
  return {.lab = seen_lab(channels, pixels_per_degree),
          .features = features_of(std::move(channels[0]), pixels_per_degree)};
}

}  // namespace

FlipPicture flip_picture(const ByteImage& srgb, double pixels_per_degree) {
  assert(pixels_per_degree > 0 && (srgb.channels == 1 || srgb.channels == 3));
  return flip_picture_of(opponent_channels(srgb), pixels_per_degree);
}

FlipPicture flip_picture_of_linear(const Image& linear, double pixels_per_degree) {
  assert(pixels_per_degree > 0 && (linear.channels == 1 || linear.channels == 3));
  return flip_picture_of(opponent_channels(linear), pixels_per_degree);
}

Image flip_difference(const FlipPicture& reference, const FlipPicture& test) {
  assert(reference.lab.width_px == test.lab.width_px && reference.lab.height_px == test.lab.height_px);
  Image flip(reference.lab.width_px, reference.lab.height_px, 1);
  for (std::size_t pixel = 0; pixel < flip.values.size(); ++pixel) {
    const double colour = colour_difference_of_distance(
        hyab_distance(colour_at(reference.lab, pixel), colour_at(test.lab, pixel)));
    if (colour == 0) continue;  // also where a feature differs: 0^(1 - f)
    flip.values[pixel] = static_cast<float>(
        std::pow(colour, 1 - feature_difference(reference.features, test.features, pixel)));
  }
  return flip;
}

Image flip_difference(const ByteImage& reference, const ByteImage& test, double pixels_per_degree) {
  return flip_difference(flip_picture(reference, pixels_per_degree), flip_picture(test, pixels_per_degree));
}

double screen_pixels_per_degree(double distance_m, int screen_width_px, double screen_width_m) {
  return distance_m * screen_width_px / screen_width_m * std::numbers::pi / 180;
}

}  // namespace seamline::inline stimuli
