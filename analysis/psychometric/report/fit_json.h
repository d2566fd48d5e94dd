#pragma once
#include <string>

#include "analysis/psychometric/intervals/judged_fit.h"

namespace seamline::analysis {

/// The contract of `seamline fit --json` (documentation/psychometric_fit.md): an open end and a value that is
/// not identified are null, with the reason beside it.
[[nodiscard]] std::string fit_json(const JudgedFit& report);

}  // namespace seamline::analysis
