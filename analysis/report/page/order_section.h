#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Whether answers change during the session, and which participants and objects lie apart.
[[nodiscard]] std::string order_html(const ReportNumbers& numbers, const std::vector<Figure>& figures);

}  // namespace seamline::analysis
