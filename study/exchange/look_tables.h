#pragma once
#include <vector>

#include "study/log/log.h"
#include "support/text/csv.h"

namespace seamline::study {

/// Of a study with panoramas two tables: `looks`, a row for each answer to a stimulus (degrees turned, first
/// look at the inserted object, share of time facing it), and `poses`, a row for each pose. Of others none.
[[nodiscard]] std::vector<CsvTable> look_tables(const LogContents& log);

}  // namespace seamline::study
