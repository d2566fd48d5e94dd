#include "raytracer/light/environment_map.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/arithmetic/bilinear.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

float luminance(const Rgb& radiance) {
  return 0.2126F * radiance[0] + 0.7152F * radiance[1] + 0.0722F * radiance[2];
}

/// How much light the texel and its neighbours send, by which it is chosen.
float weight_of(const Image& map, int column, int row) {
  float sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int y = std::clamp(row + dy, 0, map.height_px - 1);
      const int x = (column + dx + map.width_px) % map.width_px;
      sum += luminance(map.rgb(x, y));
    }
  return sum / 9;
}

/// The cell of cumulated weights that holds `value`, and how far into it, 0 to 1.
template <class Sums>
std::pair<int, double> find_cell(const Sums* sums, int cells, double value) {
  const auto* end = sums + cells + 1;
  const int cell = std::clamp(static_cast<int>(std::upper_bound(sums, end, value) - sums) - 1, 0, cells - 1);
  const double width = static_cast<double>(sums[cell + 1]) - static_cast<double>(sums[cell]);
  return {cell, width > 0 ? std::clamp((value - static_cast<double>(sums[cell])) / width, 0.0, 1.0) : 0.5};
}

}  // namespace

EnvironmentMap::EnvironmentMap(Image radiance, float rotation_rad, const Rgb& strength)
    : map_(std::move(radiance)), turn_(rotation_rad / (2 * std::numbers::pi_v<float>)) {
  const int width = map_.width_px, height = map_.height_px;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) map_.set_rgb(x, y, map_.rgb(x, y) * strength);
  row_sines_.resize(height + 1);
  for (int y = 0; y <= height; ++y) row_sines_[y] = std::cos(std::numbers::pi * y / height);
  rows_.assign(static_cast<std::size_t>(height) + 1, 0.0);
  in_row_.resize(static_cast<std::size_t>(height) * (static_cast<std::size_t>(width) + 1));
  Eigen::Array3d total = Eigen::Array3d::Zero();
  std::vector<double> sums(static_cast<std::size_t>(width) + 1);
  for (int y = 0; y < height; ++y) {
    const auto row = static_cast<std::size_t>(y);
    const double texel_sr = 2 * std::numbers::pi / width * (row_sines_[row] - row_sines_[row + 1]);
    for (int x = 0; x < width; ++x) {
      const auto column = static_cast<std::size_t>(x);
      total += map_.rgb(x, y).cast<double>() * texel_sr;
      sums[column + 1] = sums[column] + static_cast<double>(weight_of(map_, x, y));
    }
    rows_[row + 1] = rows_[row] + sums.back() * texel_sr;
    float* to = &in_row_[row * sums.size()];
    for (std::size_t i = 0; i < sums.size(); ++i)
      to[i] = sums.back() > 0 ? static_cast<float>(sums[i] / sums.back())
                              : static_cast<float>(i) / static_cast<float>(width);
  }
  total_w_m2_ = total.cast<float>();
}

/// Where a direction meets the map, in texels from its left upper corner.
Eigen::Array2f EnvironmentMap::place(const Eigen::Vector3f& direction) const {
  constexpr float pi = std::numbers::pi_v<float>;
  const float azimuth = std::atan2(direction.x(), -direction.z()) / (2 * pi) + turn_ + 0.5F;
  const float column = (azimuth - std::floor(azimuth)) * static_cast<float>(map_.width_px);
  const float row =
      std::acos(std::clamp(direction.y(), -1.0F, 1.0F)) / pi * static_cast<float>(map_.height_px);
  return {column, row};
}

Eigen::Vector3d EnvironmentMap::direction_of(double column, double row) const {
  const double azimuth = (column / map_.width_px - static_cast<double>(turn_) - 0.5) * 2 * std::numbers::pi;
  const double polar = row / map_.height_px * std::numbers::pi;
  return {std::sin(azimuth) * std::sin(polar), std::cos(polar), -std::cos(azimuth) * std::sin(polar)};
}

Rgb EnvironmentMap::radiance(const Eigen::Vector3f& direction) const {
  const Eigen::Array2f at = place(direction) - 0.5F;
  return bilinear(between_cells(at[0], at[1]), [&](int column, int row) {
    return map_.rgb((column + map_.width_px) % map_.width_px, std::clamp(row, 0, map_.height_px - 1));
  });
}

float EnvironmentMap::density_of_texel(int column, int row) const {
  const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
  if (!(rows_.back() > 0)) return 0.0F;
  const float* in_row = &in_row_[r * (static_cast<std::size_t>(map_.width_px) + 1)];
  const double texel_sr = 2 * std::numbers::pi / map_.width_px * (row_sines_[r] - row_sines_[r + 1]);
  const double share =
      (rows_[r + 1] - rows_[r]) / rows_.back() * static_cast<double>(in_row[c + 1] - in_row[c]);
  return static_cast<float>(share / texel_sr);
}

float EnvironmentMap::density_sr(const Eigen::Vector3f& direction) const {
  const Eigen::Array2f at = place(direction);
  return density_of_texel(std::clamp(static_cast<int>(at[0]), 0, map_.width_px - 1),
                          std::clamp(static_cast<int>(at[1]), 0, map_.height_px - 1));
}

EnvironmentMap::Direction EnvironmentMap::sample(const Eigen::Array2f& point) const {
  if (!(rows_.back() > 0)) return {Eigen::Vector3f::UnitY(), 0.0F};
  const auto [row, down] =
      find_cell(rows_.data(), map_.height_px, static_cast<double>(point[1]) * rows_.back());
  const auto r = static_cast<std::size_t>(row);
  const float* in_row = &in_row_[r * (static_cast<std::size_t>(map_.width_px) + 1)];
  const auto [column, along] = find_cell(in_row, map_.width_px, static_cast<double>(point[0]));
  // Within a texel evenly by solid angle: y is even in it.
  const double y = row_sines_[r] + down * (row_sines_[r + 1] - row_sines_[r]);
  const double flat = std::sqrt(std::max(0.0, 1 - y * y));
  const double azimuth =
      ((column + along) / map_.width_px - static_cast<double>(turn_) - 0.5) * 2 * std::numbers::pi;
  return {Eigen::Vector3d(std::sin(azimuth) * flat, y, -std::cos(azimuth) * flat).cast<float>(),
          density_of_texel(column, row)};
}

Image read_environment_map(const std::filesystem::path& path) {
  constexpr int widest_px = 16384;
  const auto refuse = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = path.string(), .wanted = wanted, .found = found});
  };
  const auto size = [](const ImageHeader& header) {
    return std::to_string(header.width_px) + " x " + std::to_string(header.height_px);
  };
  Image image = read_image(path, [&](const ImageHeader& header) {
    if (!header.floating_point)
      throw refuse("an environment map of radiance (.exr or .hdr)",
                   "a picture of whole numbers, whose curve to radiance is not stated");
    if (header.channels < 3)
      throw refuse("an environment map of three channels", std::to_string(header.channels));
    if (header.width_px != 2 * header.height_px || header.height_px < 2)
      throw refuse("an equirectangular map, twice as wide as high", size(header));
    if (header.width_px > widest_px)
      throw refuse(fmt::format("an environment map of at most {} texels a row", widest_px), size(header));
  });
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x)
      for (int channel = 0; channel < 3; ++channel)
        if (const float value = image.at(x, y, channel);
            !(value >= 0 && value <= static_cast<float>(limits::strongest_light)))
          throw refuse(fmt::format("radiance from 0 to {:g} W/m2/sr", limits::strongest_light),
                       fmt::format("{:g} in texel ({}, {})", value, x, y));
  return image;
}

}  // namespace seamline::renderer
