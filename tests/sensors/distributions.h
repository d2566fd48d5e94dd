// Whether many samples follow a distribution, at one in ten thousand.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace seamline::sensors::testing {

inline double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Kolmogorov and Smirnov's distance as a multiple of what is exceeded once in 10,000 times: 2 exp(-2 l^2) =
/// 1e-4 at l = 2.2253.
inline double kolmogorov_ratio(std::vector<double> samples, const std::function<double(double)>& cdf) {
  std::sort(samples.begin(), samples.end());
  const double n = static_cast<double>(samples.size());
  double distance = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double p = cdf(samples[i]), rank = static_cast<double>(i);
    distance = std::max({distance, p - rank / n, (rank + 1) / n - p});
  }
  return distance * std::sqrt(n) / 2.2253;
}

/// Pearson's chi-squared as a multiple of what is exceeded once in 10,000 times (Wilson and Hilferty).
inline double chi_squared_ratio(const std::vector<double>& found, const std::vector<double>& expected) {
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    sum += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
  const double freedom = static_cast<double>(found.size()) - 1, ninth = 2 / (9 * freedom);
  return sum / (freedom * std::pow(1 - ninth + 3.719 * std::sqrt(ninth), 3));
}

struct Moments {
  double mean = 0, sigma = 0;
};
inline Moments moments(const std::vector<double>& samples) {
  const double n = static_cast<double>(samples.size());
  Moments found;
  for (const double x : samples) found.mean += x / n;
  for (const double x : samples) found.sigma += (x - found.mean) * (x - found.mean) / n;
  found.sigma = std::sqrt(found.sigma);
  return found;
}

inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const Moments of_a = moments(a), of_b = moments(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - of_a.mean) * (b[i] - of_b.mean);
  return sum / (static_cast<double>(a.size()) * of_a.sigma * of_b.sigma);
}

}  // namespace seamline::sensors::testing
