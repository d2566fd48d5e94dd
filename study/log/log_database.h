#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <filesystem>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "study/log/log_schema.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"

// Inside the log only: SQLite does not appear in the headers that others include.
namespace seamline::study {

/// How long to wait for other writers.
inline constexpr int log_patience_ms = 5000;

enum class LogAccess {
  read,  ///< also from a place that cannot be written to
  write,
  alone  ///< for writing, while no other program has the log open, nor can open it
};

/// Opens a database that may be of another hand: nothing in its schema is run (triggers, views, functions),
/// and no value is larger than a log's can be. Throws SQLite::Exception.
[[nodiscard]] SQLite::Database open_warily(const std::filesystem::path& path, int flags,
                                           int patience_ms = log_patience_ms);

/// The real path of the file that was opened.
[[nodiscard]] std::filesystem::path place_of(SQLite::Database& database);

/// Opens a log that exists, of any version since `oldest_log_schema_version`, made durable. Throws InputError
/// (missing, not SQLite, another program's, another schema version, no permission, in use).
[[nodiscard]] SQLite::Database open_log_database(const std::filesystem::path& path, LogAccess access);

enum class EmptyFile { refuse, accept };

/// Throws InputError unless the path is a file that can be a log by its kind, size and place. Never opens it:
/// closing it again would drop the locks that other connections of this process have on it (POSIX).
void check_is_file(const std::filesystem::path& path, EmptyFile empty);

/// Nobody has written anything into the database yet.
[[nodiscard]] bool is_blank(SQLite::Database& database);

/// Throws InputError unless the database is a log of schema version `oldest` to today's, with all its tables
/// and indexes and nothing else: what others wrote into a schema (a trigger, a view, an index of an
/// expression) would run while the log is read or written to.
void check_log_format(SQLite::Database& database, const std::filesystem::path& path,
                      int oldest = oldest_log_schema_version);

/// What `check_log_format` found.
[[nodiscard]] int schema_version_of(SQLite::Database& database);

/// Throws InputError unless every page can be read, every row keeps its table's rules and no row refers to
/// one that is missing. Takes about a second for a million answers.
void check_undamaged(SQLite::Database& database, const std::filesystem::path& path);

/// synchronous=FULL, foreign keys and secure deletion on; all three belong to the connection, not to the
/// file.
void make_durable(SQLite::Database& database);

/// One table or index of a schema: its kind, its name and table, and its SQL (empty for those that SQLite
/// makes by itself).
using SchemaEntry = std::tuple<std::string, std::string, std::string, std::string>;

/// What a database's schema has, and what a log's of a version has. Runs nothing of it.
[[nodiscard]] std::multiset<SchemaEntry> schema_of(SQLite::Database& database);
[[nodiscard]] const std::multiset<SchemaEntry>& log_schema(int version = log_schema_version);

/// What went wrong with the file or the disk, as one sentence about the log; none when it is a mistake of
/// ours.
[[nodiscard]] InputError log_error(const std::filesystem::path& path, const SQLite::Exception& error);
[[nodiscard]] bool is_trouble_outside(const SQLite::Exception& error);

/// A statement that ended because the person asked to stop.
[[nodiscard]] bool is_stopped(const SQLite::Exception& error);

/// Runs `work`; what the disk or the file did wrong becomes an InputError, what the person stopped
/// Interrupted, a mistake of ours stays what it is.
template <class Work>
decltype(auto) with_log_errors(const std::filesystem::path& path, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const SQLite::Exception& error) {
    if (is_stopped(error)) throw Interrupted{};
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

}  // namespace seamline::study
