#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/core.h>

#include <filesystem>
#include <string>

#include "study/log/log_database.h"
#include "study/log/recovery/log_salvage.h"

namespace seamline::study {

inline std::string columns_of(SQLite::Database& database, const char* table) {
  std::string columns;
  for (SQLite::Statement row(database, fmt::format("PRAGMA table_info({})", table)); row.executeStep();)
    columns += (columns.empty() ? "" : ", ") + row.getColumn(1).getString();
  return columns;
}

/// The rows of a log of today as a program of schema version 2 would have written them.
inline void write_schema_2(const std::filesystem::path& today, const std::filesystem::path& old) {
  SQLite::Database database(old.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec("PRAGMA journal_mode = WAL");
  database.exec(log_schema_sql(2));
  SQLite::Statement attach(database, "ATTACH ? AS today");
  attach.bind(1, today.string());
  attach.exec();
  for (const LogTable& table : log_tables()) {
    const std::string columns = columns_of(database, table.name);
    database.exec(fmt::format("INSERT INTO main.{0} ({1}) SELECT {1} FROM today.{0}", table.name, columns));
  }
  attach.reset();
}

}  // namespace seamline::study
