#include "analysis/report_folder.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>

#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace fs = std::filesystem;

namespace {

/// Largest file of a report: a page holds its figures and cut-outs.
constexpr std::int64_t most_bytes = std::int64_t{1} << 31;
constexpr const char* report_page = "report.html";

/// What the list of an earlier report names; lines that lead elsewhere are none of ours.
std::set<std::string> files_of_earlier(const fs::path& folder) {
  std::set<std::string> files;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(folder / report_list_name, error))) return files;
  std::istringstream list(read_file(folder / report_list_name));
  for (std::string line; std::getline(list, line);)
    if (!line.empty() && is_written_below(line)) files.insert(line);
  return files;
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
  if (!fs::is_directory(folder, error)) return;
  const auto is_hidden = [](const auto& entry) { return entry.path().filename().string().starts_with("."); };
  if (std::all_of(fs::directory_iterator(folder, error), {}, is_hidden)) return;
  if (!files_of_earlier(folder).empty()) return;
  const bool is_unlisted =
      fs::exists(folder / report_page, error) && fs::exists(folder / "thresholds.json", error);
  throw input_error(
      {.file = folder.string(),
       .field = request_name("out"),
       .wanted =
           "a new or an empty folder, or one with an earlier report and its " + std::string(report_list_name),
       .found = is_unlisted ? "a report of an earlier version, which has no such list: remove it first"
                            : "a folder with other things in it"});
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
  // Pages come last: stopped midway, a folder has no page rather than an old one over new tables.
  const auto is_page = [](const std::string& file) { return fs::path(file).filename() == report_page; };
  for (const std::string& file : earlier)
    if (is_page(file) || !now.contains(file)) remove_earlier(folder, file);
  for (const bool pages : {false, true})
    for (const std::string& file : now)
      if (is_page(file) == pages) renew(file);
  write_file_atomically(folder / report_list_name, list, Readers::owner);
}

}  // namespace seamline::analysis
