#pragma once

namespace seamline::analysis {

/// The page's style sheet.
[[nodiscard]] const char* report_style();

}  // namespace seamline::analysis
