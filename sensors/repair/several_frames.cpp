#include "sensors/repair/several_frames.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

/// Of sorted values.
float middle_half_mean(const std::vector<float>& values) {
  const auto left_out = static_cast<std::ptrdiff_t>(values.size() / 4);
  const double sum = std::accumulate(values.begin() + left_out, values.end() - left_out, 0.0);
  return static_cast<float>(sum / (values.size() - 2 * (values.size() / 4)));
}

}  // namespace

DepthFrame mean_of_frames(std::span<const DepthFrame> frames, const std::string& where, int threads) {
  if (frames.empty()) throw input_error({.field = where, .wanted = "at least one frame", .found = "none"});
  DepthFrame mean = frames.front();
  for (const DepthFrame& frame : frames)
    if (frame.camera != mean.camera || frame.convention != mean.convention ||
        frame.depth_m.size() != mean.depth_m.size())
      throw input_error({.field = where, .wanted = "frames of one camera", .found = "different ones"});
  if (frames.size() == 1) return mean;
  run_parallel(mean.camera.height_px, threads, [&](int row) {
    std::vector<float> values;
    for (int column = 0; column < mean.camera.width_px; ++column) {
      values.clear();
      for (const DepthFrame& frame : frames)
        if (!DepthFrame::is_hole(frame.at(column, row))) values.push_back(frame.at(column, row));
      std::sort(values.begin(), values.end());
      mean.depth_m[mean.index(column, row)] =
          2 * values.size() < frames.size() ? hole : middle_half_mean(values);
    }
  });
  return mean;
}

}  // namespace seamline::sensors
