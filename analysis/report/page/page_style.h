#pragma once

namespace seamline::analysis {

/// The page's style sheet.
[[nodiscard]] const char* page_style();

}  // namespace seamline::analysis
