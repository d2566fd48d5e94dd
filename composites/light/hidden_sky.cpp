#include "composites/light/hidden_sky.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "raytracer/common/parallel.h"
#include "renderer/depth/depth_map.h"

namespace seamline::renderer {
namespace {

constexpr int hidden_sky_px = 512;

/// Radiance times weight, and weight, of the texels of one level of the pyramid.
struct SkyLevel {
  int width_px = 0, height_px = 0;
  std::vector<Rgb> sum;
  std::vector<float> weight;

  SkyLevel(int width, int height)
      : width_px(width),
        height_px(height),
        sum(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Rgb::Zero()),
        weight(sum.size(), 0.0F) {}
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
           static_cast<std::size_t>(column);
  }
};

SkyLevel halved(const SkyLevel& fine) {
  SkyLevel coarse(std::max(1, fine.width_px / 2), std::max(1, fine.height_px / 2));
  for (int row = 0; row < fine.height_px; ++row)
    for (int column = 0; column < fine.width_px; ++column) {
      const std::size_t from = fine.index(column, row);
      const std::size_t to =
          coarse.index(std::min(column / 2, coarse.width_px - 1), std::min(row / 2, coarse.height_px - 1));
      coarse.sum[to] += fine.sum[from];
      coarse.weight[to] += fine.weight[from];
    }
  return coarse;
}

}  // namespace

std::shared_ptr<const DirectionMap<Rgb>> fill_hidden_sky(const Geometry& local,
                                                         const EnvironmentMap& panorama, int threads) {
  constexpr int width_px = hidden_sky_px, height_px = width_px / 2;
  DirectionMap<Rgb> hidden{
      .width_px = width_px, .height_px = height_px, .texels = {}, .known = {}, .elsewhere = Rgb::Zero()};
  hidden.texels.assign(static_cast<std::size_t>(width_px) * height_px, Rgb::Zero());
  hidden.known.assign(hidden.texels.size(), 0);
  std::vector<SkyLevel> levels{SkyLevel(width_px, height_px)};
  parallel_for(height_px, threads, [&](int row) {
    const auto solid_angle_sr = static_cast<float>(texel_solid_angle_sr(row, width_px, height_px));
    for (int column = 0; column < width_px; ++column) {
      const Eigen::Vector3f direction =
          panorama_direction(column + 0.5, row + 0.5, width_px, height_px).cast<float>();
      const std::size_t i = hidden.index(column, row);
      if (local.occluded({Eigen::Vector3f::Zero(), direction})) {
        hidden.known[i] = 1;
        continue;
      }
      levels.front().sum[i] = solid_angle_sr * panorama.radiance(direction);
      levels.front().weight[i] = solid_angle_sr;
    }
  });
  const auto is_hidden = [](std::uint8_t known) { return known != 0; };
  if (std::all_of(hidden.known.begin(), hidden.known.end(), is_hidden) ||
      std::none_of(hidden.known.begin(), hidden.known.end(), is_hidden))
    return nullptr;
  while (levels.back().width_px > 1) levels.push_back(halved(levels.back()));
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column) {
      const std::size_t i = hidden.index(column, row);
      if (hidden.known[i] == 0) continue;
      std::size_t level = 0, at = 0;
      do {
        ++level;
        const SkyLevel& mean = levels[level];
        at = mean.index(std::min(column >> level, mean.width_px - 1),
                        std::min(row >> level, mean.height_px - 1));
      } while (!(levels[level].weight[at] > 0.0F));
      hidden.texels[i] = levels[level].sum[at] / levels[level].weight[at];
    }
  return std::make_shared<const DirectionMap<Rgb>>(std::move(hidden));
}

}  // namespace seamline::renderer
