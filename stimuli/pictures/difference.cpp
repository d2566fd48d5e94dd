#include "stimuli/pictures/difference.h"

#include <cassert>
#include <cmath>

namespace seamline::inline stimuli {

double display_rmse(const Image& a, const Image& b, double exposure_ev, const Image* mask) {
  assert(a.values.size() == b.values.size() && a.channels == b.channels);
  for (const Image* image : {&a, &b}) require_numbers(*image);
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  const std::size_t channels = static_cast<std::size_t>(a.channels);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (mask != nullptr && mask->values[i / channels] <= 0.5F) continue;
    const double difference =
        double{srgb_from_linear(a.values[i] * gain)} - double{srgb_from_linear(b.values[i] * gain)};
    sum += difference * difference;
    ++count;
  }
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

double clipped_share(const Image& linear, double exposure_ev) {
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  std::size_t clipped = 0;
  for (const float value : linear.values) clipped += value * gain > 1.0F ? 1 : 0;
  return linear.values.empty() ? 0.0
                               : static_cast<double>(clipped) / static_cast<double>(linear.values.size());
}

}  // namespace seamline::inline stimuli
