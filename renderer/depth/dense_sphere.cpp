#include "renderer/depth/dense_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

/// Where one coordinate of a vertex falls between two texels.
struct BetweenTexels {
  int first = 0, second = 0;
  double weight = 0;  ///< of the second
  [[nodiscard]] int nearest() const { return weight < 0.5 ? first : second; }
};

/// Vertex i of `dense` lies at (i + 0.5) / dense of an axis with `texels` texels; its two texels are not yet
/// brought into range.
BetweenTexels between_texels(int i, int dense, int texels) {
  const double at = (i + 0.5) * texels / dense - 0.5;
  const double floor = std::floor(at);
  return {static_cast<int>(floor), static_cast<int>(floor) + 1, at - floor};
}

float interpolate(const DepthMap& map, const BetweenTexels& column, const BetweenTexels& row) {
  if (is_hole(map.at(column.nearest(), row.nearest()))) return std::numeric_limits<float>::infinity();
  double sum = 0, weights = 0;
  const auto add = [&](int c, int r, double weight) {
    const float distance_m = map.at(c, r);
    if (is_hole(distance_m)) return;
    sum += weight * static_cast<double>(distance_m);
    weights += weight;
  };
  add(column.first, row.first, (1 - column.weight) * (1 - row.weight));
  add(column.second, row.first, column.weight * (1 - row.weight));
  add(column.first, row.second, (1 - column.weight) * row.weight);
  add(column.second, row.second, column.weight * row.weight);
  return static_cast<float>(sum / weights);  // the nearest texel alone weighs a quarter
}

void resample(DenseSphere& sphere, const DepthMap& map, int threads) {
  std::vector<BetweenTexels> columns(static_cast<std::size_t>(sphere.width));
  for (int c = 0; c < sphere.width; ++c) {
    BetweenTexels& column = columns[c];
    column = between_texels(c, sphere.width, map.width_px);
    column.first = (column.first + map.width_px) % map.width_px;
    column.second %= map.width_px;
  }
  sphere.resampled_m.resize(static_cast<std::size_t>(sphere.width) * static_cast<std::size_t>(sphere.height));
  run_parallel(sphere.height, threads, [&](int r) {
    BetweenTexels row = between_texels(r, sphere.height, map.height_px);
    row.first = std::clamp(row.first, 0, map.height_px - 1);
    row.second = std::clamp(row.second, 0, map.height_px - 1);
    float* out = &sphere.resampled_m[static_cast<std::size_t>(r) * static_cast<std::size_t>(sphere.width)];
    for (const BetweenTexels& column : columns) *out++ = interpolate(map, column, row);
  });
  sphere.distance_m = sphere.resampled_m;
}

/// One direction table: the angle's sine and cosine at (i + phase) / count of a turn or half turn.
void fill_angles(std::vector<double>& sines, std::vector<double>& cosines, int count, auto angle_rad) {
  sines.resize(count);
  cosines.resize(count);
  for (int i = 0; i < count; ++i) {
    sines[i] = std::sin(angle_rad(i));
    cosines[i] = std::cos(angle_rad(i));
  }
}

float mean_of_valid(std::span<const float> row) {
  double sum = 0;
  int count = 0;
  for (const float distance_m : row)
    if (!is_hole(distance_m)) sum += static_cast<double>(distance_m), ++count;
  return count > 0 ? static_cast<float>(sum / count) : std::numeric_limits<float>::infinity();
}

}  // namespace

DenseSphere make_dense_sphere(const DepthMap& map, double yaw_texels, int threads, int smallest_width) {
  DenseSphere sphere;
  sphere.width = std::max(map.width_px, smallest_width);
  sphere.height = sphere.width / 2;
  const double yaw_turns = std::fmod(yaw_texels, map.width_px) / map.width_px;
  fill_angles(sphere.sin_azimuth, sphere.cos_azimuth, sphere.width, [&](int column) {
    return ((column + 0.5) / sphere.width - 0.5 + yaw_turns) * 2 * std::numbers::pi;
  });
  fill_angles(sphere.sin_elevation, sphere.cos_elevation, sphere.height,
              [&](int row) { return (0.5 - (row + 0.5) / sphere.height) * std::numbers::pi; });
  if (map.width_px == sphere.width)
    sphere.distance_m = map.distance_m;  // every vertex hits its texel: nothing to copy
  else
    resample(sphere, map, threads);
  sphere.zenith_m = mean_of_valid(sphere.distance_m.first(static_cast<std::size_t>(sphere.width)));
  sphere.nadir_m = mean_of_valid(sphere.distance_m.last(static_cast<std::size_t>(sphere.width)));
  return sphere;
}

}  // namespace seamline::renderer
