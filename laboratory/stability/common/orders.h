#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace seamline::stability {

/// The errors of one of the product's estimators at growing effort must fall at a known order.
struct OrderSeries {
  std::string name;      ///< of the case
  std::string line;      ///< in the figure's key
  std::string tried;     ///< what was varied
  double expected = 0;   ///< exponent p of error = c effort^p
  double tolerance = 0;  ///< of the exponent
  std::string reason;
  std::size_t panel = 0;  ///< index into `order_panels`
  /// Measures: (effort, error), all positive. The same numbers each time.
  std::function<std::vector<std::pair<double, double>>()> measure;
};

/// Titles and axes of the figure's panels.
struct OrderPanel {
  std::string title, x_label, y_label;
};
[[nodiscard]] const std::vector<OrderPanel>& order_panels();

/// Root mean square error of a point's radiance under a half-hidden sky by n samples, which are n points
/// independent of each other or n points of one scrambled Sobol' set.
[[nodiscard]] OrderSeries radiance_order(bool sobol);
/// The same of a pixel's ratio (`compose`), half shadowed by the object.
[[nodiscard]] OrderSeries ratio_order();
/// Largest error of the adaptive mesh, by brute force, and its number of triangles, against its tolerance.
[[nodiscard]] OrderSeries mesh_error_order();
[[nodiscard]] OrderSeries mesh_triangles_order();
/// Standard deviation of PT over repeated studies, against participants.
[[nodiscard]] OrderSeries perceptual_threshold_order();
/// Standard deviation of a fitted threshold over repeated data, against answers a level.
[[nodiscard]] OrderSeries fitted_threshold_order();
/// Display RMSE of a hard edge that is misplaced by parts of a pixel, or by several.
[[nodiscard]] OrderSeries misplaced_edge_order(bool below_a_pixel);

/// All of them.
[[nodiscard]] std::vector<OrderSeries> order_series();

}  // namespace seamline::stability
