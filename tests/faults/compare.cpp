#include "compare.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

constexpr int patience_ms = 5000;

bool is_temporary(const fs::path& file) {
  return file.filename().string().starts_with(".");
}

bool is_about_the_run(const fs::path& file) {
  return file.filename().string().starts_with("timings") || file.stem() == "errors" ||
         file.filename() == "rendered-with";
}

std::string text_of(SQLite::Statement& row) {
  std::string text;
  for (int column = 0; column < row.getColumnCount(); ++column) {
    const std::string name = row.getColumnName(column);
    if (name.ends_with("_unix_s") || name.ends_with("_ns")) continue;
    text += name + "=" + row.getColumn(column).getString() + " ";
  }
  return text;
}

std::vector<std::string> select(SQLite::Database& database, const std::string& sql,
                                const std::string& table) {
  std::vector<std::string> rows;
  for (SQLite::Statement row(database, sql); row.executeStep();) rows.push_back(table + ": " + text_of(row));
  return rows;
}

/// A second reader must not be what empties a write-ahead log, so it only reads.
SQLite::Database open(const fs::path& log) {
  SQLite::Database database(log.string(), SQLite::OPEN_READWRITE, patience_ms);
  database.exec("PRAGMA query_only = ON");
  return database;
}

}  // namespace

std::string bytes_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

Files files_of(const fs::path& folder) {
  Files files;
  if (!fs::exists(folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !is_temporary(entry.path()) && !is_about_the_run(entry.path()))
      files[fs::relative(entry.path(), folder)] = bytes_of(entry.path());
  return files;
}

int leftovers(const fs::path& folder) {
  int count = 0;
  if (!fs::exists(folder)) return count;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    count += entry.is_regular_file() && is_temporary(entry.path()) ? 1 : 0;
  return count;
}

int files_not_in(const Files& files, const Files& whole) {
  return static_cast<int>(std::count_if(files.begin(), files.end(), [&](const auto& file) {
    const auto found = whole.find(file.first);
    return found == whole.end() || found->second != file.second;
  }));
}

std::vector<std::string> rows_of(const fs::path& log) {
  SQLite::Database database = open(log);
  std::vector<std::string> tables, rows;
  for (SQLite::Statement row(database, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
       row.executeStep();)
    tables.push_back(row.getColumn(0).getString());
  for (const std::string& table : tables) {
    const std::vector<std::string> more = select(database, "SELECT * FROM " + table, table);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::vector<std::string> answers_of(const fs::path& log) {
  std::error_code error;
  if (!fs::exists(log) || fs::file_size(log, error) == 0) return {};
  SQLite::Database database = open(log);
  if (database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) return {};
  return select(
      database,
      "SELECT code, trial_index, stimulus_id, chosen_index, rating FROM answers JOIN trials USING "
      "(participant, trial_index) JOIN stimuli USING (stimulus) JOIN participants USING (participant) "
      "ORDER BY participant, trial_index",
      "answer");
}

std::int64_t missing(std::vector<std::string> some, std::vector<std::string> all) {
  std::sort(some.begin(), some.end());
  std::sort(all.begin(), all.end());
  std::vector<std::string> gone;
  std::set_difference(some.begin(), some.end(), all.begin(), all.end(), std::back_inserter(gone));
  return static_cast<std::int64_t>(gone.size());
}

bool is_sound(const fs::path& log) {
  SQLite::Database database = open(log);
  if (database.execAndGet("PRAGMA integrity_check").getString() != "ok") return false;
  SQLite::Statement orphans(database, "PRAGMA foreign_key_check");
  return !orphans.executeStep();
}

void remove_log(const fs::path& log) {
  for (const char* suffix : {"", "-wal", "-shm", "-lock", "-journal"}) fs::remove(log.string() + suffix);
}

void copy_log(const fs::path& from, const fs::path& to) {
  remove_log(to);
  for (const char* suffix : {"", "-wal"})
    if (fs::exists(from.string() + suffix)) fs::copy_file(from.string() + suffix, to.string() + suffix);
}

}  // namespace seamline::faults
