// A log that holds what its own tables would not let in: refused by name, never counted with.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/support/error.h"
#include "study/log.h"
#include "study/simulation.h"
#include "temporary_set.h"

namespace seamline {
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
  try {
    (void)read_log(folder / "changed");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(LogValues, OutOfRangeIsRefusedByTableAndColumn) {
  const TemporaryFolder folder;
  (void)write_set(folder / "set");
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 2});
  EXPECT_EQ(complaint_after(folder, "UPDATE answers SET rating = 4"), "no complaint");
  const auto expect = [&](const char* change, const char* field, const char* wanted) {
    EXPECT_THAT(complaint_after(folder, change),
                AllOf(HasSubstr("changed: "), HasSubstr(field), HasSubstr(wanted), HasSubstr(", found ")));
  };
  expect("UPDATE answers SET chosen_index = 4000000000", "answers.chosen_index", "from 1 to 3");
  expect("UPDATE answers SET rating = -1", "answers.rating", "from 1 to 4");
  expect("UPDATE answers SET choice_ns = -1", "answers.choice_ns", "at least 0");
  expect("UPDATE answers SET image_scale = -1", "answers.image_scale", "above 0");
  expect("UPDATE answers SET image_scale = 9e999", "answers.image_scale", "above 0");
  expect("UPDATE stimuli SET object_index = 0", "answers.object_index", "from 1 to 3");
  expect("UPDATE stimuli SET depth_width_px = -64", "answers.depth_width_px", "from 2");
  expect("UPDATE stimuli SET artifact = 'glow'", "artifact", "a known artifact");
  expect("UPDATE participants SET code = '<script>' WHERE participant = 1", "participants.code", "letters");
  expect("UPDATE participants SET slot = -5", "participants.slot", "from 0");
  expect("UPDATE participants SET excluded = 7", "participants.excluded", "from 0 to 1");
}

TEST(LogValues, ACatchTrialOfNoKnownKindIsRefused) {
  const TemporaryFolder folder;
  (void)write_set(folder / "set");
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 1});
  EXPECT_THAT(complaint_after(folder, "UPDATE trials SET kind = 'lunch' WHERE trial_index = 0"),
              HasSubstr("wanted a known kind of trial, found \"lunch\""));
}

}  // namespace
}  // namespace seamline
