#pragma once
#include <string>

#include "support/text/csv.h"

namespace seamline {

/// A table as Markdown, columns padded so that it also reads well on a terminal: a header with units, numbers
/// with `digits` significant digits and to the right, an empty cell as a dash.
[[nodiscard]] std::string markdown_table(const CsvTable& table, int digits = 3);

}  // namespace seamline
