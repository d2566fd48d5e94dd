#include "study/log/recovery/log_upgrade.h"

#include <fmt/core.h>
#include <sqlite3.h>

#include <optional>
#include <variant>

#include "study/log/log_create.h"
#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "study/log/recovery/log_salvage.h"
#include "study/log/recovery/new_log.h"
#include "study/log/session_claims.h"
#include "support/files/temporary_folder.h"
#include "support/text/counted.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

std::string key_of(const LogTable& table) {
  std::string key;
  for (const char* column : table.key) key += (key.empty() ? "" : ", ") + std::string(column);
  return key;
}

SQLite::Statement rows_of(SQLite::Database& database, const LogTable& table) {
  return {database, fmt::format("SELECT * FROM {} ORDER BY {}", table.name, key_of(table))};
}

std::int64_t copy_table(SQLite::Database& from, SQLite::Database& into, const LogTable& table) {
  SQLite::Statement read = rows_of(from, table);
  std::optional<SQLite::Statement> insert;
  std::int64_t rows = 0;
  for (; read.executeStep(); ++rows) {
    stop_if_interrupted();
    const LogRow row = row_of_today(table.name, row_of(read));
    if (!insert) {
      std::string places = "?";
      for (std::size_t i = 1; i < row.size(); ++i) places += ", ?";
      insert.emplace(into, fmt::format("INSERT INTO {} VALUES ({})", table.name, places));
    }
    bind_row(*insert, row);
    insert->exec();
  }
  return rows;
}

/// Reads both, side by side. A difference is a mistake of ours, or of the disk's.
void check_same_rows(SQLite::Database& one, SQLite::Database& other, const LogTable& table,
                     const fs::path& out) {
  SQLite::Statement was = rows_of(one, table), is = rows_of(other, table);
  for (;;) {
    stop_if_interrupted();
    const bool more = was.executeStep();
    if (is.executeStep() == more && (!more || row_of_today(table.name, row_of(was)) == row_of(is))) {
      if (more) continue;
      return;
    }
    throw input_error({.file = out.string(),
                       .field = table.name,
                       .wanted = "the rows of the old log (which is unchanged)",
                       .found = "others"});
  }
}

void check_nobody_is_in_a_session(SQLite::Database& copy, const fs::path& old) {
  for (SQLite::Statement row(copy, "SELECT participant FROM participants"); row.executeStep();)
    if (is_claimed(old, row.getColumn(0).getInt64()))
      throw input_error(
          {.file = old.string(),
           .wanted = "a log in which nobody is in a session (their next answers would be missing)",
           .found = "somebody who is"});
}

/// The copy lies beside the new log: what its disk does not take is no fault of the old one.
template <class Work>
decltype(auto) with_disk_of(const fs::path& out, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode() & 0xff;
    if (code == SQLITE_IOERR || code == SQLITE_FULL) throw log_error(out, error);
    throw;
  }
}

SQLite::Database open_old(const fs::path& copy, const fs::path& old) {
  SQLite::Database database = open_warily(copy, SQLite::OPEN_READWRITE);
  check_log_format(database, old);
  if (const int version = schema_version_of(database); version >= log_schema_version)
    throw input_error({.file = old.string(),
                       .field = "user_version",
                       .wanted = fmt::format("a log of a schema version before {}", log_schema_version),
                       .found = fmt::format("version {}, which needs no upgrade", version)});
  check_undamaged(database, old);
  check_nobody_is_in_a_session(database, old);
  return database;
}

void make_upgraded(SQLite::Database& from, const fs::path& made, const fs::path& out, LogUpgrade& upgrade) {
  const auto fill = [&](SQLite::Database& fresh) {
    for (const LogTable& table : log_tables()) upgrade.rows[table.name] = copy_table(from, fresh, table);
  };
  SQLite::Database into = open_or_create_log_database(made, fill, out);
  check_undamaged(into, out);
  for (const LogTable& table : log_tables()) check_same_rows(from, into, table, out);
  into.exec("PRAGMA journal_mode = DELETE");  // one file, whole; the next session makes it WAL again
}

}  // namespace

LogUpgrade upgrade_log(const fs::path& old, const fs::path& out) {
  check_is_file(old, EmptyFile::refuse);
  check_is_free(out);
  const TemporaryFolder scratch(out);
  const fs::path copy = scratch / "old.sqlite", made = scratch / "new.sqlite";
  copy_log(old, copy);
  LogUpgrade upgrade;
  upgrade.to_version = log_schema_version;
  with_log_errors(old, [&] {
    SQLite::Database from = with_disk_of(out, [&] { return open_old(copy, old); });
    upgrade.from_version = schema_version_of(from);
    with_log_errors(out, [&] { make_upgraded(from, made, out, upgrade); });
  });
  take_name(made, out);
  return upgrade;
}

std::string upgrade_text(const LogUpgrade& upgrade, const fs::path& old, const fs::path& out) {
  return fmt::format(
      "{}: a log of schema version {} with {} and {} became {}, of version {}, row by "
      "row the same; go on in that one\n",
      old.string(), upgrade.from_version, counted(upgrade.rows.at("participants"), "participant"),
      counted(upgrade.rows.at("answers"), "answer"), out.string(), upgrade.to_version);
}

}  // namespace seamline::study
