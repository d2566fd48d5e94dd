#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/ordinal/contrasts/contrasts.h"

namespace seamline::analysis {

/// Below this an adjusted p value differs from chance.
inline constexpr double significance = 0.05;

/// A table of a family without rows.
[[nodiscard]] ContrastTable empty_table(const ContrastFamily& family, Correction correction);

/// A row a contrast: estimate, standard error and p of each alone; not yet adjusted, concluded from or given
/// an interval. NaN where there is no variance.
[[nodiscard]] std::vector<ContrastRow> estimated_rows(const ContrastFamily& family,
                                                      const Eigen::VectorXd& coefficients,
                                                      const Eigen::MatrixXd& covariance);

/// Verdict and sentence of a row whose adjusted p and interval are known.
void conclude(const Contrast& contrast, bool odds_ratio, ContrastRow& row);

}  // namespace seamline::analysis
