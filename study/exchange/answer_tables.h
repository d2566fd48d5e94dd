#pragma once
#include <vector>

#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// A log as tables for other programs: `answers` (a row for each answer to a stimulus), `catch_answers`,
/// `participants` (with a column for each question of the form) and `dictionary`, which says what every
/// column is. All participants are in it, the excluded and the simulated too, each marked.
[[nodiscard]] std::vector<CsvTable> answer_tables(const LogContents& log);

}  // namespace seamline::study
