#pragma once
#include <string>

#include "analysis/psychometric/intervals/judged_fit.h"

namespace seamline::analysis {

/// A judged fit as tables for a terminal.
[[nodiscard]] std::string fit_text(const JudgedFit& report);

}  // namespace seamline::analysis
