#pragma once
#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

// Inside the log only: reading what is left of a damaged one.
namespace seamline::study {

/// A value of any table.
using LogValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using LogRow = std::vector<LogValue>;

/// All values of the row that a statement stands at.
[[nodiscard]] LogRow row_of(SQLite::Statement& statement);

/// Tables of the log, parents before the rows that refer to them, with the columns of their keys.
struct LogTable {
  const char* name;
  std::vector<const char*> key;
};
[[nodiscard]] const std::vector<LogTable>& log_tables();

/// The rows of each table that could be read.
using SalvagedLog = std::map<std::string, std::vector<LogRow>>;

/// A row of an older schema version as today's version has it; others as they are. What version 3 added
/// stands at the end of `study` and `stimuli`, and is missing, or NULL where it was read by the words of
/// version 3: the quantity is the depth width, noticeability falls, there is no condition, and the width is
/// the level.
[[nodiscard]] LogRow row_of_today(const std::string& table, LogRow row);

/// Reads every row that SQLite can still reach: from the front until a page is damaged, from the back, and
/// what lies between by asking for its keys one by one. With several ways to read the file (with and without
/// what is waiting in its write-ahead log; with the pages of the schema made anew where the file's own are
/// damaged) the one that finds most is taken. Works on copies in `scratch`; the damaged files are not
/// touched. Rows are as today's schema version has them, whatever the file's is.
[[nodiscard]] SalvagedLog salvage_log(const std::filesystem::path& damaged,
                                      const std::filesystem::path& scratch);

}  // namespace seamline::study
