// A log of another hand may carry triggers, views and tables that are not ours: refused, and its rows saved.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "log_fixture.h"
#include "study/log/log_admin.h"
#include "study/log/log_database.h"
#include "study/log/recovery/log_recovery.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LogSchema : public LogTest {
 protected:
  void SetUp() override {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 24);
    (void)enter(log, {.code = "p2"}, 7);
  }
  void change(const std::string& sql) const {
    SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec(sql);
  }
  /// By our words in every place where a log is opened; then its rows are saved.
  void expect_refused_and_saved(const std::string& what) const {
    for (const std::string& said :
         {complaint_of([&] { (void)read_log(path); }), complaint_of([&] { exclude_participant(path, "p1"); }),
          complaint_of([&] { forget_participant(path, "p1"); }),
          complaint_of([&] { LogWriter log(path, set); })}) {
      EXPECT_THAT(said, HasSubstr("and nothing else")) << what;
      EXPECT_THAT(said, HasSubstr("log recover")) << what;
    }
    const fs::path saved = folder / "saved.sqlite";
    const LogRecovery recovery = recover_log(path, saved, {});
    EXPECT_TRUE(recovery.refused.empty()) << what;
    const LogContents log = read_log(saved);
    ASSERT_EQ(log.answers.size(), 31U) << what;
    for (const Answer& answer : log.answers) EXPECT_EQ(answer.rating, 1 + answer.trial_index % 4) << what;
    EXPECT_EQ(log.participants.size(), 2U) << what;
    SQLite::Database database(saved.string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(schema_of(database), log_schema()) << what;
    EXPECT_NO_THROW(forget_participant(saved, "p1"));
    EXPECT_EQ(read_log(saved).answers.size(), 7U) << what;
  }
};

TEST_F(LogSchema, WhatIsNotOursIsRefusedAndItsRowsAreSaved) {
  const std::string whole = read_file(path);
  for (const std::string& foreign : {
           std::string("CREATE TRIGGER t AFTER INSERT ON sessions BEGIN UPDATE answers SET rating = 1; END"),
           std::string(
               "CREATE TRIGGER t BEFORE DELETE ON participants BEGIN INSERT INTO consent_texts VALUES "
               "(printf('%064d', 1), old.code); END"),
           std::string("CREATE VIEW v AS WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
                       "SELECT group_concat(i) FROM n"),
           std::string("CREATE INDEX i ON answers (rating)"),
           std::string("CREATE INDEX i ON participants (hex(zeroblob(1000)))"),
           std::string("CREATE TABLE more (x); INSERT INTO more SELECT code FROM participants"),
           std::string("DROP INDEX events_of_session"),
           std::string("ANALYZE"),
           std::string("ALTER TABLE answers ADD COLUMN more TEXT"),
           std::string("ALTER TABLE answers RENAME COLUMN rating TO stars"),
           // Whoever edits the file needs no rule of SQLite's: here a column that is computed when it is
           // read.
           std::string(
               "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, 'image_scale     "
               "REAL NOT NULL', 'image_scale REAL AS (length(hex(zeroblob(9000000)))), more REAL NOT "
               "NULL') WHERE name = 'answers'"),
           std::string("PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, 'STRICT', "
                       "'') WHERE name = 'participants'"),
       }) {
    write_file_atomically(path, whole);
    change(foreign);
    expect_refused_and_saved(foreign);
    fs::remove(folder / "saved.sqlite");
  }
}

TEST_F(LogSchema, AnIndexThatTakesGigabytesIsNeverRun) {
  change("CREATE INDEX i ON participants (hex(zeroblob(1)))");
  change(
      "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = "
      "'CREATE INDEX i ON participants (hex(zeroblob(499999999)))' WHERE name = 'i'");
  expect_refused_and_saved("a large index");
}

TEST_F(LogSchema, AValueLargerThanALogsIsRefusedInASentence) {
  change("UPDATE study SET study_text = hex(zeroblob(40000000))");
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("wanted an undamaged log"));
}

/// The header's byte 47 says which schema format a file has; SQLite knows 1 to 4, and its complaint at
/// another is the same as at a mistake in our SQL.
TEST_F(LogSchema, AFormatOfTheFutureIsADamagedLogAndNotABug) {
  std::string bytes = read_file(path);
  bytes[47] = 13;
  write_file_atomically(path, bytes);
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("wanted an undamaged log"));
}

}  // namespace
}  // namespace seamline::study
