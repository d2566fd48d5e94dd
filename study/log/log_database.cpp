#include "study/log/log_database.h"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

#include "study/log/log_place.h"
#include "support/files/temporary_folder.h"
#include "support/text/limits.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t header_bytes = 100;  // of a SQLite database
constexpr const char* a_log = "a Seamline log";
const std::string saving = "(`seamline log recover LOG OUT` saves what can be read)";

InputError damaged(const fs::path& path, std::string found) {
  std::replace(found.begin(), found.end(), '\n', ' ');
  return input_error({.file = path.string(), .wanted = "an undamaged log " + saving, .found = found});
}

/// In a few words what of a schema is not ours; empty: it is ours exactly. Names in it are somebody else's
/// and are not repeated.
std::string other_than_ours(SQLite::Database& database, int version) {
  const std::multiset<SchemaEntry> found = schema_of(database);
  const std::multiset<SchemaEntry>& ours = log_schema(version);
  std::vector<SchemaEntry> missing, foreign;
  std::set_difference(ours.begin(), ours.end(), found.begin(), found.end(), std::back_inserter(missing));
  std::set_difference(found.begin(), found.end(), ours.begin(), ours.end(), std::back_inserter(foreign));
  if (!missing.empty()) return "other tables";
  if (foreign.empty()) return "";
  for (const char* kind : {"trigger", "view", "index"})
    for (const SchemaEntry& entry : foreign)
      if (std::get<0>(entry) == kind) return fmt::format("also something that is not: a {}", kind);
  return "also something that is not: a table";
}

/// What to do with a log of a version that does not serve.
const char* advice_for(int version) {
  if (version > newest_log_schema_version) return "written by a newer seamline: use that one";
  if (version >= oldest_log_schema_version)
    return "written by an older seamline: `seamline log upgrade LOG NEW` makes a log of it that sessions "
           "go on in, with every answer; nothing in this one was changed";
  return "written by an older seamline: go on with that one, or begin a new log; nothing in it was changed";
}

SQLite::Database open_for_writing(const fs::path& path, int wait_ms, bool alone) {
  SQLite::Database database = open_warily(path, SQLite::OPEN_READWRITE, wait_ms);
  if (alone) database.exec("PRAGMA locking_mode = EXCLUSIVE");  // before the first read
  check_log_format(database, path);
  make_durable(database);
  return database;
}

/// A long statement ends when the person asks to stop; `with_log_errors` then throws Interrupted.
void let_signals_stop(SQLite::Database& database) {
  constexpr int steps_between = 10000;
  sqlite3_progress_handler(
      database.getHandle(), steps_between, [](void*) { return interrupted() ? 1 : 0; }, nullptr);
}

/// Reading a log in WAL mode needs the -shm file beside it, even when nobody writes. Where none can be made
/// (an archive, a read-only disk, somebody else's folder) a copy is read, with all that waits in its
/// write-ahead log. The copy's name is gone when this returns; the open file goes with the database.
SQLite::Database open_copy_for_reading(const fs::path& path) {
  const TemporaryFolder folder;
  const fs::path copy = folder / "log.sqlite";
  copy_log(path, copy);
  SQLite::Database database = open_warily(copy, SQLite::OPEN_READWRITE);
  let_signals_stop(database);
  check_log_format(database, path);
  database.exec("PRAGMA locking_mode = EXCLUSIVE");
  if (database.execAndGet("PRAGMA journal_mode = DELETE").getString() != "delete")  // one file, whole
    throw input_error(
        {.file = path.string(), .wanted = "a log whose write-ahead log can be read", .found = "another one"});
  database.exec("PRAGMA query_only = ON");
  return database;
}

SQLite::Database open_for_reading(const fs::path& path) {
  try {
    SQLite::Database database = open_warily(path, SQLite::OPEN_READWRITE);
    let_signals_stop(database);
    database.exec("PRAGMA query_only = ON");
    check_log_format(database, path);
    return database;
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode() & 0xff;
    if (code != SQLITE_CANTOPEN && code != SQLITE_READONLY) throw;
  }
  return open_copy_for_reading(path);
}

}  // namespace

SQLite::Database open_warily(const fs::path& path, int flags, int patience_ms) {
  SQLite::Database database(path.string(), flags, patience_ms);
  sqlite3* handle = database.getHandle();
  for (const auto& [option, value] :
       {std::pair(SQLITE_DBCONFIG_DEFENSIVE, 1), std::pair(SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0),
        std::pair(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0), std::pair(SQLITE_DBCONFIG_ENABLE_VIEW, 0)})
    sqlite3_db_config(handle, option, value, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, limits::largest_log_value_bytes);
  sqlite3_limit(handle, SQLITE_LIMIT_SQL_LENGTH, limits::largest_log_sql_bytes);
  return database;
}

fs::path place_of(SQLite::Database& database) {
  return sqlite3_db_filename(database.getHandle(), "main");
}

std::multiset<SchemaEntry> schema_of(SQLite::Database& database) {
  std::multiset<SchemaEntry> entries;
  SQLite::Statement row(database, "SELECT type, name, tbl_name, coalesce(sql, '') FROM sqlite_schema");
  while (row.executeStep() && entries.size() <= limits::most_schema_entries)
    entries.emplace(row.getColumn(0).getString(), row.getColumn(1).getString(), row.getColumn(2).getString(),
                    row.getColumn(3).getString());
  return entries;
}

const std::multiset<SchemaEntry>& log_schema(int version) {
  static const std::map<int, std::multiset<SchemaEntry>> ours = [] {
    std::map<int, std::multiset<SchemaEntry>> schemas;
    for (int known = oldest_log_schema_version; known <= newest_log_schema_version; ++known) {
      SQLite::Database model(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      model.exec(log_schema_sql(known));
      schemas[known] = schema_of(model);
    }
    return schemas;
  }();
  return ours.at(version);
}

void check_is_file(const fs::path& path, EmptyFile empty) {
  std::error_code error;
  const auto complaint = [&](const std::string& found) {
    return input_error({.file = path.string(), .wanted = a_log, .found = found});
  };
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw complaint("no such file");
  if (error) throw complaint(error.message());
  if (!fs::is_regular_file(status)) throw complaint("something that is not a file");
  check_one_place(path);
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (bytes == 0 && empty == EmptyFile::refuse) throw complaint("an empty file");
  if (bytes > 0 && bytes < header_bytes)
    throw complaint("a file that is not SQLite");  // SQLite overwrites one byte
}

bool is_blank(SQLite::Database& database) {
  return database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0 &&
         database.execAndGet("PRAGMA application_id").getInt() == 0;
}

int schema_version_of(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt();
}

void check_log_format(SQLite::Database& database, const fs::path& path, int oldest) {
  if (database.execAndGet("PRAGMA application_id").getInt() != log_application_id)
    throw input_error({.file = path.string(), .wanted = a_log, .found = "another SQLite database"});
  const int version = schema_version_of(database);
  if (version < oldest || version > newest_log_schema_version)
    throw input_error({.file = path.string(),
                       .field = "user_version",
                       .wanted = fmt::format("a log of schema version {}", log_schema_version),
                       .found = fmt::format("version {} ({})", version, advice_for(version))});
  if (const std::string found = other_than_ours(database, version); !found.empty())
    throw input_error(
        {.file = path.string(),
         .wanted = fmt::format("the tables of schema version {} and nothing else {}", version, saving),
         .found = found});
}

void check_undamaged(SQLite::Database& database, const fs::path& path) {
  const std::string found = database.execAndGet("PRAGMA integrity_check(1)").getString();
  if (found != "ok") throw damaged(path, found);
  SQLite::Statement orphan(database, "PRAGMA foreign_key_check");
  if (orphan.executeStep())
    throw damaged(path, "a row of " + orphan.getColumn(0).getString() + " that refers to a missing one of " +
                            orphan.getColumn(2).getString());
}

void make_durable(SQLite::Database& database) {
  database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON; PRAGMA secure_delete = ON;");
}

SQLite::Database open_log_database(const fs::path& path, LogAccess access) {
  check_is_file(path, EmptyFile::refuse);
  return with_log_errors(path, [&] {
    switch (access) {
      case LogAccess::read:
        return open_for_reading(path);
      case LogAccess::write:
        return open_for_writing(path, log_patience_ms, false);
      case LogAccess::alone:
        break;
    }
    return open_for_writing(path, log_patience_ms / 10, true);  // a session will not end soon
  });
}

bool is_stopped(const SQLite::Exception& error) {
  return (error.getErrorCode() & 0xff) == SQLITE_INTERRUPT && interrupted();
}

bool is_trouble_outside(const SQLite::Exception& error) {
  switch (error.getErrorCode() & 0xff) {
    case SQLITE_PERM:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_READONLY:
    case SQLITE_IOERR:
    case SQLITE_CORRUPT:
    case SQLITE_TOOBIG:
    case SQLITE_FULL:
    case SQLITE_CANTOPEN:
    case SQLITE_PROTOCOL:
    case SQLITE_NOTADB:
      return true;
    case SQLITE_ERROR:  // mistakes in our own SQL, but for a file whose header names a schema of the future
      return std::string_view(error.what()) == "unsupported file format";
    default:
      return false;
  }
}

InputError log_error(const fs::path& path, const SQLite::Exception& error) {
  const auto complaint = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = path.string(), .wanted = wanted, .found = found});
  };
  switch (error.getErrorCode() & 0xff) {
    case SQLITE_NOTADB:
      return complaint(a_log + (", or a damaged one " + saving), "a file that is not SQLite");
    case SQLITE_PERM:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      return complaint("a log, in a folder, that can both be written to", error.what());
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return complaint("a log that no other program has in use", error.what());
    case SQLITE_FULL:
      return complaint("room for the log (every answer stored before is kept)", "a full disk");
    case SQLITE_IOERR:
      return complaint("a disk that takes what is written to it (every answer stored before is kept)",
                       std::string(error.what()) + ": the disk is full, files may not grow, or it is broken");
    default:
      return damaged(path, error.what());
  }
}

}  // namespace seamline::study
