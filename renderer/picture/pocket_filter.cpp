#include "renderer/picture/pocket_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raytracer/common/parallel.h"
#include "renderer/picture/bounce_filter.h"

namespace seamline::renderer {
namespace {

constexpr int levels = 2;
constexpr float depth_tolerance = 0.05F;  // relative

/// Light and number of samples are filtered apart, so that pixels with few uncovered samples count for what
/// they saw.
struct PocketLight {
  Rgb without_object = Rgb::Zero();
  Rgb with_object = Rgb::Zero();
  float samples = 0;

  void add(const PocketLight& other, float weight) {
    without_object += weight * other.without_object;
    with_object += weight * other.with_object;
    samples += weight * other.samples;
  }
};

float likeness(const Guide& a, const Guide& b) {
  const float cosine = std::max(0.0F, a.normal.dot(b.normal));
  const float depth_step = std::abs(a.distance_m - b.distance_m) /
                           (depth_tolerance * std::max(a.distance_m, b.distance_m) + 1e-30F);
  return std::pow(cosine, 32.0F) * std::exp(-depth_step * depth_step);
}

/// Texels of the pockets, each the mean of its like neighbours in the end.
void smooth(std::vector<PocketLight>& from, const std::vector<bool>& pockets,
            const std::vector<Guide>& guides, const TileGrid& grid, int threads) {
  std::vector<PocketLight> to(from.size());
  for (int level = 0; level < levels; ++level, std::swap(from, to)) {
    const int step = 1 << level;
    parallel_for(grid.height_px, threads, [&](int y) {
      for (int x = 0; x < grid.width_px; ++x) {
        const std::size_t centre = grid.index(x, y);
        to[centre] = {};
        if (!pockets[centre]) continue;
        for (int dy = -2; dy <= 2; ++dy)
          for (int dx = -2; dx <= 2; ++dx) {
            const int row = y + dy * step;
            int column = x + dx * step;
            if (grid.wraps) column = (column + grid.width_px) % grid.width_px;
            if (column < 0 || row < 0 || column >= grid.width_px || row >= grid.height_px) continue;
            const std::size_t i = grid.index(column, row);
            if (!pockets[i]) continue;
            const float weight = b_spline[dx + 2] * b_spline[dy + 2];
            to[centre].add(from[i], i == centre ? weight : weight * likeness(guides[centre], guides[i]));
          }
      }
    });
  }
}

}  // namespace

std::vector<FilteredLight> filter_pockets(const std::vector<StimulusPixel>& sums,
                                          const std::vector<bool>& pockets, const std::vector<Guide>& guides,
                                          const TileGrid& grid, int threads) {
  std::vector<PocketLight> texels(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (pockets[i]) texels[i] = {sums[i].without_object, sums[i].with_object, sums[i].uncovered_surfaces};
  smooth(texels, pockets, guides, grid, threads);
  std::vector<FilteredLight> filtered(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (texels[i].samples > 0)
      filtered[i] = {texels[i].without_object / texels[i].samples, texels[i].with_object / texels[i].samples};
  return filtered;
}

std::vector<float> filter_pockets(const std::vector<float>& light, const std::vector<StimulusPixel>& sums,
                                  const std::vector<bool>& pockets, const std::vector<Guide>& guides,
                                  const TileGrid& grid, int threads) {
  std::vector<PocketLight> texels(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (pockets[i]) texels[i] = {Rgb::Constant(light[i]), Rgb::Zero(), sums[i].uncovered_surfaces};
  smooth(texels, pockets, guides, grid, threads);
  std::vector<float> filtered(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (texels[i].samples > 0) filtered[i] = texels[i].without_object[0] / texels[i].samples;
  return filtered;
}

}  // namespace seamline::renderer
