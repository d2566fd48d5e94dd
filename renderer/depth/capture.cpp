#include "renderer/depth/capture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

/// Rays go to the tracer in blocks of neighbouring texels, which see the same surfaces.
constexpr int ray_block_px = 4;

struct SineAndCosine {
  double sine, cosine;
};

/// The parts of `panorama_direction` that all texels of a column or of a row share.
struct TexelDirections {
  std::vector<SineAndCosine> azimuth;    ///< of each column
  std::vector<SineAndCosine> elevation;  ///< of each row

  [[nodiscard]] Eigen::Vector3f at(int column, int row) const {
    const SineAndCosine &a = azimuth[column], &e = elevation[row];
    return Eigen::Vector3d(a.sine * e.cosine, e.sine, -a.cosine * e.cosine).cast<float>();
  }
};

TexelDirections texel_directions(int width_px, int height_px, double yaw_texels) {
  TexelDirections directions;
  for (int column = 0; column < width_px; ++column) {
    const double azimuth_rad = ((column + yaw_texels + 0.5) / width_px - 0.5) * 2 * std::numbers::pi;
    directions.azimuth.push_back({std::sin(azimuth_rad), std::cos(azimuth_rad)});
  }
  for (int row = 0; row < height_px; ++row) {
    const double elevation_rad = (0.5 - (row + 0.5) / height_px) * std::numbers::pi;
    directions.elevation.push_back({std::sin(elevation_rad), std::cos(elevation_rad)});
  }
  return directions;
}

/// The texels of one band of rows, block by block.
void capture_band(const Geometry& geometry, const TexelDirections& directions, int top, DepthMap& map) {
  const int rows = std::min(ray_block_px, map.height_px - top);
  std::array<Ray, ray_block_px * ray_block_px> rays;
  std::array<float, ray_block_px * ray_block_px> distance_m;
  for (Ray& ray : rays) ray.origin_m.setZero();
  for (int left = 0; left < map.width_px; left += ray_block_px) {
    const int columns = std::min(ray_block_px, map.width_px - left);
    const auto count = static_cast<std::size_t>(rows * columns);
    Ray* ray = rays.data();
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        ray++->direction = directions.at(left + column, top + row);
    geometry.distances(std::span(rays).first(count), std::span(distance_m).first(count));
    for (int row = 0; row < rows; ++row)
      std::copy_n(&distance_m[static_cast<std::size_t>(row * columns)], columns,
                  &map.distance_m[grid_index(top + row, left, map.width_px)]);
  }
}

}  // namespace

DepthMap capture_depth(const Geometry& geometry, int width_px, double yaw_texels, int threads) {
  DepthMap map{.width_px = width_px, .height_px = width_px / 2, .distance_m = {}};
  map.distance_m.resize(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(map.height_px));
  const TexelDirections directions = texel_directions(width_px, map.height_px, yaw_texels);
  const int bands = (map.height_px + ray_block_px - 1) / ray_block_px;
  parallel_for(bands, threads,
               [&](int band) { capture_band(geometry, directions, band * ray_block_px, map); });
  return map;
}

}  // namespace seamline::renderer
