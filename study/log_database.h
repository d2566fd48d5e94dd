#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <filesystem>
#include <utility>

#include "stimuli/support/error.h"

// Inside the log only: SQLite does not appear in the headers that others include.
namespace seamline {

/// The log's format: a SQLite database with this application_id and, in user_version, this schema version.
/// Raise the version with every change of the tables in log_schema.cpp. Version 1 is the first.
inline constexpr int log_application_id = 0x5345414d;  // "SEAM"
inline constexpr int log_schema_version = 1;

enum class LogAccess {
  read,   ///< an existing log; also from a place that cannot be written to
  write,  ///< an existing log
  alone,  ///< an existing log that no other program has open, nor can open meanwhile
  create  ///< an existing log, or a new one where there is no file or an empty one
};

/// Opens a log: WAL, synchronous=FULL, foreign keys and secure deletion on, five seconds of patience with
/// other writers. Throws InputError (missing, not SQLite, another program's, another schema version, no
/// permission); a file that was begun here is removed again then.
[[nodiscard]] SQLite::Database open_log_database(const std::filesystem::path& path, LogAccess access);

/// The tables of schema version `log_schema_version`, as SQL.
[[nodiscard]] std::string log_schema_sql();

/// What went wrong with the file or the disk, as one sentence about the log; none when it is a mistake of
/// ours.
[[nodiscard]] InputError log_error(const std::filesystem::path& path, const SQLite::Exception& error);
[[nodiscard]] bool is_trouble_outside(const SQLite::Exception& error);

/// Runs `work`; what the disk or the file did wrong becomes an InputError, a mistake of ours stays what it
/// is.
template <class Work>
decltype(auto) with_log_errors(const std::filesystem::path& path, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const SQLite::Exception& error) {
    if (!is_trouble_outside(error)) throw;
    throw log_error(path, error);
  }
}

/// Binds the values in order and runs a statement that returns no rows.
template <class... Values>
void run(SQLite::Statement& statement, const Values&... values) {
  statement.tryReset();
  SQLite::bind(statement, values...);
  statement.exec();
  statement.tryReset();
}

}  // namespace seamline
