#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// The thresholds otherwise estimated, corrected for guessing, and with and without those whom a screen
/// names.
[[nodiscard]] std::string checks_html(const Analysis& analysis, const std::vector<Figure>& figures);

}  // namespace seamline::analysis
