#include "renderer/realtime/median_cut.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::renderer {
namespace {

/// Columns and rows of a map; right and bottom are outside.
struct LightRegion {
  int left, top, right, bottom;

  [[nodiscard]] bool can_be_cut() const { return right - left > 1 || bottom - top > 1; }
};

/// Sums of luminous power over the map's upper left rectangles.
class PowerTable {
 public:
  explicit PowerTable(const EnvironmentMap& map)
      : width_(map.width_px()),
        sums_((static_cast<std::size_t>(map.width_px()) + 1) *
              (static_cast<std::size_t>(map.height_px()) + 1)) {
    for (int row = 0; row < map.height_px(); ++row) {
      double in_row = 0;
      for (int column = 0; column < map.width_px(); ++column) {
        const Rgb radiance = map.texel(column, row);
        in_row += (0.2126 * static_cast<double>(radiance[0]) + 0.7152 * static_cast<double>(radiance[1]) +
                   0.0722 * static_cast<double>(radiance[2])) *
                  texel_sr(map, row);
        sums_[place(column + 1, row + 1)] = sums_[place(column + 1, row)] + in_row;
      }
    }
  }

  [[nodiscard]] double of(const LightRegion& region) const {
    return sums_[place(region.right, region.bottom)] - sums_[place(region.left, region.bottom)] -
           sums_[place(region.right, region.top)] + sums_[place(region.left, region.top)];
  }

  [[nodiscard]] static double texel_sr(const EnvironmentMap& map, int row) {
    const double upper = std::cos(std::numbers::pi * row / map.height_px());
    const double lower = std::cos(std::numbers::pi * (row + 1) / map.height_px());
    return 2 * std::numbers::pi / map.width_px() * (upper - lower);
  }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row) * (static_cast<std::size_t>(width_) + 1) +
           static_cast<std::size_t>(column);
  }
  int width_;
  std::vector<double> sums_;
};

/// Cuts a region of more than one texel; `other` is the second part.
LightRegion cut(const EnvironmentMap& map, const PowerTable& power, LightRegion region, LightRegion& other) {
  const double middle_row = 0.5 * (region.top + region.bottom) / map.height_px() * std::numbers::pi;
  const double across = (region.right - region.left) * std::sin(middle_row);
  const bool by_columns = region.bottom - region.top < 2 ||
                          (region.right - region.left > 1 && across >= region.bottom - region.top);
  const auto parts = [&](int at) {
    LightRegion first = region, second = region;
    (by_columns ? first.right : first.bottom) = at;
    (by_columns ? second.left : second.top) = at;
    return std::pair(first, second);
  };
  const int from = by_columns ? region.left : region.top, to = by_columns ? region.right : region.bottom;
  const double half = 0.5 * power.of(region);
  // Power only grows with the cut: the first one past the half, or the one before it.
  int low = from + 1, high = to - 1;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (power.of(parts(middle).first) < half)
      low = middle + 1;
    else
      high = middle;
  }
  if (low - 1 > from && half - power.of(parts(low - 1).first) < power.of(parts(low).first) - half) --low;
  const auto [first, second] = parts(low);
  other = second;
  return first;
}

CutLight light_of(const EnvironmentMap& map, const LightRegion& region) {
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero(), even = Eigen::Vector3d::Zero();
  Eigen::Array3d irradiance = Eigen::Array3d::Zero();
  double solid_angle_sr = 0;
  for (int row = region.top; row < region.bottom; ++row) {
    const double texel_sr = PowerTable::texel_sr(map, row);
    for (int column = region.left; column < region.right; ++column) {
      const Eigen::Array3d light = map.texel(column, row).cast<double>() * texel_sr;
      const Eigen::Vector3d direction = map.direction_of(column + 0.5, row + 0.5);
      irradiance += light;
      weighted += direction * (0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]);
      even += direction * texel_sr;
      solid_angle_sr += texel_sr;
    }
  }
  Eigen::Vector3d to_light = weighted.norm() > 0 ? weighted : even;
  if (!(to_light.norm() > 1e-9 * (solid_angle_sr + weighted.norm())))  // the whole sphere has no middle
    to_light = map.direction_of(0.5 * (region.left + region.right), 0.5 * (region.top + region.bottom));
  return {to_light.normalized().cast<float>(), irradiance.cast<float>(), solid_angle_sr};
}

}  // namespace

std::vector<CutLight> median_cut(const EnvironmentMap& map, int count) {
  const PowerTable power(map);
  std::vector<LightRegion> regions = {{0, 0, map.width_px(), map.height_px()}};
  while (static_cast<int>(regions.size()) < count) {
    std::vector<LightRegion> parts;
    for (const LightRegion& region : regions) {
      if (!region.can_be_cut()) {
        parts.push_back(region);
        continue;
      }
      LightRegion second{};
      parts.push_back(cut(map, power, region, second));
      parts.push_back(second);
    }
    if (parts.size() == regions.size()) break;
    regions = std::move(parts);
  }
  std::vector<CutLight> lights;
  lights.reserve(regions.size());
  for (const LightRegion& region : regions) lights.push_back(light_of(map, region));
  return lights;
}

Light with_cut_environment(Light light, int count, bool soft) {
  const EnvironmentMap constant(Image(128, 64, 3, 1.0F), 0.0F, light.environment_radiance);
  for (const CutLight& cut : median_cut(light.environment ? *light.environment : constant, count)) {
    if (!(cut.irradiance_w_m2 > 0.0F).any()) continue;
    const double cosine = std::max(0.0, 1 - cut.solid_angle_sr / (2 * std::numbers::pi));
    light.suns.push_back({.to_sun = cut.to_light,
                          .irradiance_w_m2 = cut.irradiance_w_m2,
                          .angular_radius_rad = soft ? static_cast<float>(std::acos(cosine)) : 0.0F});
  }
  light.environment.reset();
  light.environment_radiance = Rgb::Zero();
  light.skips_sky = true;
  return light;
}

}  // namespace seamline::renderer
