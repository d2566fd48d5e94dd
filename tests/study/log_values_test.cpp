// A log that holds what its own tables would not let in: refused by name, never counted with.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/log/log.h"
#include "study/log/log_values.h"
#include "study/running/simulation.h"
#include "support/text/error.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// What reading says after a change that ignores the tables' CHECKs.
std::string complaint_after(const TemporaryFolder& folder, const char* change) {
  std::filesystem::copy_file(folder / "log", folder / "changed",
                             std::filesystem::copy_options::overwrite_existing);
  {
    SQLite::Database database((folder / "changed").string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA ignore_check_constraints = ON");
    if (database.exec(change) == 0) return "nothing was changed";
  }
  return test::complaint_of([&] { (void)read_log(folder / "changed"); });
}

TEST(LogValues, WhatTheTablesWouldNotLetInIsRefused) {
  const TemporaryFolder folder;
  (void)write_set(folder / "set");
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 2});
  EXPECT_EQ(complaint_after(folder, "UPDATE answers SET rating = 4"), "no complaint");
  for (const auto& [change, table] : std::initializer_list<std::pair<const char*, const char*>>{
           {"UPDATE answers SET chosen_index = 4000000000", "answers"},
           {"UPDATE answers SET rating = -1", "answers"},
           {"UPDATE answers SET choice_ns = -1", "answers"},
           {"UPDATE answers SET image_scale = 9e999", "answers"},
           {"UPDATE stimuli SET object_index = 0", "stimuli"},
           {"UPDATE stimuli SET depth_width_px = -64", "stimuli"},
           {"UPDATE stimuli SET artifact = 'glow'", "stimuli"},
           {"UPDATE stimuli SET level = -1", "stimuli"},
           {"UPDATE stimuli SET level = 9e999", "stimuli"},
           {"UPDATE study SET quantity = 'glow'", "study"},
           {"UPDATE study SET noticeability = 'stays'", "study"},
           {"UPDATE trials SET kind = 'lunch' WHERE trial_index = 0", "trials"},
           {"UPDATE participants SET code = '<script>' WHERE participant = 1", "participants"},
           {"UPDATE participants SET excluded = 7", "participants"}})
    EXPECT_THAT(complaint_after(folder, change),
                AllOf(HasSubstr("changed: "), HasSubstr(table), HasSubstr("wanted "), HasSubstr(", found ")))
        << change;
}

/// What the one column of `SELECT value` is refused with.
template <class Read>
std::string refusal(const char* value, Read&& read) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Statement row(database, std::string("SELECT ") + value + " AS rating");
  row.executeStep();
  const std::filesystem::path log = "log.sqlite";
  return test::complaint_of([&] { read(LogValues(row, log, "answers")); });
}

TEST(LogValues, EachKindOfValueHasItsRange) {
  const auto number = [](const LogValues& values) { EXPECT_EQ(values.number(0, 1, 4), 4); };
  EXPECT_EQ(refusal("4", number), "no complaint");
  for (const char* value : {"0", "5", "4294967300", "-9223372036854775808", "4.0", "'4'", "NULL", "x'04'"})
    EXPECT_THAT(refusal(value, number),
                HasSubstr("log.sqlite: answers.rating: wanted a whole number from 1 to 4"))
        << value;
  const auto time = [](const LogValues& values) { EXPECT_GE(values.time(0), 0); };
  EXPECT_EQ(refusal("9223372036854775807", time), "no complaint");
  EXPECT_THAT(refusal("-1", time), HasSubstr("at least 0, found \"-1\""));
  const auto positive = [](const LogValues& values) { EXPECT_GT(values.positive(0), 0); };
  EXPECT_EQ(refusal("0.5", positive), "no complaint");
  for (const char* value : {"0", "-1", "9e999", "NULL", "'word'"})
    EXPECT_THAT(refusal(value, positive), HasSubstr("a finite number above 0")) << value;
  const auto code = [](const LogValues& values) { EXPECT_EQ(values.code(0), "p-01"); };
  EXPECT_EQ(refusal("'p-01'", code), "no complaint");
  for (const char* value : {"''", "'<b>'", "'a b'", "hex(zeroblob(33))"})
    EXPECT_THAT(refusal(value, code), HasSubstr("a code of 1 to 64")) << value;
  const auto kind = [](const LogValues& values) { EXPECT_EQ(values.kind(0), TrialKind::attention); };
  EXPECT_EQ(refusal("'attention'", kind), "no complaint");
  EXPECT_THAT(refusal("'lunch'", kind), HasSubstr("wanted a known kind of trial, found \"lunch\""));
}

}  // namespace
}  // namespace seamline::study
