#include "raytracer/error/change_error.h"

#include <algorithm>
#include <cmath>

#include "raytracer/common/parallel.h"
#include "raytracer/common/tiles.h"

namespace seamline::renderer {
namespace {

constexpr double steps = 16384;
constexpr int most_rows = 270;

std::int16_t stored(float display) {
  constexpr float most = 32767;
  return static_cast<std::int16_t>(std::lround(std::clamp(display * float{steps}, -most, most)));
}

std::vector<int> kept_rows(int height_px) {
  const int step = (height_px + most_rows - 1) / most_rows;
  std::vector<int> rows;
  for (int y = step / 2; y < height_px; y += step) rows.push_back(y);
  return rows;
}

}  // namespace

ErrorMap error_map(const HalfPictures& pictures, const std::array<Image, 2>& filtered_more,
                   double exposure_ev, int threads, bool panorama) {
  const Image& any = pictures.filtered[0];
  ErrorMap map{.rows = kept_rows(any.height_px),
               .width_px = any.width_px,
               .height_px = any.height_px,
               .wraps = panorama};
  const std::size_t a_row = any.index(0, 1), values = a_row * map.rows.size();
  for (auto* one : {&map.off[0], &map.off[1], &map.filtered_by[0], &map.filtered_by[1], &map.rounded_by})
    one->resize(values);
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  parallel_for(static_cast<int>(map.rows.size()), threads, [&](int row) {
    std::size_t to = a_row * static_cast<std::size_t>(row);
    const std::size_t first = any.index(0, map.rows[row]);
    for (std::size_t i = first; i < first + a_row; ++i, ++to) {
      const std::array<float, 2> halves = {pictures.filtered[0].values[i] * gain,
                                           pictures.filtered[1].values[i] * gain};
      const float middle = 0.5F * (halves[0] + halves[1]);
      const float shown =
          srgb_from_linear(pictures.whole.values.empty() ? middle : pictures.whole.values[i] * gain);
      const float weight = std::sqrt(unseen_specks(0.5F * std::abs(halves[0] - halves[1])));
      const float slope = display_slope(middle);
      for (std::size_t half = 0; half < 2; ++half) {
        map.off[half][to] = stored(weight * (shown - srgb_from_linear(halves[half])));
        float change = halves[half] - pictures.sampled[half].values[i] * gain;
        if (!filtered_more[half].values.empty()) change += filtered_more[half].values[i] * gain;
        map.filtered_by[half][to] = stored(slope * change);
      }
      map.rounded_by[to] = stored(static_cast<float>(code_from_display(shown)) / 255.0F - shown);
    }
  });
  return map;
}

double change_error(const ErrorMap& before, const ErrorMap& now) {
  const auto change = [](const std::vector<std::int16_t>& from, const std::vector<std::int16_t>& to,
                         std::size_t i) { return static_cast<double>(to[i] - from[i]); };
  const std::size_t a_row = now.rounded_by.size() / now.rows.size();
  double samples = 0, filters = 0, weights = 0;
  for (std::size_t row = 0; row < now.rows.size(); ++row) {
    double of_samples = 0, of_filters = 0;
    for (std::size_t i = row * a_row; i < (row + 1) * a_row; ++i) {
      const double a = change(before.off[0], now.off[0], i), b = change(before.off[1], now.off[1], i);
      const double rounding = change(before.rounded_by, now.rounded_by, i);
      of_samples += a * a + b * b + a * b + rounding * rounding;
      of_filters += change(before.filtered_by[0], now.filtered_by[0], i) *
                    change(before.filtered_by[1], now.filtered_by[1], i);
    }
    const double weight = now.wraps ? panorama_row_weight(now.rows[row], now.width_px, now.height_px) : 1.0;
    samples += weight * of_samples;
    filters += weight * of_filters;
    weights += weight * static_cast<double>(a_row);
  }
  return (samples + std::max(0.0, filters)) / (weights * steps * steps);
}

}  // namespace seamline::renderer
