// Tasks from the study file to the log, with simulated people.
#include <gtest/gtest.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <map>

#include "stimuli/definition/parts/task_definition.h"
#include "study/log/log.h"
#include "study/log/log_database.h"
#include "study/log/recovery/log_recovery.h"
#include "study/running/simulation.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

struct TaskCase {
  const char* text;
  double chance;  ///< of who sees nothing
  int objects = 3;
};
const std::vector<TaskCase> task_cases = {
    {"[task]\nkind = \"pair\"\n", 1.0 / 2},
    {"[task]\nkind = \"interval\"\npictures = 3\n", 1.0 / 3},
    {"[task]\nkind = \"interval\"\nsecond_question = true\n", 1.0 / 2},
    {"[task]\nkind = \"yes_no\"\n[catch]\nreference = 8\n", simulated_false_alarms},
    {"[task]\nkind = \"pair\"\nasks = \"same\"\n[catch]\nreference = 8\n", simulated_false_alarms},
    {"[task]\nkind = \"rating\"\n[catch]\nreference = 8\n", 0},
    {"[task]\nkind = \"object\"\nrepetitions = 2\n", 1.0 / 3},
    {"[task]\nkind = \"object\"\nobjects = 2\n", 1.0 / 2, 2},
    {"[task]\nkind = \"object\"\nobjects = 5\n", 1.0 / 5, 5},
    {"[task]\nkind = \"object\"\nobjects = 8\nsecond_question = false\n", 1.0 / 8, 8},
    {"[task]\nkind = \"pair\"\nobjects = 1\nrepetitions = 3\n", 1.0 / 2, 1}};

class TaskStudyTest : public testing::Test {
 protected:
  TemporaryFolder folder;

  LogContents simulate(const std::string& text, ObserverKind observer, int count, int objects = 3) {
    const std::string name = fmt::format("log-{}", made_++);
    (void)write_set_of_text(folder / (name + "-set"), study_text("tiny", "64, 512", objects) + text);
    for (const int people : {1, count})
      run_simulated_study({.set_folder = folder / (name + "-set"),
                           .log = folder / name,
                           .observer = observer,
                           .count = people,
                           .seed = 4});
    last_log = folder / name;
    return read_log(last_log);
  }
  std::filesystem::path last_log;

 private:
  int made_ = 0;
};

TEST_F(TaskStudyTest, WhoSeesEverythingIsAlwaysRightAndWhoSeesNothingIsRightByChance) {
  for (const TaskCase& task : task_cases) {
    for (const Answer& answer : simulate(task.text, ObserverKind::perfect, 3, task.objects).answers)
      ASSERT_TRUE(answer.correct()) << task.text;
    const LogContents guesses = simulate(task.text, ObserverKind::guesser, 40, task.objects);
    double right = 0;
    for (const Answer& answer : guesses.answers) right += answer.correct() ? 1 : 0;
    const auto n = static_cast<double>(guesses.answers.size());
    EXPECT_NEAR(right / n, task.chance, 4 * std::sqrt(0.25 / n)) << task.text;
  }
}

TEST_F(TaskStudyTest, FalseAlarmsAreWrongAnswersToReferences) {
  const LogContents log =
      simulate("[task]\nkind = \"yes_no\"\n[catch]\nreference = 20\n", ObserverKind::guesser, 40);
  double alarms = 0;
  ASSERT_EQ(log.catches.size(), 800U);
  for (const CatchTrialAnswer& answer : log.catches) {
    EXPECT_EQ(answer.right_index, 2);
    alarms += answer.right() ? 0 : 1;
  }
  EXPECT_NEAR(alarms / 800, simulated_false_alarms, 4 * std::sqrt(0.09 / 800));
}

TEST_F(TaskStudyTest, EveryStimulusIsRepeatedAndEachRoundHasAnOrderOfItsOwn) {
  const LogContents log =
      simulate("[task]\nkind = \"object\"\nrepetitions = 3\n", ObserverKind::threshold, 2);
  std::map<std::string, int> shown;
  std::vector<std::string> rounds(3);
  for (const Answer& answer : log.answers) {
    if (answer.participant != "sim-0001") continue;
    ++shown[answer.stimulus_id];
    rounds.at(static_cast<std::size_t>(answer.trial_index / 24)) += answer.stimulus_id + " ";
  }
  EXPECT_EQ(shown.size(), 24U);
  for (const auto& [id, times] : shown) EXPECT_EQ(times, 3) << id;
  EXPECT_NE(rounds[0], rounds[1]);
  EXPECT_NE(rounds[1], rounds[2]);
}

TEST_F(TaskStudyTest, TheLogSaysWhatWasRightAndItsVersionOnlyThen) {
  const auto version = [&] {
    return SQLite::Database(last_log.string()).execAndGet("PRAGMA user_version").getInt();
  };
  const LogContents pair = simulate(task_cases[0].text, ObserverKind::threshold, 4);
  EXPECT_EQ(version(), log_schema_version_with(false, false, true));
  ASSERT_NE(pair.task, nullptr);
  std::map<int, int> right;
  for (const Answer& answer : pair.answers) ++right[answer.right()];
  EXPECT_EQ(right.size(), 2U);
  EXPECT_EQ(simulate("", ObserverKind::threshold, 2).task, nullptr);
  EXPECT_EQ(version(), log_schema_version);
}

TEST_F(TaskStudyTest, ALogOfManyObjectsIsOfAVersionOfItsOwn) {
  const auto version = [&](const std::filesystem::path& log) {
    return SQLite::Database(log.string()).execAndGet("PRAGMA user_version").getInt();
  };
  (void)simulate("[task]\nkind = \"object\"\nobjects = 2\n", ObserverKind::guesser, 2, 2);
  EXPECT_EQ(version(last_log), log_schema_version_with(false, false, true));
  const LogContents before =
      simulate("[task]\nkind = \"object\"\nobjects = 5\n", ObserverKind::guesser, 6, 5);
  EXPECT_EQ(version(last_log), log_schema_version_with(false, false, true, true));
  std::map<int, int> chosen, right;
  for (const Answer& answer : before.answers) {
    ++chosen[answer.chosen_index];
    ++right[answer.right()];
  }
  EXPECT_EQ(chosen.size(), 5U);
  EXPECT_EQ(right.size(), 5U);
  (void)recover_log(last_log, folder / "saved", {});
  EXPECT_EQ(version(folder / "saved"), version(last_log));
  const LogContents after = read_log(folder / "saved");
  ASSERT_EQ(after.answers.size(), before.answers.size());
  for (std::size_t i = 0; i < before.answers.size(); ++i)
    ASSERT_EQ(after.answers[i].chosen_index, before.answers[i].chosen_index);
}

TEST_F(TaskStudyTest, ADamagedLogKeepsWhatWasRight) {
  const LogContents before = simulate(task_cases[0].text, ObserverKind::threshold, 4);
  (void)recover_log(last_log, folder / "saved", {});
  const LogContents after = read_log(folder / "saved");
  ASSERT_EQ(after.answers.size(), before.answers.size());
  for (std::size_t i = 0; i < before.answers.size(); ++i)
    ASSERT_EQ(after.answers[i].right(), before.answers[i].right());
  (void)simulate("", ObserverKind::threshold, 2);
  (void)recover_log(last_log, folder / "plain", {});
  EXPECT_EQ(read_log(folder / "plain").answers.size(), 48U);
}

}  // namespace
}  // namespace seamline::study
