#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/log/recovery/log_rows.h"

// Inside the log only: reading what is left of a damaged one.
namespace seamline::study {

/// The rows of each table that could be read.
using SalvagedLog = std::map<std::string, std::vector<LogRow>>;

/// Reads every row that SQLite can still reach: from the front until a page is damaged, from the back, and
/// what lies between by asking for its keys one by one. With several ways to read the file (with and without
/// what is waiting in its write-ahead log; with the pages of the schema made anew where the file's own are
/// damaged) the one that finds most is taken. Works on copies in `scratch`; the damaged files are not
/// touched. Rows are as today's schema version has them, whatever the file's is.
[[nodiscard]] SalvagedLog salvage_log(const std::filesystem::path& damaged,
                                      const std::filesystem::path& scratch);

}  // namespace seamline::study
