#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::analysis {

/// The report of one task of a study, in a folder of its own.
struct TaskReport {
  std::string folder;                   ///< below that of the whole
  std::string question;                 ///< what its trials asked
  std::vector<std::string> conditions;  ///< that ask it
  std::string table;                    ///< its thresholds, for a terminal
};

/// Writes the pages over the reports of a study's tasks: `report.html`, which leads to each, and
/// `thresholds.json`, which holds `thresholds.json` of each as it is. Returns the page.
std::filesystem::path write_tasks_page(const std::filesystem::path& folder, const std::string& study_name,
                                       const std::vector<TaskReport>& reports);

}  // namespace seamline::analysis
