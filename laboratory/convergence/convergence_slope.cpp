#include "laboratory/convergence/convergence_slope.h"

#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace seamline::renderer {

std::optional<double> log_log_slope(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  std::vector<std::pair<double, double>> logs;
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0) || !(y[i] > 0) || !std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    logs.emplace_back(std::log(x[i]), std::log(y[i]));
    mean_x += logs.back().first;
    mean_y += logs.back().second;
  }
  if (logs.size() < 2) return std::nullopt;
  mean_x /= logs.size();
  mean_y /= logs.size();
  double variance = 0, covariance = 0;
  for (const auto& [log_x, log_y] : logs) {
    variance += (log_x - mean_x) * (log_x - mean_x);
    covariance += (log_x - mean_x) * (log_y - mean_y);
  }
  // The mean of equal numbers may differ from them by rounding.
  if (variance <= 1e-20 * (1 + mean_x * mean_x)) return std::nullopt;
  return covariance / variance;
}

}  // namespace seamline::renderer
