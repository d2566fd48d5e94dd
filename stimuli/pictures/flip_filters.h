#pragma once
#include <vector>

#include "support/files/image.h"

namespace seamline::inline stimuli {

/// A separable filter: the same odd number of weights along x and y.
struct SeparableFilter {
  std::vector<double> along_x;
  std::vector<double> along_y;
};

/// A Gaussian in the sum that makes a contrast sensitivity filter.
struct WeightedFilter {
  double weight = 1;  ///< the weights of one channel add up to 1
  SeparableFilter filter;
};

/// The contrast sensitivity functions of the opponent channels (Andersson et al. 2020, section 4.1, Eqs. 4
/// and 5, constants of Table 1) as filters on a picture with so many pixels a degree: Y, Cx, then Cz, which
/// is the sum of two Gaussians. Radius 3 standard deviations of the widest; each channel's weights add up
/// to 1.
[[nodiscard]] std::vector<std::vector<WeightedFilter>> sensitivity_filters(double pixels_per_degree);

/// First and second derivatives of a Gaussian whose standard deviation is half of w = 0.082 degrees (section
/// 4.2): positive weights add up to 1, negative ones to -1.
struct FeatureFilters {
  SeparableFilter edge_x, edge_y, point_x, point_y;
};
[[nodiscard]] FeatureFilters feature_filters(double pixels_per_degree);

/// One channel filtered; beyond the border the picture goes on as its nearest pixel.
[[nodiscard]] Image filtered(const Image& one_channel, const SeparableFilter& filter);

}  // namespace seamline::inline stimuli
