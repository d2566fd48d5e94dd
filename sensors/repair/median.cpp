#include "sensors/repair/median.h"

#include <fmt/core.h>

#include <algorithm>

#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::sensors {

void require_valid(const MedianRepair& median, const std::string& where) {
  if (median.radius_px >= 1 && median.radius_px <= 50) return;
  throw input_error({.file = {},
                     .field = where + "radius_px",
                     .wanted = "1 to 50 pixels",
                     .found = fmt::format("{}", median.radius_px)});
}

Repaired smooth_by_median(const DepthFrame& measured, const MedianRepair& median, int threads) {
  require_valid(median, "median: ");
  const int width = measured.camera.width_px, height = measured.camera.height_px, radius = median.radius_px;
  std::vector<float> depth_m = measured.depth_m;
  run_parallel(height, threads, [&](int row) {
    std::vector<float> window;
    const int top = std::max(0, row - radius), bottom = std::min(height - 1, row + radius);
    for (int column = 0; column < width; ++column) {
      const bool is_hole = DepthFrame::is_hole(measured.at(column, row));
      if (is_hole && !median.fills) continue;
      const int left = std::max(0, column - radius), right = std::min(width - 1, column + radius);
      window.clear();
      for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x)
          if (const float value = measured.at(x, y); !DepthFrame::is_hole(value)) window.push_back(value);
      const int area = (bottom - top + 1) * (right - left + 1);
      if (is_hole && 2 * std::ssize(window) < area) continue;
      const auto middle = window.begin() + static_cast<std::ptrdiff_t>((window.size() - 1) / 2);
      std::nth_element(window.begin(), middle, window.end());
      depth_m[measured.index(column, row)] = *middle;
    }
  });
  return repaired_frame(measured, std::move(depth_m));
}

}  // namespace seamline::sensors
