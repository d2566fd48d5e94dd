#include "study/log/recovery/log_salvage.h"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <optional>
#include <set>

#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t most_keys_asked = 2000000;
constexpr std::size_t page_size_at = 16, page_count_at = 28, change_counter_at = 24, valid_for_at = 92;

SQLite::Database open_to_salvage(const fs::path& copy) {
  SQLite::Database database = open_warily(copy, SQLite::OPEN_READWRITE);
  sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
  database.exec("PRAGMA writable_schema = ON");  // a file that was cut short is read as far as it goes
  return database;
}

/// Reads one table of a damaged database.
class TableReader {
 public:
  /// A table has fewer rows than its file has bytes; pages that lead back to one another seem to have more.
  TableReader(SQLite::Database& database, const LogTable& table, std::uintmax_t most_rows)
      : database_(database), table_(table), most_rows_(most_rows) {
    for (const char* column : table.key) key_ += (key_.empty() ? "" : ", ") + std::string(column);
  }

  std::vector<LogRow> read() {
    whole_ = scan("");
    if (!whole_) {
      scan(" DESC");
      ask_for_keys_between();
    }
    std::vector<LogRow> rows;
    for (auto& [key, row] : rows_) rows.push_back(row_of_today(table_.name, std::move(row)));
    return rows;
  }

  [[nodiscard]] bool whole() const { return whole_; }  ///< no page of it was damaged

 private:
  /// From one end until the end or a damaged page; true when the whole table was read.
  bool scan(const std::string& direction) {
    try {
      std::string order;
      for (const char* column : table_.key) order += (order.empty() ? "" : ", ") + (column + direction);
      SQLite::Statement statement(
          database_, fmt::format("SELECT {}, * FROM {} NOT INDEXED ORDER BY {}", key_, table_.name, order));
      for (std::uintmax_t rows = 0; statement.executeStep(); ++rows) {
        if (rows == most_rows_) return false;
        keep(row_of(statement));
      }
      return true;
    } catch (const SQLite::Exception&) {
      return false;
    }
  }

  void keep(LogRow row) {
    stop_if_interrupted();
    const auto end_of_key = row.begin() + table_.key.size();
    LogRow key(row.begin(), end_of_key);
    row.erase(row.begin(), end_of_key);
    rows_.emplace(std::move(key), std::move(row));
  }

  /// Keys are small whole numbers, so the ones between those found can be asked for. Text keys cannot.
  void ask_for_keys_between() {
    if (rows_.empty()) return;  // its first page is lost, or it is empty
    std::vector<std::int64_t> highest(table_.key.size(), 0);
    for (const auto& [key, row] : rows_)
      for (std::size_t i = 0; i < key.size(); ++i) {
        const auto* number = std::get_if<std::int64_t>(&key[i]);
        if (number == nullptr) return;
        highest[i] = std::max(highest[i], *number);
      }
    std::int64_t keys = 1;
    for (std::int64_t& last : highest) {
      last += highest_beyond;
      if (last >= most_keys_asked || (keys *= last + 1) > most_keys_asked) return;
    }
    std::vector<std::int64_t> key(highest.size(), 0);
    for (std::int64_t number = 0; number < keys; ++number) {
      std::int64_t remainder = number;
      for (std::size_t i = key.size(); i-- > 0; remainder /= highest[i] + 1)
        key[i] = remainder % (highest[i] + 1);
      ask(key);
    }
  }

  void ask(const std::vector<std::int64_t>& key) {
    stop_if_interrupted();
    if (rows_.contains(LogRow(key.begin(), key.end()))) return;
    try {
      std::string where;
      for (const char* column : table_.key)
        where += fmt::format("{}{} = ?", where.empty() ? "" : " AND ", column);
      if (!one_)
        one_.emplace(database_, fmt::format("SELECT {}, * FROM {} WHERE {}", key_, table_.name, where));
      one_->tryReset();
      for (std::size_t i = 0; i < key.size(); ++i) one_->bind(static_cast<int>(i) + 1, key[i]);
      if (one_->executeStep()) keep(row_of(*one_));
    } catch (const SQLite::Exception&) {
      one_.reset();  // on a damaged page
    }
  }

  static constexpr std::int64_t highest_beyond = 64;  ///< keys asked for beyond the highest one found
  SQLite::Database& database_;
  const LogTable& table_;
  std::uintmax_t most_rows_ = 0;
  std::string key_;
  std::map<LogRow, LogRow> rows_;
  std::optional<SQLite::Statement> one_;
  bool whole_ = false;
};

/// Puts our words into the place of a schema that is not ours, so that nothing of it is ever run: columns
/// that are computed, views in the place of tables. Of each of our tables the pages are kept; triggers, and
/// tables and indexes of others, are no longer known. A schema that cannot be read stays as it is: it is a
/// damaged one. The words are those of today's version: rows of an older one have NULL in the columns that
/// came later.
void make_schema_ours(const fs::path& copy) {
  SQLite::Database database = open_to_salvage(copy);
  try {
    const std::multiset<SchemaEntry> found = schema_of(database);
    for (int version = oldest_log_schema_version; version <= newest_log_schema_version; ++version)
      if (found == log_schema(version)) return;
  } catch (const SQLite::Exception&) {
    return;
  }
  SQLite::Transaction transaction(database);
  SQLite::Statement rename(
      database, "UPDATE sqlite_schema SET tbl_name = name, sql = ? WHERE type = 'table' AND name = ?");
  SQLite::Statement forget(database, "DELETE FROM sqlite_schema WHERE rowid = ?");
  std::set<std::string> tables, indexes;
  for (const auto& [type, name, table, sql] : log_schema(newest_log_schema_version)) {
    if (type == "table") run(rename, sql, name);
    (type == "table" ? tables : indexes).insert(name);
  }
  std::vector<std::int64_t> foreign;
  for (SQLite::Statement row(database, "SELECT rowid, type, name, coalesce(sql, '') FROM sqlite_schema");
       row.executeStep();) {
    const std::string type = row.getColumn(1).getString(), name = row.getColumn(2).getString();
    const bool ours = (type == "table" && tables.contains(name)) ||
                      (type == "index" && indexes.contains(name) && row.getColumn(3).getString().empty());
    if (!ours) foreign.push_back(row.getColumn(0).getInt64());
  }
  for (const std::int64_t entry : foreign) run(forget, entry);
  transaction.commit();
}

bool knows_browsers(SQLite::Database& database) {
  SQLite::Statement row(database, "SELECT 1 FROM sqlite_schema WHERE name = 'online_participants'");
  return row.executeStep();
}

/// What one way to read a file finds.
struct Reading {
  SalvagedLog log;
  bool whole = false;  ///< no table met a damaged page
};

Reading read_all(const fs::path& copy) {
  Reading reading;
  try {
    make_schema_ours(copy);
    SQLite::Database database = open_to_salvage(copy);
    reading.whole = true;
    for (const LogTable& table : log_tables_with(knows_browsers(database))) {
      TableReader reader(database, table, fs::file_size(copy));
      reading.log[table.name] = reader.read();
      reading.whole = reading.whole && reader.whole();
    }
  } catch (const SQLite::Exception&) {
    reading.whole = false;  // not even its first page can be read
  }
  return reading;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

/// Puts a new log's schema into a file: header, and every page that says what tables there are and where they
/// begin. Tables begin at the same pages in every log of a schema version that nobody was deleted from.
void renew_schema(const fs::path& copy, const fs::path& scratch, int version) {
  const fs::path model = scratch / fmt::format("model-{}.sqlite", version);
  std::set<std::uint32_t> roots;  // of tables and indexes: in an empty log the other pages are the schema's
  if (!fs::exists(model)) {
    SQLite::Database database(model.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec(log_schema_sql(version));
  }
  {
    SQLite::Database database(model.string(), SQLite::OPEN_READONLY);
    for (SQLite::Statement row(database, "SELECT rootpage FROM sqlite_schema"); row.executeStep();)
      roots.insert(row.getColumn(0).getUInt());
  }
  std::string bytes = read_file(model),
              damaged = read_file(copy, static_cast<std::int64_t>(fs::file_size(copy)));
  const std::uint32_t page_bytes = big_endian(bytes, page_size_at, 2);
  const std::uint64_t pages = damaged.size() / page_bytes;
  for (std::size_t i = 0; i < 4; ++i)
    bytes[page_count_at + i] = static_cast<char>(pages >> (24 - 8 * i) & 255);
  for (std::size_t i = 0; i < 4; ++i) bytes[valid_for_at + i] = bytes[change_counter_at + i];
  for (std::uint32_t page = 1; page <= std::min<std::uint64_t>(bytes.size() / page_bytes, pages); ++page)
    if (!roots.contains(page))
      damaged.replace(std::size_t{page - 1} * page_bytes, page_bytes, bytes,
                      std::size_t{page - 1} * page_bytes, page_bytes);
  write_file_atomically(copy, damaged);
}

std::size_t rows_in(const SalvagedLog& log, const std::string& table) {
  const auto found = log.find(table);
  return found == log.end() ? 0 : found->second.size();
}

std::size_t rows_in(const SalvagedLog& log) {
  std::size_t rows = 0;
  for (const auto& [name, of_table] : log) rows += of_table.size();
  return rows;
}

bool is_better(const SalvagedLog& one, const SalvagedLog& other) {
  const auto worth = [](const SalvagedLog& log) { return std::pair(rows_in(log, "answers"), rows_in(log)); };
  return worth(one) > worth(other);
}

/// With the schema's pages made anew as a version has them; 0: as they are.
fs::path copy_of(const fs::path& damaged, const fs::path& scratch, bool with_ahead, int new_schema) {
  const fs::path copy = scratch / fmt::format("copy-{}{}.sqlite", with_ahead ? 1 : 0, new_schema);
  copy_log(damaged, copy);
  if (!with_ahead) fs::remove(ahead_file(copy));
  if (new_schema != 0) renew_schema(copy, scratch, new_schema);
  return copy;
}

}  // namespace

SalvagedLog salvage_log(const fs::path& damaged, const fs::path& scratch) {
  const bool has_ahead = fs::exists(ahead_file(damaged));
  SalvagedLog best;
  for (const int new_schema :
       {0, 3, 4, 5, 6, 2, 7, 8, 9, 10})  // as they are, or a version's, the likely ones first
    for (const bool with_ahead : {true, false}) {
      if (with_ahead && !has_ahead) continue;
      Reading reading = read_all(copy_of(damaged, scratch, with_ahead, new_schema));
      if (is_better(reading.log, best)) best = std::move(reading.log);
      if (reading.whole) return best;
    }
  return best;
}

}  // namespace seamline::study
