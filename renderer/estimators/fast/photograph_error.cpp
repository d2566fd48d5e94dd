#include "renderer/estimators/fast/photograph_error.h"

#include <algorithm>

#include "renderer/views/view_picture.h"

namespace seamline::renderer {
namespace {

constexpr double share_without_object = 0.5;

Image half_without_object(const TruthSums& truth, std::size_t half) {
  Image image(truth.width_px, truth.height_px, 3);
  const float scale = 1.0F / static_cast<float>((truth.spp + 1 - static_cast<int>(half)) / 2);
  for (int y = 0; y < truth.height_px; ++y)
    for (int x = 0; x < truth.width_px; ++x) {
      const TruthPixel& sums = truth.halves[half][truth.index(x, y)];
      image.set_rgb(x, y, (sums.sky + sums.without_object.total() + sums.object.total()) * scale);
    }
  return image;
}

/// Raises the noise of blocks to that of others, and of tiles and the image with them.
void raise_noise(const std::vector<SquaredError>& least, double share, const TileGrid& grid,
                 ErrorEstimate& error) {
  const BlockGrid blocks{grid.width_px, grid.height_px, grid.wraps};
  for (std::size_t b = 0; b < error.blocks.size(); ++b) {
    const int block = static_cast<int>(b);
    const double more = share * least[b].noise - error.blocks[b].noise;
    if (!(more > 0)) continue;
    error.blocks[b].noise += more;
    error.image.noise += blocks.share(block) * more;
    const int tile = tile_of_block(grid, block);
    error.tiles[tile].noise += blocks.weight(block) / grid.weight(tile) * more;
  }
}

}  // namespace

PhotographHalves photograph_halves(const TruthSums& truth, const View& view) {
  PhotographHalves halves;
  for (std::size_t half = 0; half < 2; ++half) {
    halves.with_object[half] = shown_to_each_eye(view, half_reference_image(truth, half));
    halves.without_object[half] = shown_to_each_eye(view, half_without_object(truth, half));
  }
  return halves;
}

ErrorEstimate photograph_error(const PhotographHalves& filtered, const PhotographHalves& sampled,
                               double exposure_ev, int threads, bool panorama) {
  ErrorEstimate error = estimate_error({.filtered = filtered.with_object, .sampled = sampled.with_object},
                                       exposure_ev, threads, panorama);
  const ErrorEstimate without =
      estimate_error({.filtered = filtered.without_object, .sampled = filtered.without_object}, exposure_ev,
                     threads, panorama);
  const Image& any = filtered.with_object[0];
  raise_noise(without.blocks, share_without_object, {any.width_px, any.height_px, panorama}, error);
  return error;
}

}  // namespace seamline::renderer
