#include "renderer/picture/rare_light.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "renderer/picture/composite.h"

namespace seamline::renderer {

double rare_light_share(const StimulusSums& sums, const Image& whole, double exposure_ev, int threads) {
  constexpr std::size_t one_in = 500, fewest = 4;
  if (sums.spp < 2) return 0;
  const Image first = compose_half(sums, 0, threads).picture, second = compose_half(sums, 1, threads).picture;
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  std::vector<double> noise;  // of each pixel, as `estimate_error` has it
  for (std::size_t i = 0; i + 2 < whole.values.size(); i += 3) {
    double square = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const double shown{srgb_from_linear(whole.values[c] * gain)};
      const double off_a = shown - double{srgb_from_linear(first.values[c] * gain)},
                   off_b = shown - double{srgb_from_linear(second.values[c] * gain)};
      square += off_a * off_a + off_b * off_b + off_a * off_b;
    }
    noise.push_back(square);
  }
  const std::size_t few = std::min(noise.size(), std::max(fewest, noise.size() / one_in));
  const auto end_of_few = noise.begin() + static_cast<std::ptrdiff_t>(few);
  std::partial_sort(noise.begin(), end_of_few, noise.end(), std::greater<>());
  const double of_few = std::accumulate(noise.begin(), end_of_few, 0.0);
  const double all = std::accumulate(end_of_few, noise.end(), of_few);
  return all > 0 ? of_few / all : 0;
}

}  // namespace seamline::renderer
