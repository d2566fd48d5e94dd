#include "renderer/estimators/fast/filtered_bounce.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

template <class Work>
void each_pixel(const TileGrid& grid, const TileSet& tiles, int threads, const Work& work) {
  parallel_for(grid.count(), threads, [&](int tile) {
    if (tiles[static_cast<std::size_t>(tile)] == 0) return;
    const TileGrid::Rectangle r = grid.rectangle(tile);
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x) work(x, y, static_cast<std::size_t>(tile));
  });
}

/// The tiles that both have.
TileSet common(TileSet tiles, const TileSet& others) {
  for (std::size_t t = 0; t < tiles.size(); ++t)
    if (others[t] == 0) tiles[t] = 0;
  return tiles;
}

/// Creases of the truth, in 1/m: the depth mesh has them where it has any.
float truth_inverse_reach(const ObjectTruth& truth, std::size_t pixel) {
  const auto k = static_cast<std::size_t>(truth.object_index);
  const float samples = truth.scene_sums.surfaces(0, pixel, k) + truth.scene_sums.surfaces(1, pixel, k);
  return samples > 0.0F ? truth.scene_sums.guides[k - 1][pixel].inverse_reach / samples : 0.0F;
}

}  // namespace

std::vector<float> sample_shares_of_tiles(const DepthAnswers& depth, const TileSet& filtered) {
  if (std::find(filtered.begin(), filtered.end(), 0) == filtered.end()) return {};
  const std::vector<int>& asked = depth.spp.uncovered;
  const auto is_filtered = [&](std::size_t block) {
    return filtered[static_cast<std::size_t>(tile_of_block(depth.grid, static_cast<int>(block)))] != 0;
  };
  int fewest = std::numeric_limits<int>::max();
  for (std::size_t b = 0; b < asked.size(); ++b)
    if (asked[b] > 0 && is_filtered(b)) fewest = std::min(fewest, asked[b]);
  std::vector<float> shares(asked.size(), 1.0F);
  for (std::size_t b = 0; b < asked.size(); ++b)
    if (asked[b] > fewest && !is_filtered(b))
      shares[b] = static_cast<float>(fewest) / static_cast<float>(asked[b]);
  return shares;
}

FilteredBounce filtered_uncovered(const ObjectTruth& truth, const DepthAnswers& depth,
                                  const FilterStrength& strength, const TileSet& filtered,
                                  const TileSet& tiles, int threads, std::vector<Guide>& guides) {
  FilteredBounce uncovered;
  const TileGrid& grid = depth.grid;
  const auto surface_at = [&](int x, int y, std::size_t i) {
    const float samples = depth.halves[0][i].uncovered_surfaces + depth.halves[1][i].uncovered_surfaces;
    Surface surface = surface_of(depth.guides[i], samples, truth.scene.camera, x, y);
    surface.inverse_reach = std::max(surface.inverse_reach, truth_inverse_reach(truth, i));
    guides[i] = {surface.normal, surface.distance_m};
    return surface;
  };
  if (strength.levels == 0) {
    each_pixel(grid, tiles, threads,
               [&](int x, int y, std::size_t) { surface_at(x, y, truth.truth_sums.index(x, y)); });
    return uncovered;
  }
  uncovered.surfaces.resize(guides.size());
  uncovered.texels.resize(guides.size());
  TileSet changed(static_cast<std::size_t>(grid.count()), 0);
  const std::vector<float> lent = sample_shares_of_tiles(depth, filtered);
  const TileSet beside = with_neighbours(grid, tiles);
  each_pixel(grid, with_neighbours(grid, beside), threads, [&](int x, int y, std::size_t tile) {
    const std::size_t i = truth.truth_sums.index(x, y);
    const Surface& surface = uncovered.surfaces[i] = surface_at(x, y, i);
    if (depth.halves[0][i].uncovered_surfaces + depth.halves[1][i].uncovered_surfaces <= 0.0F) return;
    BounceTexel& texel = uncovered.texels[i];
    for (std::size_t half = 0; half < 2; ++half) {
      const DepthPixel& sums = depth.halves[half][i];
      texel.without_object(half) = sums.without_object.bounce / surface.albedo;
      texel.change(half) = (sums.with_object.bounce - sums.without_object.bounce) / surface.albedo;
      texel.without_samples(half) = texel.change_samples(half) = sums.uncovered_surfaces;
      if ((texel.change(half) != 0.0F).any()) changed[tile] = 1;
    }
    if (!lent.empty()) texel.sums *= lent[static_cast<std::size_t>(depth.blocks().square_of(x, y))];
  });
  // Where nothing changes the ratio is 1 whatever is filtered. A change reaches as far as the filter does,
  // and what it is divided by as far again: both together stay within a tile.
  assert(2 * filter_radius_px(strength) <= TileGrid::side_px);
  filter_bounce(uncovered.surfaces, grid, strength, threads, uncovered.texels,
                common(with_neighbours(grid, changed), beside));
  return uncovered;
}

FilteredBounce filtered_object(const ObjectTruth& truth, const DepthAnswers& depth,
                               const FilterStrength& strength, const TileSet& tiles, int threads) {
  FilteredBounce object;
  object.surfaces.resize(truth.truth_sums.guides.size());
  object.texels.resize(truth.truth_sums.guides.size());
  const TileGrid& grid = truth.scene_sums.grid;
  const TileSet of_object = tiles_of_object(truth.scene_sums, truth.object_index);
  const TileSet beside = with_neighbours(grid, tiles);
  each_pixel(grid, common(with_neighbours(grid, beside), of_object), threads,
             [&](int x, int y, std::size_t t) {
               const ObjectTile* tile = truth.scene_sums.objects[truth.object_index - 1][t].get();
               const std::size_t i = truth.truth_sums.index(x, y);
               const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
               const float covered = tile->halves[0][place].covered + tile->halves[1][place].covered;
               if (covered <= 0.0F) return;
               object.surfaces[i] = surface_of(tile->guides[place], covered, truth.scene.camera, x, y);
               for (std::size_t half = 0; half < 2; ++half) {
                 const DepthPixel& sums = depth.halves[half][i];
                 object.texels[i].without_object(half) = sums.object.bounce / object.surfaces[i].albedo;
                 object.texels[i].without_samples(half) = sums.covered;
               }
             });
  filter_bounce(object.surfaces, grid, strength, threads, object.texels, common(of_object, beside));
  return object;
}

}  // namespace seamline::renderer
