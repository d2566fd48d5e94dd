#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/threshold_rows.h"
#include "analysis/screening/late_marks.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// How the clips of one artifact and condition were shown to the people used.
struct LateRow {
  Artifact artifact = Artifact::none;
  std::string condition = {};
  int answers = 0;           ///< whose frames were counted
  int marked = 0;            ///< of these, by the study's rule
  std::int64_t due = 0;      ///< frames that were due in them
  std::int64_t late = 0;     ///< that came more than two refreshes after their time
  std::int64_t dropped = 0;  ///< that never came
};

/// A threshold with all answers, and without those that are marked.
struct LateThreshold {
  Artifact artifact = Artifact::none;
  std::string condition = {};
  std::string quantity;  ///< "PT", "SN", ...
  TestedLevels tested;
  ThresholdEstimate with, without;
};

/// What late and dropped frames may have done to the results.
struct LateReport {
  LateFrames rule;
  std::vector<LateRow> rows;                   ///< in the order of the log's artifacts and conditions
  std::vector<LateThreshold> thresholds = {};  ///< empty where nothing is marked, or `not_compared` says why
  std::string not_compared = {};               ///< a sentence; empty where nothing is marked

  [[nodiscard]] LateRow all() const;  ///< of all rows together
};

/// `log` is whole, `analysis` of it or of what is left of it.
[[nodiscard]] std::vector<LateRow> late_rows(const study::LogContents& log, const Analysis& analysis,
                                             const LateMarks& marks);

/// Thresholds of record of both, in the order of the first; empty where there is no joint model and nothing
/// was rated.
[[nodiscard]] std::vector<LateThreshold> thresholds_beside(const Analysis& with, const Analysis& without);

/// How the clips were shown, how many trials are marked and what becomes of them: for the notes.
[[nodiscard]] std::string late_sentence(const LateReport& late);

/// The same for a paper, with the largest change of a threshold.
[[nodiscard]] std::string late_method(const LateReport& late);

/// The tables `late_frames` and `late_thresholds`; the second only where thresholds are compared.
[[nodiscard]] std::vector<CsvTable> late_tables(const Analysis& analysis, const LateReport& late);

}  // namespace seamline::analysis
