#include "sensors/noise/seen_pixel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "sensors/noise/noise_stream.h"
#include "support/text/error.h"

namespace seamline::sensors {

const char* name_of(PixelState state) {
  switch (state) {
    case PixelState::measured:
      return "measured";
    case PixelState::outlier:
      return "outlier";
    case PixelState::nothing:
      return "nothing there";
    case PixelState::too_weak:
      return "too weak";
    case PixelState::saturated:
      return "saturated";
    case PixelState::dropped:
      return "dropped";
    case PixelState::shadowed:
      return "in the projector's shadow";
    case PixelState::out_of_range:
      return "out of range";
  }
  return "";
}

MeasuredPixel pixel_of_value(double depth_m, const SensorRange& range) {
  const bool inside = depth_m >= range.nearest_m && depth_m <= range.farthest_m;  // false of NaN
  const float value =
      inside && depth_m <= double{std::numeric_limits<float>::max()} ? static_cast<float>(depth_m) : hole;
  if (!(value > 0) || DepthFrame::is_hole(value)) return {.state = PixelState::out_of_range};
  return {.depth_m = value, .confidence = 1, .state = PixelState::measured};
}

bool is_outlier(const Outliers& outliers, const NoiseStream& stream, double scale) {
  return stream.uniform(noise_number::outlier) < outliers.share * scale;
}

double outlier_value_m(const Outliers& outliers, const NoiseStream& stream) {
  return outliers.nearest_m +
         (outliers.farthest_m - outliers.nearest_m) * stream.uniform(noise_number::outlier_value);
}

void require_within(double value, double lowest, double highest, const std::string& field) {
  if (value >= lowest && value <= highest) return;
  throw InputError(
      fmt::format("{}: wanted a number from {:g} to {:g}, found {:g}", field, lowest, highest, value));
}

void require_valid(const SensorRange& range, const std::string& where) {
  require_within(range.nearest_m, 0, 1e9, where + "nearest_m");
  require_within(range.farthest_m, range.nearest_m, 1e9, where + "farthest_m");
}

void require_valid(const Outliers& outliers, const std::string& where) {
  require_within(outliers.share, 0, 1, where + "outlier_share");
  require_within(outliers.nearest_m, 0, 1e9, where + "outlier_nearest_m");
  require_within(outliers.farthest_m, outliers.nearest_m, 1e9, where + "outlier_farthest_m");
}

}  // namespace seamline::sensors
