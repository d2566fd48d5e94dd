#include "stimuli/pictures/seam_measure.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "support/arithmetic/grid_index.h"

namespace seamline::inline stimuli {
namespace {

constexpr double deviations_of_a_median = 1.4826;  // of absolute values of normal noise
constexpr int mask_norm = 6;                       // the mask's length: the root of 4 * 1 + 4 * 4 + 16
constexpr int largest_response = 16 * 255;         // in sixths of a step

/// Tiles along a side: the last one is at least half as long as the others.
int tiles_along(int length_px) {
  return std::max(1, (length_px + seam_tile_px / 2) / seam_tile_px);
}

int tile_end(int tile, int tiles, int length_px) {
  return tile + 1 == tiles ? length_px : (tile + 1) * seam_tile_px;
}

/// Absolute responses of the mask by value, in sixths of a step.
class Responses {
 public:
  void add(int response) {
    const int value = std::abs(response);
    ++counts_[value];
    largest_ = std::max(largest_, value);
    ++count_;
  }

  /// As if the responses of each value were spread evenly over the sixth around it.
  [[nodiscard]] double median_sixths() const {
    const double half = static_cast<double>(count_) / 2;
    int below = 0;
    for (int value = 0; value <= largest_; ++value) {
      const int here = counts_[value];
      if (here > 0 && below + here >= half) return value == 0 ? 0 : value - 0.5 + (half - below) / here;
      below += here;
    }
    return 0;
  }

  void clear() {
    std::fill_n(counts_.begin(), largest_ + 1, 0);
    largest_ = count_ = 0;
  }

 private:
  std::vector<int> counts_ = std::vector<int>(largest_response + 1);
  int largest_ = 0, count_ = 0;
};

int response_at(const SignedDifference& d, std::size_t i) {
  const auto across = static_cast<std::size_t>(d.channels),
             row = across * static_cast<std::size_t>(d.width_px);
  const auto line = [&](std::size_t at) {
    return d.steps[at - across] - 2 * d.steps[at] + d.steps[at + across];
  };
  return line(i - row) - 2 * line(i) + line(i + row);
}

/// How far each pixel exceeds a step: +1 or -1 by its sign, 0 where it does not.
std::vector<std::int8_t> exceeding(const SignedDifference& d, const NoiseTiles& noise, int step) {
  std::vector<std::int8_t> signs;
  signs.reserve(d.steps.size() / static_cast<std::size_t>(d.channels));
  std::size_t i = 0;
  for (int y = 0; y < d.height_px; ++y)
    for (int x = 0; x < d.width_px; ++x, i += static_cast<std::size_t>(d.channels)) {
      int channel = 0, largest = d.steps[i];
      for (int c = 1; c < d.channels; ++c)
        if (const int value = d.steps[i + static_cast<std::size_t>(c)]; std::abs(value) > std::abs(largest)) {
          largest = value;
          channel = c;
        }
      const bool exceeds = std::abs(largest) > step &&
                           std::abs(largest) > step + seam_noise_deviations * noise.at(x, y, channel);
      signs.push_back(static_cast<std::int8_t>(!exceeds ? 0 : largest > 0 ? 1 : -1));
    }
  return signs;
}

}  // namespace

SignedDifference signed_difference(const ByteImage& stimulus, const ByteImage& reference) {
  assert(stimulus.values.size() == reference.values.size() && stimulus.channels == reference.channels &&
         stimulus.width_px == reference.width_px);
  SignedDifference difference{.width_px = stimulus.width_px,
                              .height_px = stimulus.height_px,
                              .channels = stimulus.channels,
                              .steps = {}};
  difference.steps.reserve(stimulus.values.size());
  for (std::size_t i = 0; i < stimulus.values.size(); ++i)
    difference.steps.push_back(static_cast<std::int16_t>(int{stimulus.values[i]} - int{reference.values[i]}));
  return difference;
}

double NoiseTiles::at(int x, int y, int channel) const {
  const int column = std::min(x / seam_tile_px, columns - 1), row = std::min(y / seam_tile_px, rows - 1);
  return deviation_steps[static_cast<std::size_t>((row * columns + column) * channels + channel)];
}

NoiseTiles noise_tiles(const SignedDifference& d) {
  NoiseTiles tiles{.columns = tiles_along(d.width_px),
                   .rows = tiles_along(d.height_px),
                   .channels = d.channels,
                   .deviation_steps = {}};
  Responses responses;
  for (int row = 0; row < tiles.rows; ++row)
    for (int column = 0; column < tiles.columns; ++column)
      for (int channel = 0; channel < d.channels; ++channel) {
        responses.clear();
        const int bottom = std::min(tile_end(row, tiles.rows, d.height_px), d.height_px - 1);
        const int right = std::min(tile_end(column, tiles.columns, d.width_px), d.width_px - 1);
        for (int y = std::max(row * seam_tile_px, 1); y < bottom; ++y)
          for (int x = std::max(column * seam_tile_px, 1); x < right; ++x)
            responses.add(response_at(d, grid_index(y, x, d.width_px) * static_cast<std::size_t>(d.channels) +
                                             static_cast<std::size_t>(channel)));
        tiles.deviation_steps.push_back(deviations_of_a_median * responses.median_sixths() / mask_norm);
      }
  return tiles;
}

PixelSet seam_pixels(const SignedDifference& d, const NoiseTiles& noise, int step) {
  const std::vector<std::int8_t> signs = exceeding(d, noise, step);
  const auto at = [&](int x, int y) { return signs[grid_index(y, x, d.width_px)]; };
  const auto has_company = [&](int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, d.height_px - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, d.width_px - 1); ++u)
        if ((u != x || v != y) && at(u, v) == at(x, y)) return true;
    return false;
  };
  PixelSet set{.width_px = d.width_px, .height_px = d.height_px, .values = {}};
  set.values.reserve(signs.size());
  for (int y = 0; y < d.height_px; ++y)
    for (int x = 0; x < d.width_px; ++x) set.values.push_back(at(x, y) != 0 && has_company(x, y) ? 1 : 0);
  return set;
}

SeamMeasure measure_seam(const ByteImage& stimulus, const ByteImage& reference) {
  const SignedDifference difference = signed_difference(stimulus, reference);
  const NoiseTiles noise = noise_tiles(difference);
  SeamMeasure measure;
  for (std::size_t i = 0; i < seam_steps.size(); ++i) {
    const PixelSet set = seam_pixels(difference, noise, seam_steps[i]);
    measure.beyond[i] = {.area_px = std::count(set.values.begin(), set.values.end(), 1),
                         .widest_band_px = widest_band_px(set)};
  }
  if (!noise.deviation_steps.empty())
    measure.largest_noise_steps =
        *std::max_element(noise.deviation_steps.begin(), noise.deviation_steps.end());
  return measure;
}

}  // namespace seamline::inline stimuli
