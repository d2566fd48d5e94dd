#include "renderer/filtered_bounce.h"

#include <algorithm>

#include "renderer/parallel.h"

namespace seamline {
namespace {

template <class Work>
void each_pixel(const TruthLayers& layers, int threads, const Work& work) {
  parallel_for(layers.height_px, threads, [&](int y) {
    for (int x = 0; x < layers.width_px; ++x) work(x, y, layers.index(x, y));
  });
}

/// Creases of the truth, in 1/m: the depth mesh has them where it has any.
float truth_inverse_reach(const ObjectTruth& truth, std::size_t pixel) {
  const auto k = static_cast<std::size_t>(truth.object_index);
  const float samples = truth.sums.halves[0][pixel].surfaces[k] + truth.sums.halves[1][pixel].surfaces[k];
  return samples > 0.0F ? truth.sums.guides[k - 1][pixel].inverse_reach / samples : 0.0F;
}

}  // namespace

FilteredBounce filtered_rest(const ObjectTruth& truth, const DepthAnswers& depth,
                             const FilterStrength& strength, int threads, std::vector<Guide>& guides) {
  FilteredBounce rest;
  rest.surfaces.resize(guides.size());
  rest.texels.resize(guides.size());
  each_pixel(truth.layers, threads, [&](int x, int y, std::size_t i) {
    const float samples = depth.halves[0][i].rest + depth.halves[1][i].rest;
    Surface& surface = rest.surfaces[i];
    surface = surface_of(depth.guides[i], samples, truth.scene.camera, x, y);
    surface.inverse_reach = std::max(surface.inverse_reach, truth_inverse_reach(truth, i));
    guides[i] = {surface.normal, surface.distance_m};
    if (samples <= 0.0F) return;
    for (std::size_t half = 0; half < 2; ++half) {
      const DepthSums& sums = depth.halves[half][i];
      BounceTexel& texel = rest.texels[i];
      texel.no[half] = sums.no.bounce / surface.albedo;
      texel.change[half] = (sums.with.bounce - sums.no.bounce) / surface.albedo;
      texel.no_samples[half] = texel.change_samples[half] = sums.rest;
    }
  });
  filter_bounce(rest.surfaces, truth.layers.width_px, strength, threads, rest.texels);
  return rest;
}

FilteredBounce filtered_object(const ObjectTruth& truth, const DepthAnswers& depth,
                               const FilterStrength& strength, int threads) {
  FilteredBounce object;
  object.surfaces.resize(truth.layers.guides.size());
  object.texels.resize(truth.layers.guides.size());
  const auto& tiles = truth.sums.objects[static_cast<std::size_t>(truth.object_index - 1)];
  each_pixel(truth.layers, threads, [&](int x, int y, std::size_t i) {
    const ObjectTile* tile = tiles[static_cast<std::size_t>(truth.sums.grid.tile_of(x, y))].get();
    if (tile == nullptr) return;
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const float covered = tile->halves[0][place].covered + tile->halves[1][place].covered;
    if (covered <= 0.0F) return;
    object.surfaces[i] = surface_of(tile->guides[place], covered, truth.scene.camera, x, y);
    for (std::size_t half = 0; half < 2; ++half) {
      const DepthSums& sums = depth.halves[half][i];
      object.texels[i].no[half] = sums.object.bounce / object.surfaces[i].albedo;
      object.texels[i].no_samples[half] = sums.covered;
    }
  });
  filter_bounce(object.surfaces, truth.layers.width_px, strength, threads, object.texels);
  return object;
}

}  // namespace seamline
