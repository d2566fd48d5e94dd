#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint_jackknife.h"
#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/scores/level_axis.h"

namespace seamline::analysis {

/// Which curves of a study belong together.
struct CurveLabel {
  std::string artifact, condition, group;  ///< condition and group empty where there is one
};

/// Differences of thresholds and of slopes between curves, a table a question, adjusted together by the
/// contrasts' joint t distribution over the jackknife's covariance; a table's degrees of freedom are the
/// least of its contrasts' (analysis/statistics/jackknife_degrees.h), people - 1 at most. Estimates of
/// thresholds are differences of m along the axis (octaves on log2 axes; where scales and criteria are shared
/// PT, SN and IP differ by the same, guesses apart); those of slopes differences of -log s, so that
/// exp(estimate) is how many times steeper.
struct JointContrasts {
  std::vector<ContrastTable> tables;
  std::vector<std::string> notes;  ///< curves without numbers, which are left out
};

/// Artifacts within each condition, conditions within each artifact, groups within each of both, and slopes
/// of all curves. The thresholds are of the fit and its jackknife (empty where it is not `estimated`), the
/// slopes of a fit in which each curve has its own scale.
[[nodiscard]] JointContrasts joint_contrasts(const JointFit& fit, const JointJackknife& left_out,
                                             const JointData& data, const std::vector<CurveLabel>& labels,
                                             const LevelAxis& axis);

/// The same of a fit of its own.
[[nodiscard]] JointContrasts joint_contrasts(const JointData& data, const std::vector<CurveLabel>& labels,
                                             const JointSharing& sharing, const LevelAxis& axis);

/// The data with a curve for each group of people: curve c of group g is number g x curves + c. `group_of` is
/// one number a person, from 0; -1 leaves a person out.
[[nodiscard]] JointData split_by_group(const JointData& data, const std::vector<int>& group_of, int groups);

/// The data with a curve for each part of the answers: curve c of part k is number k x curves + c. `parts`
/// are `answers` of the same people and cells, one table a part. A cell that nobody answered in a part stays,
/// with counts of 0.
[[nodiscard]] JointData split_by_part(const JointData& data, const std::vector<Eigen::MatrixXd>& parts);

}  // namespace seamline::analysis
