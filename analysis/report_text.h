#pragma once
#include <string>
#include <vector>

#include "analysis/analysis.h"

namespace seamline {

/// Method text that a researcher can quote, a paragraph each, plain text.
[[nodiscard]] std::vector<std::string> method_paragraphs(const Analysis& analysis);

}  // namespace seamline
