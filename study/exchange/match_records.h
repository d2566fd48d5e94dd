#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// A match whose answer the log holds: where a participant stopped.
struct MatchRecord {
  std::string participant;
  int trial_index = 0;
  std::string scene;
  Artifact artifact = Artifact::none;
  std::string object;
  std::string condition = {};  ///< empty where the study has one
  double start_level = 0;
  double level = 0;          ///< at which it was just seen
  bool began_clear = false;  ///< in the half of the levels where more is seen
  bool at_end = false;       ///< at the first or the last level: it may be seen just beyond
  int steps = 0;             ///< presses that were made, also where there was no level further on
  double answer_s = 0;       ///< from the picture's onset
};

/// Ordered by participant and trial; empty where the study of the log asks for no match. Throws InputError
/// when the log cannot be read, or an answer of a match has no level.
[[nodiscard]] std::vector<MatchRecord> read_matches(const LogContents& log);

/// `matches`, a row a match; none where there are none.
[[nodiscard]] std::optional<CsvTable> match_table(const LogContents& log);

}  // namespace seamline::study
