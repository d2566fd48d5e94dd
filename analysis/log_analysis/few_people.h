#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What two to four participants mean for intervals, as a sentence of report and methods text; empty for more
/// people, and for one.
[[nodiscard]] std::string few_people_sentence(const Analysis& analysis);

}  // namespace seamline::analysis
