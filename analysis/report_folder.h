#pragma once
#include <filesystem>

namespace seamline::analysis {

/// The file of a report folder that names all others, a line each, so that a later report knows them.
inline constexpr const char* report_list_name = "report_files.txt";

/// Throws InputError unless a report may go there: nothing is there, an empty folder, or an earlier report.
void require_report_folder(const std::filesystem::path& folder);

/// Puts the report that was made in `made` into `folder`, with its list. Files of the earlier report that the
/// new one has not are removed, and nothing else is. Throws InputError where it cannot be written.
void renew_report(const std::filesystem::path& folder, const std::filesystem::path& made);

}  // namespace seamline::analysis
