#include "renderer/picture/pocket_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/common/parallel.h"
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

/// How far neighbours are asked whether a pixel is lit by chance, and how far the filter reaches.
constexpr int chance_radius_px = 4;

/// Whether any pixel so near is a pocket: elsewhere, which is nearly everywhere, nothing is asked.
std::vector<bool> beside(const std::vector<bool>& pockets, int width_px, int height_px) {
  std::vector<bool> rows(pockets.size()), out(pockets.size());
  const auto spread = [](const std::vector<bool>& from, std::size_t first, std::size_t step, int count,
                         std::vector<bool>& to) {
    int last = -2 * chance_radius_px;
    const auto at = [&](int i) { return first + static_cast<std::size_t>(i) * step; };
    for (int i = 0; i < count; ++i) {
      if (from[at(i)]) {
        for (int j = std::max({0, i - chance_radius_px, last + 1}); j < i; ++j) to[at(j)] = true;
        last = i;
      }
      if (i - last <= chance_radius_px) to[at(i)] = true;
    }
  };
  const auto width = static_cast<std::size_t>(width_px);
  for (int y = 0; y < height_px; ++y) spread(pockets, static_cast<std::size_t>(y) * width, 1, width_px, rows);
  for (int x = 0; x < width_px; ++x) spread(rows, static_cast<std::size_t>(x), width, height_px, out);
  return out;
}

/// Texels of the pockets, each the mean of its like neighbours in the end.
void smooth(std::vector<PocketLight>& from, const std::vector<bool>& pockets,
            const std::vector<Guide>& guides, int width_px, int height_px, int threads) {
  std::vector<PocketLight> to(from.size());
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
  };
  for (int level = 0; level < levels; ++level, std::swap(from, to)) {
    const int step = 1 << level;
    parallel_for(height_px, threads, [&](int y) {
      for (int x = 0; x < width_px; ++x) {
        const std::size_t centre = index(x, y);
        to[centre] = {};
        if (!pockets[centre]) continue;
        for (int dy = -2; dy <= 2; ++dy)
          for (int dx = -2; dx <= 2; ++dx) {
            const int column = x + dx * step, row = y + dy * step;
            if (column < 0 || row < 0 || column >= width_px || row >= height_px ||
                !pockets[index(column, row)])
              continue;
            const std::size_t i = index(column, row);
            const float weight =
                b_spline[static_cast<std::size_t>(dx + 2)] * b_spline[static_cast<std::size_t>(dy + 2)];
            to[centre].add(from[i], i == centre ? weight : weight * likeness(guides[centre], guides[i]));
          }
      }
    });
  }
}

}  // namespace

std::vector<bool> find_pockets(const std::vector<float>& light, const std::vector<StimulusPixel>& sums,
                               float poorly_lit) {
  std::vector<bool> pockets(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    pockets[i] = sums[i].uncovered_surfaces > 0 && light[i] < poorly_lit * sums[i].uncovered_surfaces;
  return pockets;
}

void add_lit_by_chance(const std::vector<float>& lit, const std::vector<StimulusPixel>& sums,
                       const std::vector<Guide>& guides, int width_px, int height_px, float poorly_lit,
                       int threads, std::vector<bool>& pockets) {
  if (std::find(pockets.begin(), pockets.end(), true) == pockets.end()) return;
  const std::vector<bool> near = beside(pockets, width_px, height_px);
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
  };
  const auto is_lit_by_chance = [&](int x, int y) {
    const std::size_t centre = index(x, y);
    float light = 0, samples = 0;
    for (int row = std::max(0, y - chance_radius_px); row <= std::min(height_px - 1, y + chance_radius_px);
         ++row)
      for (int column = std::max(0, x - chance_radius_px);
           column <= std::min(width_px - 1, x + chance_radius_px); ++column) {
        const std::size_t i = index(column, row);
        if (i == centre || sums[i].uncovered_surfaces <= 0) continue;
        const float weight = likeness(guides[centre], guides[i]);
        light += weight * lit[i];
        samples += weight * sums[i].uncovered_surfaces;
      }
    return samples > 0 && light < poorly_lit * samples;
  };
  std::vector<std::vector<std::size_t>> found(static_cast<std::size_t>(height_px));
  parallel_for(height_px, threads, [&](int y) {
    for (int x = 0; x < width_px; ++x) {
      const std::size_t i = index(x, y);
      if (near[i] && !pockets[i] && sums[i].uncovered_surfaces > 0 && is_lit_by_chance(x, y))
        found[static_cast<std::size_t>(y)].push_back(i);
    }
  });
  for (const auto& row : found)
    for (const std::size_t i : row) pockets[i] = true;
}

std::vector<FilteredLight> filter_pockets(const std::vector<StimulusPixel>& sums,
                                          const std::vector<bool>& pockets, const std::vector<Guide>& guides,
                                          int width_px, int height_px, int threads) {
  std::vector<PocketLight> texels(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (pockets[i]) texels[i] = {sums[i].without_object, sums[i].with_object, sums[i].uncovered_surfaces};
  smooth(texels, pockets, guides, width_px, height_px, threads);
  std::vector<FilteredLight> filtered(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (texels[i].samples > 0)
      filtered[i] = {texels[i].without_object / texels[i].samples, texels[i].with_object / texels[i].samples};
  return filtered;
}

std::vector<float> filter_pockets(const std::vector<float>& light, const std::vector<StimulusPixel>& sums,
                                  const std::vector<bool>& pockets, const std::vector<Guide>& guides,
                                  int width_px, int height_px, int threads) {
  std::vector<PocketLight> texels(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (pockets[i]) texels[i] = {Rgb::Constant(light[i]), Rgb::Zero(), sums[i].uncovered_surfaces};
  smooth(texels, pockets, guides, width_px, height_px, threads);
  std::vector<float> filtered(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (texels[i].samples > 0) filtered[i] = texels[i].without_object[0] / texels[i].samples;
  return filtered;
}

}  // namespace seamline::renderer
