#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Under this many people a group has a verdict and no number.
inline constexpr int fewest_in_group = 5;

/// Whether thresholds of groups of people differ.
struct GroupComparison {
  std::string field;                ///< as it was asked for: "age", "age=30,45", "origin"
  std::vector<std::string> groups;  ///< in their order, also those too small
  std::vector<int> people;          ///< in each
  int silent = 0;                   ///< people used who are in no group: they did not answer
  std::string verdict;              ///< a sentence: why there are no numbers; empty when there are
  /// Threshold shifts along the axis, of each curve and of their mean over curves, adjusted together.
  ContrastTable shifts;
  std::vector<std::string> notes;  ///< a sentence each
};

/// What people are grouped by: each of `fields` is a question of the form, with bands ("age=30,45"), or
/// "origin" (lab, web). Numbers without bands are split at their median. Conditions are compared within
/// people by `JointAnalysis::contrasts` ("condition" says so).
///
/// The groups' thresholds are curves of their own of one joint model, with everything else shared. Intervals
/// and p are of the contrasts' joint t distribution over the jackknife's covariance, with the degrees of
/// freedom of Welch and Satterthwaite, the least of all contrasts. Throws InputError for a field that nobody
/// was asked, or bands that do not rise.
[[nodiscard]] std::vector<GroupComparison> compare_groups(const Analysis& analysis,
                                                          const std::vector<std::string>& fields);

}  // namespace seamline::analysis
