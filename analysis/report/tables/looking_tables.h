#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "study/exchange/look_records.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// A mean over participants of their own means, with its 95 % interval by Student's t.
struct PeopleMean {
  double mean = 0;
  double low = 0, high = 0;  ///< NaN where one participant is behind it
};

/// How the people used looked round the panoramas of one artifact and condition
/// (study/exchange/look_records.h).
struct LookingRow {
  Artifact artifact = Artifact::none;
  std::string condition = {};
  int people = 0, answers = 0;
  PeopleMean degrees_turned;  ///< a trial
  PeopleMean share_facing;    ///< of a trial's time, the view within 15 degrees of the inserted object
  PeopleMean share_seen;      ///< of trials in which the view ever faced it
  /// Median over the trials in which it did: seconds until it first did. None where it never did.
  std::optional<double> first_look_s = {};
};

/// In the order of the log's artifacts and conditions; empty where there are no looks of people used.
[[nodiscard]] std::vector<LookingRow> looking_rows(const Analysis& analysis,
                                                   const std::vector<study::MeasuredLook>& looks);

/// The table `looking`, a row for each of them.
[[nodiscard]] CsvTable looking_table(const Analysis& analysis, const std::vector<LookingRow>& rows);

}  // namespace seamline::analysis
