#pragma once
#include <Eigen/Core>
#include <span>

#include "analysis/ordinal/contrasts/contrasts.h"

namespace seamline::analysis {

/// A part of a family that a model of its own says something of.
struct EstimatedContrasts {
  ContrastFamily family;
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;  ///< belongs to the coefficients; empty: nothing is estimable
};

/// The parts of one family, each by its own model, so that their joint distribution is not known: p values
/// are Holm's over all parts, intervals simultaneous by Bonferroni, and there is no test of all at once. The
/// question is that of the first part. Both hold whatever the parts have in common.
[[nodiscard]] ContrastTable test_contrasts_apart(std::span<const EstimatedContrasts> parts);

/// A family with more contrasts than this is adjusted as parts are, because the joint distribution costs the
/// square of their number and more.
inline constexpr int most_joint_contrasts = 1000;

}  // namespace seamline::analysis
