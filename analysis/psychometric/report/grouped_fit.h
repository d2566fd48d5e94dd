#pragma once
#include <string>
#include <vector>

#include "analysis/psychometric/people/group_differences.h"
#include "analysis/psychometric/report/fit_table.h"

namespace seamline::analysis {

/// A fit to each group of a table, over participants where the table names them, with all differences.
struct GroupedFit {
  std::vector<FittedGroup> groups;  ///< one without a name where the table has no groups
  std::vector<GroupPair> pairs;
  std::vector<std::string> participants;  ///< names, as `FittedGroup::people` counts them
};

/// Throws InputError as `judge_fit` does.
[[nodiscard]] GroupedFit fit_groups(const FitTable& table, const FitOptions& options,
                                    const FitRequest& request);

/// Tables for a terminal. `fits` is of a table with groups or participants.
[[nodiscard]] std::string grouped_text(const GroupedFit& fits);

/// The same as JSON: `groups` (each as `fit_json` has it, with its name and `people`) and `differences`; of a
/// table without groups what `fit_json` has of everybody's answers together, and `people`.
[[nodiscard]] std::string grouped_json(const GroupedFit& fits);

}  // namespace seamline::analysis
