#include "raytracer/error/true_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "raytracer/common/tiles.h"
#include "raytracer/error/error_estimate.h"

namespace seamline::renderer {
namespace {

/// Means over the tiles of `product(x, y)`, a sum over channels; `values(x, y)` is how many values it has.
template <class Product, class Values>
TrueError mean_over_tiles(const TileGrid& grid, const Product& product, const Values& values) {
  TrueError error;
  std::vector<double> counts;
  double sum = 0, count = 0;
  for (int tile = 0; tile < grid.count(); ++tile) {
    const TileGrid::Rectangle r = grid.rectangle(tile);
    double tile_sum = 0, tile_count = 0;
    for (int y = r.top; y < r.bottom; ++y) {
      const double weight = grid.wraps ? panorama_row_weight(y, grid.width_px, grid.height_px) : 1.0;
      for (int x = r.left; x < r.right; ++x) {
        const int number = values(x, y);
        if (number == 0) continue;
        tile_sum += weight * product(x, y);
        tile_count += weight * number;
      }
    }
    error.tiles.push_back(tile_count > 0 ? tile_sum / tile_count : 0);
    counts.push_back(tile_count);
    sum += tile_sum;
    count += tile_count;
  }
  if (!(count > 0)) return error;
  error.squared = sum / count;
  // Tiles differ by the reference's noise and by how well each was rendered; as if they had been drawn from
  // many alike.
  double variance = 0;
  for (std::size_t t = 0; t < counts.size(); ++t) {
    const double deviation = counts[t] / count * (error.tiles[t] - error.squared);
    variance += deviation * deviation;
  }
  const auto tiles = static_cast<double>(counts.size());
  error.squared_standard_error = tiles > 1 ? std::sqrt(variance * tiles / (tiles - 1)) : 0;
  return error;
}

}  // namespace

double TrueError::rmse() const {
  return std::sqrt(std::max(0.0, squared));
}

double TrueError::standard_error() const {
  // d sqrt(s) = ds / (2 sqrt(s)), and never more than what an error of 0 may turn out to be.
  const double largest = std::sqrt(squared_standard_error);
  return rmse() > 0 ? std::min(largest, squared_standard_error / (2 * rmse())) : largest;
}

bool TrueError::reference_is_noisy() const {
  constexpr double much = 0.2;
  return std::abs(squared - squared_with_rare_light) > much * std::abs(squared);
}

int TrueError::worst_tile() const {
  return static_cast<int>(std::max_element(tiles.begin(), tiles.end()) - tiles.begin());
}

double TrueError::worst_tile_rmse() const {
  if (tiles.empty()) return 0;
  return std::sqrt(std::max(0.0, tiles[worst_tile()]));
}

namespace {

/// The slope by which a difference of light becomes one of the display. For small errors it is the tangent at
/// the picture, which knows nothing of the reference's noise. A tangent alone makes an error of 1.5 of two
/// pictures that differ by 0.17 (it is 12.9 at black), and none of a white one, whatever should be there:
/// where tangent and secant are too far apart for that to be noise, it is the secant.
double slope_of_error(float shown, float reference) {
  constexpr double apart = 1.5;
  constexpr float clearly_not_white = 0.6F;  // linear
  const double tangent = display_slope(shown), difference = double{shown} - double{reference};
  if (difference == 0) return tangent;
  const double secant = (double{srgb_from_linear(shown)} - double{srgb_from_linear(reference)}) / difference;
  if (tangent == 0) return reference < clearly_not_white ? secant : 0;
  return secant > apart * tangent || tangent > apart * secant ? secant : tangent;
}

/// Light of the two halves of a value, and the reference's light by which the curve's slope is asked.
struct HalvesLight {
  float first, second, both;
};

/// White ends light.
HalvesLight cut_at_white(float first, float second, float) {
  const float cut_first = std::min(1.0F, first), cut_second = std::min(1.0F, second);
  return {cut_first, cut_second, 0.5F * (cut_first + cut_second)};
}

/// White ends light where both halves are beyond it. Rare light that one half alone has met is kept.
HalvesLight keep_rare_light(float first, float second, float shown) {
  if (first >= 1 && second >= 1) return {1.0F, 1.0F, 1.0F};
  const bool first_is_nearer = std::abs(first - shown) < std::abs(second - shown);
  return {first, second, std::min(1.0F, first_is_nearer ? first : second)};
}

}  // namespace

TrueError true_error(const ByteImage& shown, const ReferenceHalves& reference, double exposure_ev,
                     bool panorama) {
  assert(shown.channels == 3 && shown.width_px == reference[0].width_px &&
         shown.height_px == reference[0].height_px);
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  std::array<float, 256> linear{};
  for (std::size_t code = 0; code < linear.size(); ++code)
    linear[code] = linear_from_srgb(static_cast<float>(code) / 255.0F);
  const auto error_with = [&](const auto& light_of) {
    return mean_over_tiles(
        {shown.width_px, shown.height_px, panorama},
        [&](int x, int y) {
          double sum = 0;
          for (int c = 0; c < 3; ++c) {
            const float at = linear[shown.values[reference[0].index(x, y) + static_cast<std::size_t>(c)]];
            const HalvesLight light =
                light_of(reference[0].at(x, y, c) * gain, reference[1].at(x, y, c) * gain, at);
            const double slope = slope_of_error(at, light.both);
            sum += slope * slope * (double{at} - double{light.first}) * (double{at} - double{light.second});
          }
          return sum;
        },
        [](int, int) { return 3; });
  };
  TrueError error = error_with(cut_at_white);
  error.squared_with_rare_light = error_with(keep_rare_light).squared;
  return error;
}

TrueError true_linear_error(const Image& picture, const ReferenceHalves& reference, const Image& mask) {
  assert(picture.channels == 3 && picture.values.size() == reference[0].values.size());
  return mean_over_tiles(
      {picture.width_px, picture.height_px},
      [&](int x, int y) {
        double sum = 0;
        for (int c = 0; c < 3; ++c)
          sum += (double{picture.at(x, y, c)} - double{reference[0].at(x, y, c)}) *
                 (double{picture.at(x, y, c)} - double{reference[1].at(x, y, c)});
        return sum;
      },
      [&](int x, int y) { return mask.at(x, y) > 0.5F ? 3 : 0; });
}

}  // namespace seamline::renderer
