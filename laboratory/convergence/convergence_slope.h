#pragma once
#include <optional>
#include <span>
#include <string>

namespace seamline::renderer {

/// The exponent p of the power law y = c x^p that fits best: least squares of log y on log x. Points whose x
/// or y is not a positive finite number have no logarithm and are left out. None when fewer than two
/// different x are left.
[[nodiscard]] std::optional<double> log_log_slope(std::span<const double> x, std::span<const double> y);

/// One line of the table of slopes.
struct SlopeRow {
  std::string part;             ///< samples, mesh or width
  std::string series;           ///< which line of the figure
  std::string of;               ///< what falls or grows, and in what
  std::optional<double> found;  ///< none when there were too few points
  double expected = 0;
  std::string why;  ///< why this slope is expected, or what the found one says
};

}  // namespace seamline::renderer
