#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace seamline::study {

/// SQLite finds nothing wrong with the file, and no row refers to one that is not there.
inline void expect_sound(const std::filesystem::path& log) {
  SQLite::Database database(log.string(), SQLite::OPEN_READWRITE, 1000);
  EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
  SQLite::Statement orphans(database, "PRAGMA foreign_key_check");
  EXPECT_FALSE(orphans.executeStep());
}

}  // namespace seamline::study
