// A log of schema version 2 is read as it was, and becomes one of today's without losing a value.
#include "study/log/recovery/log_upgrade.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "log_fixture.h"
#include "schema_2_log.h"
#include "sound_log.h"
#include "study/log/log_admin.h"
#include "study/log/recovery/log_recovery.h"
#include "study/log/session_claims.h"
#include "support/files/hash.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LogUpgradeTest : public LogTest {
 protected:
  fs::path old = folder / "old.sqlite", upgraded = folder / "new.sqlite";

  /// A row in every table.
  void SetUp() override {
    {
      LogWriter log(path, set);
      OpenSession whole = enter(log, {.code = "p1"}, 24);
      log.record_consent(whole, "May we?", 5);
      log.record_form(whole, std::vector<FormAnswer>{{.field = "age", .value = "30"}});
      log.record_display(whole, {.machine = "m", .monitor = "s", .renderer = "r"});
      log.append_training(whole,
                          {.trial = {.kind = TrialKind::stimulus, .stimulus = 1}, .answer = answer(0)});
      log.append_events(whole, std::vector<RawEvent>{{.monotonic_ns = 5, .kind = "shown", .swap = 3}});
      log.complete(whole);
      OpenSession again = enter(log, {.code = "p2"}, 9);
      log.restart(again);
      log.append_trials(again, all_trials(again.slot));
      for (int i = 0; i < 7; ++i) log.append_answer(again, answer(again.answered));
      (void)enter(log, {.code = "gone"}, 2);
      (void)enter(log, {.code = "sim-0001", .simulated = Simulated{ObserverKind::guesser, ~0ULL}}, 4);
      (void)enter(log, {.code = "sim-0002", .simulated = Simulated{ObserverKind::image, 3, 0.1 + 0.2}}, 4);
      log.record_decline();
    }
    forget_participant(path, "gone");
    write_schema_2(path, old);
  }

  /// All rows of all tables, each value with its type.
  static SalvagedLog rows_of(const fs::path& log) {
    SQLite::Database database(log.string(), SQLite::OPEN_READWRITE);
    SalvagedLog rows;
    for (const LogTable& table : log_tables())
      for (SQLite::Statement row(database, fmt::format("SELECT * FROM {}", table.name)); row.executeStep();)
        rows[table.name].push_back(row_of(row));
    return rows;
  }
};

TEST_F(LogUpgradeTest, TheTablesOfVersion2AreThoseThatLogsWereMadeWith) {
  std::string text;
  for (const auto& [type, name, table, sql] : log_schema(2))
    text += type + "|" + name + "|" + table + "|" + sql + "\n";
  // Of a log that the last program of version 2 made.
  EXPECT_EQ(sha256(text), "e83d73a2bc9bcbe87edc1bf8088cdde166b866e903537b974a77b7d20d88e3b4");
}

TEST_F(LogUpgradeTest, AnOldLogIsReadAsWidthsWithoutConditions) {
  const LogContents log = read_log(old), today = read_log(path);
  EXPECT_EQ(log.quantity, Quantity::depth_width_px);
  EXPECT_EQ(log.noticeability, Direction::decreasing);
  ASSERT_EQ(log.answers.size(), today.answers.size());
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    EXPECT_EQ(log.answers[i].stimulus_id, today.answers[i].stimulus_id);
    EXPECT_EQ(log.answers[i].condition, "");
    EXPECT_EQ(log.answers[i].level, log.answers[i].depth_width_px);
    EXPECT_EQ(log.answers[i].level, today.answers[i].level);
    EXPECT_EQ(log.answers[i].rating, today.answers[i].rating);
  }
  EXPECT_THAT(status_text(log), HasSubstr("4 participants"));
}

TEST_F(LogUpgradeTest, EveryValueOfEveryTableIsBroughtOverAndTheOldLogIsUnchanged) {
  const std::string before = read_file(old);
  const LogUpgrade upgrade = upgrade_log(old, upgraded);
  EXPECT_EQ(read_file(old), before);
  EXPECT_EQ(rows_of(upgraded), rows_of(path));  // what today's program writes by itself
  for (const LogTable& table : log_tables()) EXPECT_GT(upgrade.rows.at(table.name), 0) << table.name;
  EXPECT_THAT(upgrade_text(upgrade, old, upgraded), HasSubstr("4 participants and 39 answers"));
  expect_sound(upgraded);
  struct stat facts = {};
  ASSERT_EQ(::stat(upgraded.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600U);
}

TEST_F(LogUpgradeTest, AnswersThatWaitInTheWriteAheadLogAreBroughtOver) {
  SQLite::Database open(old.string(), SQLite::OPEN_READWRITE);
  open.exec("PRAGMA wal_autocheckpoint = 0; UPDATE answers SET rating = 4");
  (void)upgrade_log(old, upgraded);
  for (const Answer& answer : read_log(upgraded).answers) EXPECT_EQ(answer.rating, 4);
}

TEST_F(LogUpgradeTest, SessionsGoOnInTheUpgradedLogAndTheOldOneNamesTheCommand) {
  const std::string before = read_file(old);
  EXPECT_THAT(complaint_of([&] { LogWriter log(old, set); }), HasSubstr("seamline log upgrade LOG NEW"));
  EXPECT_EQ(read_file(old), before);
  (void)upgrade_log(old, upgraded);
  LogWriter log(upgraded, set);
  OpenSession session = log.open_session({.code = "p2"});
  EXPECT_EQ(session.answered, 7);
  EXPECT_EQ(session.trials, all_trials(session.slot));
  while (session.answered < 24) log.append_answer(session, answer(session.answered));
  log.complete(session);
  EXPECT_EQ(read_log(upgraded).answers.size(), 39U + 17U);
}

TEST_F(LogUpgradeTest, ParticipantsAreExcludedAndForgottenInAnOldLog) {
  exclude_participant(old, "p2");
  EXPECT_TRUE(read_log(old).participants[1].excluded);
  forget_participant(old, "p1");
  EXPECT_EQ(read_file(old).find("p1\x01"), std::string::npos);
  EXPECT_EQ(read_log(old).answers.size(), 15U);
  EXPECT_EQ(read_log(old).forgotten_participants, 2);
  (void)upgrade_log(old, upgraded);
  EXPECT_EQ(read_log(upgraded).answers.size(), 15U);
}

TEST_F(LogUpgradeTest, NothingIsOverwrittenAndNothingHalfIsLeft) {
  const auto left = [&] {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) files += entry.exists() ? 1 : 0;
    return files;
  };
  const int files = left();
  EXPECT_THAT(complaint_of([&] { (void)upgrade_log(path, upgraded); }), HasSubstr("needs no upgrade"));
  write_file_atomically(upgraded, "something of somebody");
  EXPECT_THAT(complaint_of([&] { (void)upgrade_log(old, upgraded); }), HasSubstr("does not exist yet"));
  EXPECT_EQ(read_file(upgraded), "something of somebody");
  fs::remove(upgraded);
  {
    SQLite::Database database(old.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA ignore_check_constraints = ON; UPDATE answers SET rating = 9");
  }
  EXPECT_THAT(complaint_of([&] { (void)upgrade_log(old, upgraded); }), HasSubstr("log recover"));
  EXPECT_THAT(complaint_of([&] { (void)upgrade_log(folder / "none", upgraded); }), HasSubstr("no such file"));
  EXPECT_FALSE(fs::exists(upgraded));
  EXPECT_EQ(left(), files);
}

TEST_F(LogUpgradeTest, NobodyMayBeInASession) {
  SessionClaims claims(old);
  ASSERT_TRUE(claims.claim(1));
  EXPECT_THAT(complaint_of([&] { (void)upgrade_log(old, upgraded); }), HasSubstr("in a session"));
  EXPECT_FALSE(fs::exists(upgraded));
}

TEST_F(LogUpgradeTest, ADamagedOldLogIsRecoveredAsOneOfToday) {
  const std::string whole = read_file(old);
  const SalvagedLog today = rows_of(path);
  const auto recovered = [&](const fs::path& with_set) {
    fs::remove(upgraded);
    const LogRecovery recovery = recover_log(old, upgraded, with_set);
    EXPECT_EQ(schema_of(*std::make_unique<SQLite::Database>(upgraded.string())), log_schema());
    return recovery;
  };
  EXPECT_TRUE(recovered({}).refused.empty());
  EXPECT_EQ(rows_of(upgraded).at("stimuli"), today.at("stimuli"));
  EXPECT_EQ(rows_of(upgraded).at("answers"), today.at("answers"));
  for (std::size_t page = 0; page < whole.size() / 4096; ++page) {
    std::string damaged = whole;
    damaged.replace(page * 4096, 4096, 4096, '\0');
    write_file_atomically(old, damaged);
    (void)recovered(folder / "set");
    const LogContents log = read_log(upgraded);
    EXPECT_EQ(log.quantity, Quantity::depth_width_px) << page;
    for (const Answer& answer : log.answers) EXPECT_EQ(answer.level, answer.depth_width_px) << page;
    if (page == 0) {
      EXPECT_EQ(rows_of(upgraded).at("answers"), today.at("answers"));
    }
  }
}

}  // namespace
}  // namespace seamline::study
