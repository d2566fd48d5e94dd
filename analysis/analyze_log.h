#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace seamline::analysis {

/// What `seamline analyze LOG.sqlite --out REPORT` asks for.
struct AnalysisRequest {
  std::filesystem::path log;
  std::filesystem::path report_folder;
  int bootstrap_replicates = 10000;
  std::uint64_t seed = 1;  ///< of the bootstrap; same seed, same intervals, for any number of threads
  bool include_pilot = false;
  int threads = 0;                        ///< 0: as many as the machine has
  double field_of_view_deg = 90;          ///< horizontal, for which thresholds are also stated
  std::filesystem::path frozen = {};      ///< an archive of seamline freeze to compare with; empty: none
  bool exclude_screened = false;          ///< leave out the participants whom a screen names
  bool exclude_inattentive = false;       ///< leave out those whom catch trials name
  bool exclude_uncorrected = false;       ///< leave out those whose vision is neither normal nor corrected
  std::string published = {};             ///< file of published thresholds, or "paper"; empty: none
  double published_margin = 0.5;          ///< within which thresholds agree: octaves, or the level's unit
  std::vector<std::string> compare = {};  ///< fields whose groups are compared (`compare_groups`)
  /// What each curve has of its own: "scale", "criteria", "lapse", "guess_ratings" (AnalysisOptions).
  std::vector<std::string> own = {};
  /// A level at which no seam is to be seen, and how much counts as none (`no_seam_sentences`); both or none.
  std::optional<double> no_seam_at = {}, no_seam_margin = {};
};

struct AnalysisSummary {
  std::string frozen;                 ///< the verdict, and a line each for what deviates; empty: no archive
  std::string table;                  ///< Table 1 from the data beside the paper's, for a terminal
  std::string checks;                 ///< the same thresholds otherwise estimated and with others left out
  std::string sections;               ///< psychometric functions, comparisons, tracks, response times
  std::vector<std::string> notes;     ///< what a reader must know, a sentence each
  std::filesystem::path report_html;  ///< one file that opens offline
};

/// Reads the log, computes everything and writes the report folder: report.html, thresholds.json, report.json
/// with every table, the same tables as CSV files with their data dictionary, methods.txt, figures as SVG.
/// Throws InputError when the log is wrong, nobody in it can be used, gnuplot is missing, or the folder
/// cannot be written or has other things in it; nothing is written before the report is whole.
[[nodiscard]] AnalysisSummary analyze_log(const AnalysisRequest& request);

}  // namespace seamline::analysis
