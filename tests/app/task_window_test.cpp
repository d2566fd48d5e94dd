// Pairs, intervals, yes or no, ratings and matches in the real program on a real (virtual) screen: the log
// holds what was pressed, and the first question of each is saved as a picture.
#include <gtest/gtest.h>

#include <map>

#include "picture_set.h"
#include "study/exchange/answer_tables.h"
#include "study/exchange/match_records.h"
#include "study/log/log.h"
#include "study/trials/level_ladders.h"
#include "study/trials/participant_trials.h"
#include "window_driver.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;

struct TaskSitting {
  const char* kind;
  const char* more;
  int alternatives;  ///< 0: a rating alone
  int trials;
  int objects = 3;
};

void PrintTo(const TaskSitting& sitting, std::ostream* out) {
  *out << sitting.kind << sitting.objects;
}

struct TaskPress {
  int chosen = 0, rating = 0;
};

/// The kind, and the number of objects where it is another than three.
std::string name_of(const TaskSitting& sitting) {
  return sitting.kind + (sitting.objects == 3 ? std::string() : std::to_string(sitting.objects));
}

class TaskWindow : public testing::TestWithParam<TaskSitting> {};

/// Does what the screen asks for, until it says thanks; returns what was pressed, by trial.
std::map<int, TaskPress> sit_through(test::WindowDriver& window, const test::XServer& server,
                                     const fs::path& picture) {
  const TaskSitting& sitting = TaskWindow::GetParam();
  std::map<int, TaskPress> pressed;
  for (int look = 0; look < 20000 && window.running(); ++look) {
    const std::optional<test::Line> line = window.now();
    const std::string screen = line ? line->value("screen", "") : "";
    const std::string phase = line ? line->value("phase", "") : "";
    if (screen == "thanks") return pressed;
    if (screen == "consent") window.keys("Tab Tab Return");
    if (screen == "instructions" || screen == "ready" || screen == "break") window.key("Return");
    if (phase == "choosing" || phase == "rating") {
      const int trial = line->value("trial", -1);
      if (pressed.empty()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(60));  // the server copies after the swap
        write_png(picture, server.picture());
      }
      TaskPress& press = pressed[trial];
      const int choice = sitting.alternatives == 0 ? 0 : 1 + trial % sitting.alternatives;
      const int key = sitting.alternatives == 0 ? 1 + trial % 5 : 1 + trial % 4;
      (phase == "choosing" ? press.chosen : press.rating) = phase == "choosing" ? choice : key;
      window.key(std::to_string(phase == "choosing" ? choice : key));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  throw std::runtime_error("the sitting did not end: " + window.output());
}

/// Of an interval the pictures of each trial were counted.
void expect_exposures(const LogContents& log, const TaskSitting& sitting) {
  const CsvTable answers = answer_tables(log).front();
  const auto column = std::find_if(answers.columns.begin(), answers.columns.end(),
                                   [](const CsvColumn& one) { return one.name == "exposure_frames"; });
  ASSERT_EQ(column != answers.columns.end(), std::string(sitting.kind) == "interval");
  if (column == answers.columns.end()) return;
  const auto at = static_cast<std::size_t>(column - answers.columns.begin());
  for (const std::vector<CsvValue>& row : answers.rows) {
    ASSERT_TRUE(std::holds_alternative<std::int64_t>(row.at(at)));
    EXPECT_EQ(std::get<std::int64_t>(row[at]), 12);  // 0.2 s of 60 Hz
    EXPECT_GE(std::get<std::int64_t>(row[at + 1]), 0);
  }
}

TEST_P(TaskWindow, TheLogHoldsWhatWasPressed) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const TaskSitting& sitting = GetParam();
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "task" / name_of(sitting);
  fs::remove_all(folder);
  (void)test::write_picture_set(
      folder / "set",
      {.objects = sitting.objects,
       .session = "inter_trial_s = 0.05\n",
       .top = "participant_form = false",
       .more = fmt::format("[task]\nkind = \"{}\"\n{}[consent]\ntext = \"Discs.\"\n[training]\ntrials = 0\n"
                           "[[instructions.page]]\ntext = \"Press a digit.\"\n",
                           sitting.kind, sitting.more)});
  const test::XServer server(folder / "screen", 1024, 768);
  test::keep_display_profile(folder / "run" / "config", 1024, 768);
  test::WindowDriver window(server,
                            {.set = folder / "set", .log = folder / "log.sqlite", .folder = folder / "run"});
  const std::map<int, TaskPress> pressed = sit_through(window, server, folder / "question.png");
  EXPECT_EQ(static_cast<int>(pressed.size()), sitting.trials);
  window.kill();
  const LogContents log = read_log(folder / "log.sqlite");
  EXPECT_EQ(log.answers.size(), 2U * static_cast<std::size_t>(sitting.objects));  // at two widths
  expect_exposures(log, sitting);
  for (const Answer& answer : log.answers) {
    const TaskPress& press = pressed.at(answer.trial_index);
    if (sitting.alternatives > 0) {
      EXPECT_EQ(answer.chosen_index, press.chosen);
    } else {
      // The lowest label is "nothing seen", choice 2; the others are ratings of something seen.
      EXPECT_EQ(answer.chosen_index, press.rating == 1 ? 2 : 1);
      if (press.rating > 1) {
        EXPECT_EQ(answer.rating, press.rating - 1);
      }
    }
  }
}

/// Presses keys until the match of each trial is where it should end; the level at which each ended, by
/// trial.
std::map<int, double> match_through(test::WindowDriver& window, const test::XServer& server,
                                    const RenderedSet& set, const std::vector<Trial>& trials,
                                    const fs::path& picture) {
  const LevelLadders ladders = *make_trial_rules(set).ladders;
  std::map<int, double> ended;
  for (int look = 0; look < 20000 && window.running(); ++look) {
    const std::optional<test::Line> line = window.now();
    const std::string screen = line ? line->value("screen", "") : "";
    if (screen == "thanks") return ended;
    if (screen == "consent") window.keys("Tab Tab Return");
    if (screen == "instructions" || screen == "ready" || screen == "break") window.key("Return");
    const int trial = line ? line->value("trial", -1) : -1;
    if (line && line->value("phase", "") == "choosing" && !ended.contains(trial)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(150));  // the least time of viewing
      int at = trials.at(static_cast<std::size_t>(trial)).stimulus;
      for (int press = 0; press <= trial; ++press) {
        const bool clearer = (press + trial) % 3 == 0;
        window.key(clearer ? "Left" : "Right");
        at = next_rung(ladders, at, clearer ? -1 : 1).value_or(at);
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
      }
      if (trial == 1) write_png(picture, server.picture());
      ended[trial] = set.manifest.stimuli.at(static_cast<std::size_t>(at)).stimulus.level;
      window.key("Return");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  throw std::runtime_error("the sitting did not end: " + window.output());
}

TEST(MatchWindow, TheLogHoldsTheLevelToWhichTheKeysLed) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "task" / "match";
  fs::remove_all(folder);
  const RenderedSet set = test::write_picture_set(
      folder / "set", {.widths = "64, 128, 256, 512",
                       .session = "inter_trial_s = 0.05\n",
                       .top = "participant_form = false",
                       .more = "[task]\nkind = \"match\"\nrepetitions = 2\n[consent]\ntext = \"Discs.\"\n"
                               "[[instructions.page]]\ntext = \"Press an arrow.\"\n"});
  const test::XServer server(folder / "screen", 1024, 768);
  test::keep_display_profile(folder / "run" / "config", 1024, 768);
  test::WindowDriver window(server,
                            {.set = folder / "set", .log = folder / "log.sqlite", .folder = folder / "run"});
  const std::vector<Trial> trials = decided_trials(make_trial_rules(set), 0, {});
  const std::map<int, double> ended = match_through(window, server, set, trials, folder / "question.png");
  window.kill();
  const std::vector<MatchRecord> matches = read_matches(read_log(folder / "log.sqlite"));
  ASSERT_EQ(matches.size(), 6U);  // three discs, twice
  for (const MatchRecord& match : matches) {
    EXPECT_EQ(match.level, ended.at(match.trial_index));
    EXPECT_EQ(match.steps, match.trial_index + 1);
    EXPECT_GT(match.answer_s, 0.1);
  }
}

constexpr const char* with_references = "[catch]\nreference = 2\n";
INSTANTIATE_TEST_SUITE_P(, TaskWindow,
                         testing::Values(TaskSitting{"pair", "", 2, 6},
                                         TaskSitting{"interval", "exposure_s = 0.2\ngap_s = 0.1\n", 2, 6},
                                         TaskSitting{"yes_no", with_references, 2, 8},
                                         TaskSitting{"rating", with_references, 0, 8},
                                         TaskSitting{"object", "objects = 2\n", 2, 4, 2},
                                         TaskSitting{"object", "objects = 5\n", 5, 10, 5}),
                         [](const auto& sitting) { return name_of(sitting.param); });

}  // namespace
}  // namespace seamline::study::app
