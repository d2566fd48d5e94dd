#pragma once
#include <optional>
#include <string>

#include "analysis/report/tables/late_tables.h"

namespace seamline::analysis {

/// How the clips were shown, how many trials are marked and what becomes of them: for the notes.
[[nodiscard]] std::string late_sentence(const LateReport& late);

/// The same for a paper, with the largest change of a threshold.
[[nodiscard]] std::string late_method(const LateReport& late);

}  // namespace seamline::analysis
