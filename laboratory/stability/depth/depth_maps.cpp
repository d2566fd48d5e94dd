#include "laboratory/stability/depth/depth_maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/arithmetic/grid_index.h"
#include "support/text/numbers.h"

namespace seamline::stability {

DepthMap make_depth_map(int width_px, const std::function<double(int column, int row)>& distance_m) {
  DepthMap map{.width_px = width_px, .height_px = width_px / 2, .distance_m = {}};
  map.distance_m.reserve(width_px * static_cast<std::size_t>(map.height_px));
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < width_px; ++column)
      map.distance_m.push_back(static_cast<float>(distance_m(column, row)));
  return map;
}

DepthMap constant_map(int width_px, double distance_m) {
  return make_depth_map(width_px, [&](int, int) { return distance_m; });
}

double room_distance_m(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d low(-2.2, -1.5, -3.5), high(2.8, 1.5, 2.5);
  double distance_m = infinity;
  for (int axis = 0; axis < 3; ++axis)
    if (direction[axis] != 0)
      distance_m = std::min(distance_m, (direction[axis] > 0 ? high[axis] : low[axis]) / direction[axis]);
  return distance_m;
}

DepthMap room_map(int width_px) {
  return make_depth_map(width_px, [&](int column, int row) {
    return room_distance_m(panorama_direction(column + 0.5, row + 0.5, width_px, width_px / 2));
  });
}

DepthMap turned_map(const DepthMap& map, int texels) {
  return make_depth_map(map.width_px, [&](int column, int row) {
    return static_cast<double>(map.at((column + texels) % map.width_px, row));
  });
}

DepthMap random_depth_map(int width_px, const RandomMapKind& kind, Random& random) {
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const auto below = [&](int n) { return static_cast<int>(random.below(n)); };
  DepthMap map = random.uniform() < 0.5 ? room_map(width_px) : constant_map(width_px, 2);
  const double bump = random.uniform() < 0.5 ? 0 : std::pow(10, between(-5, -1)), waves = between(1, 8);
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < width_px; ++column)
      map.distance_m[grid_index(row, column, width_px)] *=
          static_cast<float>(1 + bump * std::sin(waves * row) * std::cos(waves * column));
  for (int patch = below(5); patch > 0; --patch) {
    const bool hole = kind.holes && random.uniform() < 0.4;
    const double factor =
        kind.jumps ? std::pow(10, random.uniform() < 0.3 ? between(-3.3, 5.5) : between(-0.3, 0.3)) : 1;
    const int left = below(width_px), top = below(map.height_px), across = 1 + below(width_px / 2),
              down = 1 + below(map.height_px / 2);
    for (int row = top; row < std::min(map.height_px, top + down); ++row)
      for (int column = left; column < left + across; ++column) {
        float& at = map.distance_m[grid_index(row, column % width_px, width_px)];
        at = hole ? std::numeric_limits<float>::infinity()
                  : static_cast<float>(std::clamp(static_cast<double>(at) * factor, 1e-3, 1e6));
      }
  }
  return map;
}

}  // namespace seamline::stability
