#pragma once
#include <filesystem>
#include <string>

#include "analysis/matching/match_thresholds.h"
#include "support/text/csv.h"

namespace seamline::analysis {

/// The thresholds as a table of text, a line a curve.
[[nodiscard]] std::string match_text(const MatchAnalysis& analysis);

/// `thresholds.csv`, `thresholds_people.csv` and `matches.csv`.
[[nodiscard]] std::vector<CsvTable> match_tables(const MatchAnalysis& analysis);

/// `thresholds.json`: estimates are null where there are none.
[[nodiscard]] std::string matches_json(const MatchAnalysis& analysis);

/// What was done, for a paper: sentences.
[[nodiscard]] std::string match_methods(const MatchAnalysis& analysis);

/// Writes report.html, thresholds.json, methods.txt, the tables with their data dictionary, and a figure of
/// everybody's means. Needs gnuplot. Returns the page's path. Throws InputError when the folder cannot be
/// written.
[[nodiscard]] std::filesystem::path write_match_report(const MatchAnalysis& analysis,
                                                       const std::filesystem::path& folder);

}  // namespace seamline::analysis
