#include "raytracer/error/error_estimate.h"

#include <cmath>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

SquaredError block_error(const HalfPictures& pictures, const BlockGrid& blocks, int number, float gain) {
  const BlockGrid::Rectangle block = blocks.rectangle(number);
  SquaredError sum;
  for (int y = block.top; y < block.bottom; ++y) {
    const double weight = blocks.wraps ? panorama_row_weight(y, blocks.width_px, blocks.height_px) : 1.0;
    for (int x = block.left; x < block.right; ++x)
      for (int c = 0; c < 3; ++c) {
        const float a = pictures.filtered[0].at(x, y, c) * gain, b = pictures.filtered[1].at(x, y, c) * gain;
        const float whole =
            pictures.whole.values.empty() ? 0.5F * (a + b) : pictures.whole.at(x, y, c) * gain;
        const double shown = srgb_from_linear(whole), off_a = shown - double{srgb_from_linear(a)},
                     off_b = shown - double{srgb_from_linear(b)};
        sum.noise += weight * double{unseen_specks(0.5F * std::abs(a - b))} *
                     (off_a * off_a + off_b * off_b + off_a * off_b);
        const float change_a = a - pictures.sampled[0].at(x, y, c) * gain;
        const float change_b = b - pictures.sampled[1].at(x, y, c) * gain;
        if (change_a == 0.0F || change_b == 0.0F) continue;
        const double slope = display_slope(0.5F * (a + b));
        if (slope == 0.0) continue;  // too bright to be seen, and perhaps to be subtracted
        sum.bias += weight * slope * slope * double{change_a} * double{change_b};
      }
  }
  const double values = 3.0 * blocks.weight(number);
  return {sum.noise / values, sum.bias / values};
}

/// Adds a part of a picture to the mean over it.
void add_share(const SquaredError& part, double share, SquaredError& mean) {
  mean.noise += share * part.noise;
  mean.bias += share * part.bias;
}

}  // namespace

float unseen_specks(float speck) {
  constexpr float first = 2.2F;
  return speck > first ? 1.0F + 0.64F * std::log(speck / first) : 1.0F;
}

float display_slope(float linear) {
  if (linear >= 1.0F) return 0.0F;
  if (linear <= 0.0031308F) return 12.92F;
  return 1.055F / 2.4F * std::pow(linear, 1.0F / 2.4F - 1.0F);
}

double ErrorEstimate::rmse() const {
  return std::sqrt(image.total() + rounding_square);
}

double ErrorEstimate::worst_tile() const {
  double worst = 0;
  for (const SquaredError& tile : tiles) worst = std::max(worst, tile.total());
  return std::sqrt(worst + rounding_square);
}

ErrorEstimate estimate_error(const HalfPictures& pictures, double exposure_ev, int threads, bool panorama) {
  for (const auto& halves : {&pictures.filtered, &pictures.sampled})
    for (const Image& half : *halves) require_numbers(half);
  if (!pictures.whole.values.empty()) require_numbers(pictures.whole);
  const Image& any = pictures.filtered[0];
  const TileGrid grid{any.width_px, any.height_px, panorama};
  const BlockGrid blocks{any.width_px, any.height_px, panorama};
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  ErrorEstimate estimate;
  estimate.tiles.resize(grid.count());
  estimate.blocks.resize(blocks.count());
  parallel_for(grid.count(), threads, [&](int tile) {
    for (const int block : blocks_of(grid, tile)) {
      SquaredError& error = estimate.blocks[block];
      error = block_error(pictures, blocks, block, gain);
      add_share(error, blocks.weight(block) / grid.weight(tile), estimate.tiles[tile]);
    }
  });
  for (int tile = 0; tile < grid.count(); ++tile)
    add_share(estimate.tiles[tile], grid.share(tile), estimate.image);
  return estimate;
}

}  // namespace seamline::renderer
