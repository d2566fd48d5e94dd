#include "raytracer/error/error_estimate.h"

#include <cmath>
#include <utility>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

template <class Pixel>
double block_sum(const BlockGrid& blocks, int number, const Pixel& pixel) {
  const BlockGrid::Rectangle block = blocks.rectangle(number);
  double sum = 0;
  for (int y = block.top; y < block.bottom; ++y) {
    const double weight = blocks.wraps ? panorama_row_weight(y, blocks.width_px, blocks.height_px) : 1.0;
    for (int x = block.left; x < block.right; ++x)
      for (int c = 0; c < 3; ++c) sum += pixel(x, y, c, weight);
  }
  return sum / (3.0 * blocks.weight(number));
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

double block_noise(const std::array<Image, 2>& halves, const Image& whole, const BlockGrid& blocks, int block,
                   float gain) {
  return block_sum(blocks, block, [&](int x, int y, int c, double weight) {
    const float a = halves[0].at(x, y, c) * gain, b = halves[1].at(x, y, c) * gain;
    const float of_all = whole.values.empty() ? 0.5F * (a + b) : whole.at(x, y, c) * gain;
    const double shown = srgb_from_linear(of_all), off_a = shown - double{srgb_from_linear(a)},
                 off_b = shown - double{srgb_from_linear(b)};
    return weight * double{unseen_specks(0.5F * std::abs(a - b))} *
           (off_a * off_a + off_b * off_b + off_a * off_b);
  });
}

double block_bias(const std::array<Image, 2>& filtered, const std::array<Image, 2>& sampled,
                  const BlockGrid& blocks, int block, float gain) {
  return block_sum(blocks, block, [&](int x, int y, int c, double weight) {
    const float a = filtered[0].at(x, y, c) * gain, b = filtered[1].at(x, y, c) * gain;
    const float change_a = a - sampled[0].at(x, y, c) * gain, change_b = b - sampled[1].at(x, y, c) * gain;
    if (change_a == 0.0F || change_b == 0.0F) return 0.0;
    const double slope = display_slope(0.5F * (a + b));
    if (slope == 0.0) return 0.0;  // too bright to be seen, and perhaps to be subtracted
    return weight * slope * slope * double{change_a} * double{change_b};
  });
}

ErrorEstimate error_of_blocks(std::vector<SquaredError> of_blocks, const BlockGrid& blocks) {
  const TileGrid grid{blocks.width_px, blocks.height_px, blocks.wraps};
  ErrorEstimate estimate;
  estimate.blocks = std::move(of_blocks);
  estimate.tiles.resize(static_cast<std::size_t>(grid.count()));
  for (int tile = 0; tile < grid.count(); ++tile) {
    SquaredError& sum = estimate.tiles[static_cast<std::size_t>(tile)];
    for (const int block : blocks_of(grid, tile))
      add_share(estimate.blocks[static_cast<std::size_t>(block)], blocks.weight(block) / grid.weight(tile),
                sum);
    add_share(sum, grid.share(tile), estimate.image);
  }
  return estimate;
}

ErrorEstimate estimate_error(const HalfPictures& pictures, double exposure_ev, int threads, bool panorama) {
  for (const auto& halves : {&pictures.filtered, &pictures.sampled})
    for (const Image& half : *halves) require_numbers(half);
  if (!pictures.whole.values.empty()) require_numbers(pictures.whole);
  const Image& any = pictures.filtered[0];
  const BlockGrid blocks{any.width_px, any.height_px, panorama};
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  std::vector<SquaredError> of_blocks(static_cast<std::size_t>(blocks.count()));
  parallel_for(blocks.rows(), threads, [&](int row) {
    for (int block = row * blocks.columns(); block < (row + 1) * blocks.columns(); ++block)
      of_blocks[static_cast<std::size_t>(block)] = {
          block_noise(pictures.filtered, pictures.whole, blocks, block, gain),
          block_bias(pictures.filtered, pictures.sampled, blocks, block, gain)};
  });
  return error_of_blocks(std::move(of_blocks), blocks);
}

}  // namespace seamline::renderer
