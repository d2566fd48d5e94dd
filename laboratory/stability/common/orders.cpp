#include "laboratory/stability/common/orders.h"

namespace seamline::stability {

const std::vector<OrderPanel>& order_panels() {
  static const std::vector<OrderPanel> panels = {
      {"radiance and ratio", "samples", "RMSE (relative)"},
      {"adaptive mesh", "tolerance", "largest error; triangles / full density"},
      {"thresholds", "participants; answers a level", "standard error (octaves)"},
      {"a misplaced hard edge", "displacement (px)", "RMSE (display units)"}};
  return panels;
}

std::vector<OrderSeries> order_series() {
  return {radiance_order(false),    radiance_order(true),       ratio_order(),
          mesh_error_order(),       mesh_triangles_order(),     perceptual_threshold_order(),
          fitted_threshold_order(), misplaced_edge_order(true), misplaced_edge_order(false)};
}

}  // namespace seamline::stability
