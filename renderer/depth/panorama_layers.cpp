#include "renderer/depth/panorama_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/panorama_chain.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

constexpr float hole_m = std::numeric_limits<float>::infinity();
constexpr float least_ratio = 1.1F, least_bend = 0.1F;
constexpr double cut_ratio = 1.1;
constexpr int narrowest_finer_px = 2048;

/// A map with columns that wrap around and rows that end at the poles.
float at(const DepthMap& map, int column, int row) {
  return map.at((column % map.width_px + map.width_px) % map.width_px, std::clamp(row, 0, map.height_px - 1));
}

/// From a texel to one of its eight neighbours; diagonals by way of either side.
bool jumps_straight(const DepthMap& map, int column, int row, int dx, int dy) {
  return is_segment_border(at(map, column - dx, row - dy), at(map, column, row),
                           at(map, column + dx, row + dy), at(map, column + 2 * dx, row + 2 * dy));
}
bool jumps(const DepthMap& map, int column, int row, int dx, int dy) {
  if (dx == 0 || dy == 0) return jumps_straight(map, column, row, dx, dy);
  const bool by_column =
      jumps_straight(map, column, row, dx, 0) || jumps_straight(map, column + dx, row, 0, dy);
  const bool by_row = jumps_straight(map, column, row, 0, dy) || jumps_straight(map, column, row + dy, dx, 0);
  return by_column && by_row;
}

std::size_t index(const DepthMap& map, int column, int row) {
  return grid_index(row, (column % map.width_px + map.width_px) % map.width_px, map.width_px);
}

/// Linear between the texels around a place that belong to the one it lies in.
float segment_distance(const DepthMap& map, double column, double row) {
  const int nearest_column = static_cast<int>(std::floor(column + 0.5)),
            nearest_row = std::clamp(static_cast<int>(std::floor(row + 0.5)), 0, map.height_px - 1);
  const float own_m = at(map, nearest_column, nearest_row);
  if (is_hole(own_m)) return hole_m;
  const int dx = column >= nearest_column ? 1 : -1, dy = row >= nearest_row ? 1 : -1;
  const double u = std::abs(column - nearest_column), v = std::clamp(std::abs(row - nearest_row), 0.0, 0.5);
  double sum = (1 - u) * (1 - v) * static_cast<double>(own_m), weights = (1 - u) * (1 - v);
  const auto add = [&](int right, int down, double weight) {
    const float distance_m = at(map, nearest_column + right, nearest_row + down);
    if (weight <= 0 || is_hole(distance_m) || jumps(map, nearest_column, nearest_row, right, down)) return;
    sum += weight * static_cast<double>(distance_m);
    weights += weight;
  };
  add(dx, 0, u * (1 - v));
  add(0, dy, (1 - u) * v);
  add(dx, dy, u * v);
  return static_cast<float>(sum / weights);
}

/// Of every texel on the near side of a jump, and of those beside it on the same side up to the reach: the
/// nearest distance that something behind it jumps to; a hole elsewhere.
std::vector<float> far_sides_m(const DepthMap& map, int reach_texels) {
  std::vector<float> far_m(map.distance_m.size(), hole_m);
  constexpr std::array<std::array<int, 2>, 4> sides = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < map.width_px; ++column)
      for (const auto& [dx, dy] : sides) {
        const float near_m = at(map, column, row), behind_m = at(map, column + dx, row + dy);
        if (row + dy < 0 || row + dy >= map.height_px || is_hole(near_m)) continue;
        if (near_m < behind_m && (is_hole(behind_m) || jumps(map, column, row, dx, dy)))
          far_m[index(map, column, row)] = std::min(far_m[index(map, column, row)], behind_m);
      }
  for (int step = 1; step < reach_texels; ++step) {
    std::vector<float> wider = far_m;
    for (int row = 0; row < map.height_px; ++row)
      for (int column = 0; column < map.width_px; ++column)
        for (const auto& [dx, dy] : sides) {
          if (row + dy < 0 || row + dy >= map.height_px) continue;
          const float from_m = far_m[index(map, column + dx, row + dy)];
          const std::size_t i = index(map, column, row);
          if (is_hole(from_m) || !(map.distance_m[i] * least_ratio < from_m) ||
              jumps(map, column, row, dx, dy))
            continue;
          wider[i] = std::min(wider[i], from_m);
        }
    far_m = std::move(wider);
  }
  return far_m;
}

/// What lies behind near sides, with the texels beside it that it joins; holes elsewhere.
DepthMap second_layer(const Geometry& truth, const DepthMap& map, double yaw_texels, int reach_texels,
                      int threads) {
  const std::vector<float> far_m = far_sides_m(map, reach_texels);
  DepthMap behind{.width_px = map.width_px, .height_px = map.height_px, .distance_m = {}};
  behind.distance_m.assign(map.distance_m.size(), hole_m);
  run_parallel(map.height_px, threads, [&](int row) {
    for (int column = 0; column < map.width_px; ++column) {
      const std::size_t i = index(map, column, row);
      if (is_hole(far_m[i])) continue;
      const Eigen::Vector3f along =
          panorama_direction(column + yaw_texels + 0.5, row + 0.5, map.width_px, map.height_px).cast<float>();
      const float start_m = far_m[i] / least_ratio;
      const auto hit = truth.nearest({along * start_m, along});
      if (hit) behind.distance_m[i] = start_m + hit->distance_m;
    }
  });
  DepthMap joined = behind;
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < map.width_px; ++column) {
      const std::size_t i = index(map, column, row);
      if (!is_hole(behind.distance_m[i])) continue;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (row + dy < 0 || row + dy >= map.height_px) continue;
          const std::size_t beside = index(map, column + dx, row + dy);
          if (!is_hole(behind.distance_m[beside]) && map.distance_m[i] * least_ratio >= far_m[beside])
            joined.distance_m[i] = map.distance_m[i];
        }
    }
  return joined;
}

}  // namespace

bool is_segment_border(float before_m, float first_m, float second_m, float behind_m) {
  if (is_hole(first_m) || is_hole(second_m)) return is_hole(first_m) != is_hole(second_m);
  if (std::max(first_m, second_m) <= least_ratio * std::min(first_m, second_m)) return false;
  const auto inverse = [](float distance_m) { return is_hole(distance_m) ? 0.0F : 1.0F / distance_m; };
  const float first = inverse(first_m), second = inverse(second_m);
  const float bend = least_bend * std::max(first, second);
  return std::abs(second - (2 * first - inverse(before_m))) > bend &&
         std::abs(first - (2 * second - inverse(behind_m))) > bend;
}

DepthMap segmented(const DepthMap& map, int finer_width_px, int threads) {
  DepthMap finer{.width_px = finer_width_px, .height_px = finer_width_px / 2, .distance_m = {}};
  finer.distance_m.resize(static_cast<std::size_t>(finer.width_px) *
                          static_cast<std::size_t>(finer.height_px));
  const double texels = static_cast<double>(map.width_px) / finer_width_px;
  run_parallel(finer.height_px, threads, [&](int row) {
    for (int column = 0; column < finer.width_px; ++column)
      finer.distance_m[index(finer, column, row)] =
          segment_distance(map, (column + 0.5) * texels - 0.5, (row + 0.5) * texels - 0.5);
  });
  return finer;
}

DepthMesh layered_mesh(const Geometry& truth, const DepthMap& map, const MeshOptions& options,
                       int reach_texels) {
  const int finer_width_px = std::max(map.width_px, narrowest_finer_px);
  MeshOptions finer_options = options;
  finer_options.yaw_texels = options.yaw_texels * finer_width_px / map.width_px;
  const auto mesh_of = [&](const DepthMap& layer) {
    if (std::all_of(layer.distance_m.begin(), layer.distance_m.end(), is_hole)) return DepthMesh{};
    const DepthMap finer = segmented(layer, finer_width_px, options.threads);
    return without_jumps(build_depth_mesh(finer, finer_options), finer, finer_options.yaw_texels, cut_ratio);
  };
  DepthMesh mesh = mesh_of(map);
  append(mesh, mesh_of(second_layer(truth, map, options.yaw_texels, reach_texels, options.threads)));
  return mesh;
}

}  // namespace seamline::renderer
