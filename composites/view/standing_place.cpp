#include "composites/view/standing_place.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

constexpr double gentle_rise = 0.5, level_rise = 0.85;  ///< of a normal's Y: something stands there; a floor
constexpr int view_rows_asked = 256, view_columns_asked = 256;
constexpr double floor_step_m = 0.05, floor_share_of_distance = 0.02, least_floor_share = 0.02;

std::optional<RealPlace> real_place_in(const Camera& camera, const Geometry& depth,
                                       const Eigen::Vector3d& centre_m, double across, double down) {
  const Eigen::Vector3f direction = camera.direction(static_cast<float>(across * camera.width_px),
                                                     static_cast<float>(down * camera.height_px));
  if (direction.isZero()) return std::nullopt;
  const auto hit = depth.nearest({Eigen::Vector3f::Zero(), direction});
  if (!hit) return std::nullopt;
  return RealPlace{(direction * hit->distance_m).cast<double>() + centre_m,
                   hit->geometric_normal.cast<double>(), across, down};
}

bool is_on_floor(const FloorInView& floor, const RealPlace& place, const Eigen::Vector3d& centre_m) {
  const double near_m = std::max(floor_step_m, floor_share_of_distance * (place.place_m - centre_m).norm());
  return std::abs(place.place_m.y() - floor.height_m) <= near_m && place.normal.y() >= gentle_rise;
}

}  // namespace

std::optional<RealPlace> place_in_view(const Camera& camera, const Geometry& depth,
                                       const Eigen::Vector3d& centre_m, double across) {
  std::optional<RealPlace> any;
  for (int row = view_rows_asked / 2; row < view_rows_asked; ++row) {
    auto place = real_place_in(camera, depth, centre_m, across, double{1} * row / view_rows_asked);
    if (!place) continue;
    if (place->normal.y() >= gentle_rise) return place;
    if (!any) any = place;
  }
  for (int row = view_rows_asked / 2 - 1; row >= 0 && !any; --row)
    any = real_place_in(camera, depth, centre_m, across, double{1} * row / view_rows_asked);
  return any;
}

std::optional<FloorInView> floor_in_view(const Camera& camera, const Geometry& depth,
                                         const Eigen::Vector3d& centre_m) {
  std::vector<RealPlace> places;
  std::map<int, int> at_height;  // of steps
  for (int row = 0; row < view_rows_asked; ++row)
    for (int column = 0; column < view_columns_asked; ++column) {
      const auto place = real_place_in(camera, depth, centre_m, (column + 0.5) / view_columns_asked,
                                       (row + 0.5) / view_rows_asked);
      if (!place || place->normal.y() < level_rise) continue;
      places.push_back(*place);
      ++at_height[static_cast<int>(std::floor(place->place_m.y() / floor_step_m))];
    }
  const int least = static_cast<int>(least_floor_share * view_rows_asked * view_columns_asked);
  for (const auto& [step, count] : at_height) {
    const auto above = at_height.find(step + 1);  // a floor may lie on a boundary of two steps
    if (count + (above == at_height.end() ? 0 : above->second) < least) continue;
    std::vector<double> heights_m;
    for (const RealPlace& place : places)
      if (const double y = place.place_m.y() / floor_step_m; y >= step && y < step + 2)
        heights_m.push_back(place.place_m.y());
    const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
    std::nth_element(heights_m.begin(), middle, heights_m.end());
    FloorInView floor{.height_m = *middle};
    int on = 0;
    for (const RealPlace& place : places) {
      if (!is_on_floor(floor, place, centre_m)) continue;
      const double distance_m = (place.place_m - centre_m).norm();
      floor.nearest_m = on == 0 ? distance_m : std::min(floor.nearest_m, distance_m);
      floor.farthest_m = std::max(floor.farthest_m, distance_m);
      ++on;
    }
    floor.share = double{1} * on / (view_rows_asked * view_columns_asked);
    return floor;
  }
  return std::nullopt;
}

std::vector<std::uint8_t> floor_grid(const Camera& camera, const Geometry& depth, const Geometry* objects,
                                     const FloorInView& floor, const Eigen::Vector3d& centre_m,
                                     double spacing_m, int threads) {
  const int width = camera.width_px, height = camera.height_px;
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  // The square of the grid that a pixel's middle shows; none off the floor.
  std::vector<std::optional<Eigen::Vector2i>> squares(index(0, height));
  parallel_for(height, threads, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const auto place = real_place_in(camera, depth, centre_m, (x + 0.5) / width, (y + 0.5) / height);
      if (!place || !is_on_floor(floor, *place, centre_m)) continue;
      Ray ray = centre_ray(camera, x, y);
      ray.far_m = static_cast<float>((place->place_m - centre_m).norm());
      if (objects != nullptr && objects->occluded(ray)) continue;
      squares[index(x, y)] = Eigen::Vector2i(static_cast<int>(std::floor(place->place_m.x() / spacing_m)),
                                             static_cast<int>(std::floor(place->place_m.z() / spacing_m)));
    }
  });
  std::vector<std::uint8_t> lines(squares.size(), 0);
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      const auto &here = squares[index(x, y)], &right = squares[index(x + 1, y)],
                 &below = squares[index(x, y + 1)];
      lines[index(x, y)] = here && ((right && *right != *here) || (below && *below != *here)) ? 1 : 0;
    }
  return lines;
}

}  // namespace seamline::renderer
