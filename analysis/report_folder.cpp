#include "analysis/report_folder.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "analysis/report/json/thresholds_json.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace fs = std::filesystem;

namespace {

/// Largest file of a report: a page holds its figures and cut-outs.
constexpr std::int64_t most_bytes = std::int64_t{1} << 31;
constexpr const char* report_page = "report.html";

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(path, error));
}

/// What the list of an earlier report names; lines that lead elsewhere are none of ours.
std::set<std::string> listed_files(const fs::path& folder) {
  std::set<std::string> files;
  if (!is_file(folder / report_list_name)) return files;
  std::istringstream list(read_file(folder / report_list_name));
  for (std::string line; std::getline(list, line);)
    if (!line.empty() && is_written_below(line)) files.insert(line);
  return files;
}

bool has_our_thresholds(const fs::path& folder) {
  if (!is_file(folder / "report.html") || !is_file(folder / "thresholds.json")) return false;
  const auto json = nlohmann::json::parse(read_file(folder / "thresholds.json", most_bytes), nullptr,
                                          /*allow_exceptions=*/false);
  const auto begins = [&](const char* key, const char* word) {
    const auto value = json.find(key);
    return value != json.end() && value->is_string() &&
           value->get_ref<const std::string&>().starts_with(word);
  };
  return begins("format", thresholds_format) || begins("software", "Seamline ");  // the second: of matches
}

/// Names that a report's dictionary explains: its tables.
std::set<std::string> tables_of_dictionary(const fs::path& folder) {
  std::set<std::string> names;
  if (!is_file(folder / "data_dictionary.csv")) return names;
  std::istringstream rows(read_file(folder / "data_dictionary.csv"));
  for (std::string row; std::getline(rows, row);) names.insert(row.substr(0, row.find(',')));
  return names;
}

/// A figure is there as two pictures and the script that drew them.
bool is_whole_figure(const fs::path& path) {
  const auto is_there = [&](const char* ending) { return is_file(fs::path(path).replace_extension(ending)); };
  const bool known =
      path.extension() == ".svg" || path.extension() == ".pdf" || path.extension() == ".gnuplot";
  return known && is_there("svg") && is_there("pdf") && is_there("gnuplot");
}

/// A report without a list, as versions before it made them: its files, and the first thing in its folder
/// that such a report has not. Its tasks are reports in folders of their own.
struct UnlistedReport {
  std::set<std::string> files;
  std::string foreign;
};

UnlistedReport unlisted_report(const fs::path& folder) {
  UnlistedReport report;
  const bool ours = has_our_thresholds(folder);
  std::set<std::string> known = tables_of_dictionary(folder);
  known.insert({"report.html", "report.json", "thresholds.json", "methods.txt", "data_dictionary.csv"});
  std::set<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder)) entries.insert(entry.path());
  const auto add = [&](const fs::path& file, bool belongs) {
    const std::string name = file.lexically_relative(folder).generic_string();
    if (belongs)
      report.files.insert(name);
    else if (report.foreign.empty())
      report.foreign = name;
  };
  for (const fs::path& path : entries) {
    const std::string name = path.filename().string();
    if (name.starts_with(".")) continue;  // a version control's, a mount's, a write that was stopped
    if (!fs::is_directory(fs::symlink_status(path))) {
      add(path, ours && is_file(path) && known.contains(name));
    } else if (name == "figures") {
      for (const auto& figure : fs::directory_iterator(path))
        add(figure.path(), ours && is_file(figure.path()) && is_whole_figure(figure.path()));
    } else {
      const UnlistedReport task = ours ? unlisted_report(path) : UnlistedReport{.files = {}, .foreign = "."};
      for (const std::string& file : task.files) report.files.insert(name + "/" + file);
      if (!task.foreign.empty()) add(path, false);
    }
  }
  return report;
}

std::set<std::string> files_of_earlier(const fs::path& folder) {
  if (std::set<std::string> listed = listed_files(folder); !listed.empty()) return listed;
  const UnlistedReport report = unlisted_report(folder);
  return report.foreign.empty() ? report.files : std::set<std::string>();
}

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(folder).generic_string());
  return files;
}

/// Its folder goes as well where nothing else is in it.
void remove_earlier(const fs::path& folder, const std::string& file) {
  const fs::path path = folder / file;
  std::error_code error;
  if (!lies_below(path, folder) || !fs::is_regular_file(fs::symlink_status(path, error))) return;
  fs::remove(path, error);
  for (fs::path parent = path.parent_path(); parent != folder && fs::is_empty(parent, error) && !error;
       parent = parent.parent_path())
    if (!fs::remove(parent, error)) return;
}

}  // namespace

void require_report_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error) || fs::is_empty(folder, error) || error) return;
  if (!listed_files(folder).empty()) return;
  const std::string foreign = unlisted_report(folder).foreign;
  if (foreign.empty()) return;
  throw input_error(
      {.file = folder.string(),
       .field = request_name("out"),
       .wanted = "a new or an empty folder, or one that holds an earlier report and nothing else",
       .found = "a folder with other things in it, such as " + printable(foreign)});
}

void renew_report(const fs::path& folder, const fs::path& made) {
  prepare_output_folder(folder);
  const std::set<std::string> earlier = files_of_earlier(folder), now = files_below(made);
  std::string list;
  for (const std::string& file : now) list += file + "\n";
  std::set<std::string> both = earlier;
  both.insert(now.begin(), now.end());
  std::string all;
  for (const std::string& file : both) all += file + "\n";
  write_file_atomically(folder / report_list_name, all, Readers::owner);  // holds if this one is interrupted
  const auto renew = [&](const std::string& file) {
    prepare_output_folder((folder / file).parent_path());
    write_file_atomically(folder / file, read_file(made / file, most_bytes), Readers::owner);
  };
  // The page comes last: stopped midway, a folder has no page rather than an old one over new tables.
  if (now.contains(report_page) && earlier.contains(report_page)) remove_earlier(folder, report_page);
  for (const std::string& file : now)
    if (file != report_page) renew(file);
  for (const std::string& file : earlier)
    if (!now.contains(file)) remove_earlier(folder, file);
  if (now.contains(report_page)) renew(report_page);
  write_file_atomically(folder / report_list_name, list, Readers::owner);
}

}  // namespace seamline::analysis
