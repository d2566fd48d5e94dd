#include "sensors/repair/joint_bilateral.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

double square_of_difference(const Image& image, int x, int y, int other_x, int other_y) {
  const float* a = &image.values[image.index(x, y)];
  const float* b = &image.values[image.index(other_x, other_y)];
  double sum = 0;
  for (int channel = 0; channel < image.channels; ++channel) {
    const double difference = static_cast<double>(a[channel]) - static_cast<double>(b[channel]);
    sum += difference * difference;
  }
  return sum;
}

}  // namespace

void require_valid(const JointBilateralRepair& bilateral, const std::string& where) {
  const auto complain = [&](const char* field, const char* wanted, double found) {
    throw input_error(
        {.file = {}, .field = where + field, .wanted = wanted, .found = fmt::format("{:g}", found)});
  };
  if (bilateral.radius_px < 1 || bilateral.radius_px > 50)
    complain("radius_px", "1 to 50 pixels", bilateral.radius_px);
  for (const auto& [field, value] :
       {std::pair{"sigma_px", bilateral.sigma_px}, std::pair{"sigma_colour", bilateral.sigma_colour},
        std::pair{"least_weight", bilateral.least_weight}})
    if (!(value > 0) || !std::isfinite(value)) complain(field, "a number above 0", value);
}

Repaired smooth_by_photograph(const DepthFrame& measured, const Image& photograph,
                              const JointBilateralRepair& bilateral, int threads) {
  require_valid(bilateral, "joint bilateral: ");
  const int width = measured.camera.width_px, height = measured.camera.height_px;
  if (photograph.width_px != width || photograph.height_px != height)
    throw input_error({.file = {},
                       .field = "joint bilateral: photograph",
                       .wanted = fmt::format("{} x {} pixels, as the depth has", width, height),
                       .found = fmt::format("{} x {}", photograph.width_px, photograph.height_px)});
  require_numbers(photograph, "joint bilateral: photograph");

  const int radius = bilateral.radius_px;
  std::vector<double> near(radius + 1);  // the weight of a distance along one axis
  for (int step = 0; step <= radius; ++step)
    near[step] = std::exp(-step * step / (2 * bilateral.sigma_px * bilateral.sigma_px));
  const double of_square = -1 / (2 * bilateral.sigma_colour * bilateral.sigma_colour);
  std::vector<float> depth_m = measured.depth_m;
  run_parallel(height, threads, [&](int row) {
    for (int column = 0; column < width; ++column) {
      const bool is_hole = DepthFrame::is_hole(measured.at(column, row));
      if (is_hole && !bilateral.fills) continue;
      double weights = 0, sum = 0;
      for (int y = std::max(0, row - radius); y <= std::min(height - 1, row + radius); ++y)
        for (int x = std::max(0, column - radius); x <= std::min(width - 1, column + radius); ++x) {
          const float value = measured.at(x, y);
          if (DepthFrame::is_hole(value)) continue;
          const double weight = near[std::abs(x - column)] * near[std::abs(y - row)] *
                                std::exp(of_square * square_of_difference(photograph, column, row, x, y));
          weights += weight;
          sum += weight * value;
        }
      if (is_hole && weights < bilateral.least_weight) continue;
      depth_m[measured.index(column, row)] = static_cast<float>(sum / weights);
    }
  });
  return repaired_frame(measured, std::move(depth_m));
}

}  // namespace seamline::sensors
