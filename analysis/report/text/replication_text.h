#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// Titles and cells of the table of published thresholds, for terminal and page alike.
[[nodiscard]] std::vector<std::string> replication_titles(const Analysis& analysis);
[[nodiscard]] std::vector<std::vector<std::string>> replication_lines(const Analysis& analysis);

/// How many agree, differ and are undecided, and the published orders, a sentence each.
[[nodiscard]] std::vector<std::string> replication_sentences(const Analysis& analysis);

/// How it was compared, for a paper; empty where nothing was.
[[nodiscard]] std::string replication_method(const Analysis& analysis);

/// For a terminal; empty where nothing was compared.
[[nodiscard]] std::string replication_text(const Analysis& analysis);

}  // namespace seamline::analysis
