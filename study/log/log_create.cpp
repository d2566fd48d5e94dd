#include "study/log/log_create.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "study/log/log_place.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

/// Makes an empty file where there is none, so that exactly one program knows that it began the log.
bool begin_file(const fs::path& path, const fs::path& called) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0 && errno == EEXIST) return false;
  if (descriptor < 0)
    throw input_error({.file = called.string(),
                       .wanted = "a place where a log can be written",
                       .found = std::strerror(errno)});
  ::close(descriptor);
  return true;
}

/// Removes what was begun, unless another program has made a log of it meanwhile.
void remove_blank_file(const fs::path& path) {
  try {
    SQLite::Database database = open_warily(path, SQLite::OPEN_READWRITE);
    if (!is_blank(database)) return;
  } catch (const SQLite::Exception&) {
    return;  // not known to be blank: better a useless file than a lost log
  }
  ::unlink(path.c_str());
  ::unlink(journal_file(path).c_str());
}

void create_tables(SQLite::Database& database, const std::function<void(SQLite::Database&)>& fill,
                   int version) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  if (!is_blank(database)) return;  // another program was faster
  database.exec(log_schema_sql(version));
  fill(database);
  transaction.commit();
}

/// Switches to a write-ahead log, which stays with the file. SQLite does not wait by itself for others to let
/// go here.
void use_write_ahead_log(SQLite::Database& database, const fs::path& path) {
  using namespace std::chrono;
  const auto deadline = steady_clock::now() + milliseconds(log_patience_ms);
  for (;;) try {
      if (database.execAndGet("PRAGMA journal_mode = WAL").getString() == "wal") return;
      throw input_error({.file = path.string(),
                         .wanted = "a file system on which SQLite can keep a write-ahead log",
                         .found = "one without shared memory"});
    } catch (const SQLite::Exception& error) {
      if ((error.getErrorCode() & 0xff) != SQLITE_BUSY || steady_clock::now() > deadline) throw;
      std::this_thread::sleep_for(milliseconds(5));
    }
}

SQLite::Database open_or_create(const fs::path& path, const std::function<void(SQLite::Database&)>& fill,
                                const fs::path& called, int version) {
  SQLite::Database database = open_warily(path, SQLite::OPEN_READWRITE);
  make_durable(database);
  if (is_blank(database)) create_tables(database, fill, version);
  check_log_format(database, called, log_schema_version);
  use_write_ahead_log(database, called);  // also for a log whose maker was killed before it came to this
  return database;
}

}  // namespace

bool remove_log_of_nobody(const fs::path& path) {
  try {
    SQLite::Database database = open_log_database(path, LogAccess::alone);
    for (const auto& [kind, name, table, sql] : schema_of(database))
      if (kind == "table" && name != "study" && name != "stimuli" && !name.starts_with("sqlite_") &&
          database.execAndGet(fmt::format("SELECT EXISTS (SELECT 1 FROM {})", name)).getInt() != 0)
        return false;
    for (const fs::path& file : {log_place(path), ahead_file(path), journal_file(path), claims_file(path)})
      ::unlink(file.c_str());
    return true;
  } catch (const InputError&) {
    return false;
  } catch (const SQLite::Exception&) {
    return false;
  }
}

SQLite::Database open_or_create_log_database(const fs::path& path,
                                             const std::function<void(SQLite::Database&)>& fill,
                                             const fs::path& called, int version) {
  const fs::path& name = called.empty() ? path : called;
  const bool begun_here = begin_file(path, name);
  try {
    check_is_file(path, EmptyFile::accept);
    return with_log_errors(name, [&] { return open_or_create(path, fill, name, version); });
  } catch (...) {
    if (begun_here) remove_blank_file(path);
    throw;
  }
}

}  // namespace seamline::study
