#pragma once
#include <string>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// The section "Lab and web"; nothing where all came by one way.
[[nodiscard]] std::string origins_html(const Analysis& analysis);

}  // namespace seamline::analysis
