#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

// Lab and web beside each other, where a log has both; empty otherwise.

/// Lines of a table: artifact, quantity, together, lab, web, web less lab, p, p adjusted.
[[nodiscard]] std::vector<std::vector<std::string>> origin_lines(const Analysis& analysis);
[[nodiscard]] std::vector<std::string> origin_titles(const Analysis& analysis);

/// How many came by which way, and how the difference is tested.
[[nodiscard]] std::string origin_sentence(const Analysis& analysis);

/// The table for the terminal.
[[nodiscard]] std::string origins_text(const Analysis& analysis);

}  // namespace seamline::analysis
