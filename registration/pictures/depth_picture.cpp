#include "registration/pictures/depth_picture.h"

#include <algorithm>
#include <cmath>

namespace seamline::registration {
namespace {

/// The value that this share of them does not exceed.
float percentile(std::vector<float> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

ByteImage depth_picture(const sensors::DepthFrame& frame) {
  std::vector<float> measured;
  std::copy_if(frame.depth_m.begin(), frame.depth_m.end(), std::back_inserter(measured),
               [](float depth_m) { return !sensors::DepthFrame::is_hole(depth_m); });
  ByteImage picture{.width_px = frame.camera.width_px,
                    .height_px = frame.camera.height_px,
                    .channels = 1,
                    .values = std::vector<std::uint8_t>(frame.depth_m.size())};
  if (measured.empty()) return picture;
  const double brightest = 1 / static_cast<double>(percentile(measured, 0.01)),
               darkest = 1 / static_cast<double>(percentile(measured, 0.99));
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    if (sensors::DepthFrame::is_hole(frame.depth_m[i])) continue;
    const double share =
        (1 / static_cast<double>(frame.depth_m[i]) - darkest) / std::max(brightest - darkest, 1e-12);
    picture.values[i] = static_cast<std::uint8_t>(std::lround(40 + 215 * std::clamp(share, 0.0, 1.0)));
  }
  return picture;
}

}  // namespace seamline::registration
