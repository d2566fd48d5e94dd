#pragma once
#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

// Inside the log only: rows of any table.
namespace seamline::study {

/// A value of any table.
using LogValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using LogRow = std::vector<LogValue>;

/// All values of the row that a statement stands at.
[[nodiscard]] LogRow row_of(SQLite::Statement& statement);

/// Binds a row's values to a statement that is about to run again.
void bind_row(SQLite::Statement& statement, const LogRow& row);

/// Tables of the log, parents before the rows that refer to them, with the columns of their keys.
struct LogTable {
  const char* name;
  std::vector<const char*> key;
};
[[nodiscard]] const std::vector<LogTable>& log_tables();

/// The tables of people in browsers, which only some versions have (`has_online_tables`); after the others.
[[nodiscard]] const std::vector<LogTable>& online_log_tables();

/// Both, or the first alone.
[[nodiscard]] std::vector<LogTable> log_tables_with(bool online);

/// A row of an older schema version as today's version has it; others as they are. What version 3 added
/// stands at the end of `study` and `stimuli`, and is missing, or NULL where it was read by the words of
/// version 3: the quantity is the depth width, noticeability falls, there is no condition, and the width is
/// the level.
[[nodiscard]] LogRow row_of_today(const std::string& table, LogRow row);

}  // namespace seamline::study
