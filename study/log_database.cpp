#include "study/log_database.h"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>

namespace seamline {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t header_bytes = 100;  // of a SQLite database
constexpr const char* a_log = "a Seamline log";
const std::string saving = "(`seamline log LOG --recover OUT` saves what can be read)";

InputError damaged(const fs::path& path, std::string found) {
  std::replace(found.begin(), found.end(), '\n', ' ');
  return input_error({.file = path.string(), .wanted = "an undamaged log " + saving, .found = found});
}

fs::path beside(const fs::path& path, const char* suffix) {
  return path.string() + suffix;
}

/// Whether every table and index of the schema is there as it is written. Others beside them do no harm.
bool has_schema(SQLite::Database& database) {
  SQLite::Database model(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  model.exec(log_schema_sql());
  SQLite::Statement wanted(model, "SELECT name, sql FROM sqlite_schema WHERE sql IS NOT NULL");
  SQLite::Statement found(database, "SELECT count(*) FROM sqlite_schema WHERE name = ? AND sql = ?");
  while (wanted.executeStep()) {
    found.tryReset();
    SQLite::bind(found, wanted.getColumn(0).getString(), wanted.getColumn(1).getString());
    found.executeStep();
    if (found.getColumn(0).getInt() != 1) return false;
  }
  return true;
}

SQLite::Database open_for_writing(const fs::path& path, int wait_ms, bool alone) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, wait_ms);
  if (alone) database.exec("PRAGMA locking_mode = EXCLUSIVE");  // before the first read
  check_log_format(database, path);
  make_durable(database);
  return database;
}

/// A path as SQLite reads it in a URI.
std::string uri_of(const fs::path& path) {
  std::string uri = "file:";
  for (const char letter : fs::absolute(path).string())
    uri += letter == '?' || letter == '#' || letter == '%'
               ? fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(letter)))
               : std::string(1, letter);
  return uri;
}

/// Reading a log in WAL mode needs the -shm file beside it, even when nobody writes. Where none can be made
/// (an archive, a read-only disk) and no -wal file holds anything, the file itself is the whole log and
/// cannot change.
SQLite::Database open_for_reading(const fs::path& path) {
  try {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, log_patience_ms);
    database.exec("PRAGMA query_only = ON");
    check_log_format(database, path);
    return database;
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode() & 0xff;
    std::error_code error_code;
    const auto pending_bytes = fs::file_size(beside(path, "-wal"), error_code);
    const bool nothing_pending = error_code || pending_bytes == 0;
    if ((code != SQLITE_CANTOPEN && code != SQLITE_READONLY) || !nothing_pending) throw;
  }
  SQLite::Database database(uri_of(path) + "?immutable=1", SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  check_log_format(database, path);
  return database;
}

}  // namespace

void check_is_file(const fs::path& path, EmptyFile empty) {
  std::error_code error;
  const auto complaint = [&](const std::string& found) {
    return input_error({.file = path.string(), .wanted = a_log, .found = found});
  };
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw complaint("no such file");
  if (error) throw complaint(error.message());
  if (!fs::is_regular_file(status)) throw complaint("something that is not a file");
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (bytes == 0 && empty == EmptyFile::refuse) throw complaint("an empty file");
  if (bytes > 0 && bytes < header_bytes)
    throw complaint("a file that is not SQLite");  // SQLite overwrites one byte
}

bool is_blank(SQLite::Database& database) {
  return database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0 &&
         database.execAndGet("PRAGMA application_id").getInt() == 0;
}

void check_log_format(SQLite::Database& database, const fs::path& path) {
  if (database.execAndGet("PRAGMA application_id").getInt() != log_application_id)
    throw input_error({.file = path.string(), .wanted = a_log, .found = "another SQLite database"});
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (version != log_schema_version)
    throw input_error(
        {.file = path.string(),
         .field = "user_version",
         .wanted = fmt::format("a log of schema version {}", log_schema_version),
         .found = fmt::format("version {} ({})", version,
                              version < log_schema_version
                                  ? "written by an older seamline: go on with that one, or begin "
                                    "a new log; nothing in it was changed"
                                  : "written by a newer seamline: use that one")});
  if (!has_schema(database))
    throw input_error(
        {.file = path.string(),
         .wanted = fmt::format("the tables of schema version {} {}", log_schema_version, saving),
         .found = "other tables"});
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

bool is_trouble_outside(const SQLite::Exception& error) {
  switch (error.getErrorCode() & 0xff) {
    case SQLITE_PERM:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_READONLY:
    case SQLITE_IOERR:
    case SQLITE_CORRUPT:
    case SQLITE_FULL:
    case SQLITE_CANTOPEN:
    case SQLITE_PROTOCOL:
    case SQLITE_NOTADB:
      return true;
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

}  // namespace seamline
