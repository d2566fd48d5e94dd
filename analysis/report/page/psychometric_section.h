#pragma once
#include <string>
#include <vector>

#include "analysis/report/figures/figures.h"

namespace seamline::analysis {

/// Functions of right choices with figure, table, warnings; the tracks of adaptive logs.
[[nodiscard]] std::string psychometric_html(const Analysis& analysis, const ReportNumbers& numbers,
                                            const std::vector<Figure>& figures);

}  // namespace seamline::analysis
