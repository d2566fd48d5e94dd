#include "analysis/psychometric/likelihood/binomial_sampler.h"

#include <algorithm>
#include <cmath>

namespace seamline::analysis {

std::int64_t sample_binomial(std::int64_t trials, double probability, Random& random) {
  if (trials <= 0 || probability <= 0) return 0;
  if (probability >= 1) return trials;
  const double n = trials;
  const double odds = probability / (1 - probability);
  const double mode = std::min(n, std::floor((n + 1) * probability));
  const double at_mode = std::exp(std::lgamma(n + 1) - std::lgamma(mode + 1) - std::lgamma(n - mode + 1) +
                                  mode * std::log(probability) + (n - mode) * std::log1p(-probability));
  double left = random.uniform() - at_mode;
  if (left < 0) return static_cast<std::int64_t>(mode);
  double up = mode, down = mode, p_up = at_mode, p_down = at_mode;
  while (up < n || down > 0) {
    if (up < n) {
      p_up *= odds * (n - up) / (up + 1);
      ++up;
      if ((left -= p_up) < 0) return static_cast<std::int64_t>(up);
    }
    if (down > 0) {
      p_down *= down / ((n - down + 1) * odds);
      --down;
      if ((left -= p_down) < 0) return static_cast<std::int64_t>(down);
    }
    if (p_up + p_down < 1e-300) break;  // rounding of the sum of all probabilities
  }
  return static_cast<std::int64_t>(mode);
}

}  // namespace seamline::analysis
