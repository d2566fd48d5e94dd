#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/psychometric/intervals/judged_fit.h"

namespace seamline::analysis {

/// The contract of `seamline fit --json` (documentation/reference/psychometric_fit.md): an open end and a
/// value that is not identified are null, with the reason beside it.
[[nodiscard]] std::string fit_json(const JudgedFit& report);

/// Null where there is no finite number.
[[nodiscard]] nlohmann::ordered_json number_or_null(double value);
[[nodiscard]] nlohmann::ordered_json ends_json(const Interval& ci95);

}  // namespace seamline::analysis
