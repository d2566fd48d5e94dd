// A damaged log is refused in a sentence, and what can be read of it is saved.
#include "study/log/recovery/log_recovery.h"
#include "study/log/recovery/log_recovery_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "study/log/log.h"
#include "study/running/simulation.h"
#include "support/text/error.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LogRecoveryTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  fs::path log, saved;

  void SetUp() override {
    write_set(folder / "set", "64, 512");
    log = folder / "log.sqlite";
    saved = folder / "saved.sqlite";
    answer(14);
  }

  void answer(int people) const {
    run_simulated_study({.set_folder = folder / "set", .log = log, .count = people, .seed = 3});
  }

  [[nodiscard]] std::string complaint_of_reading() const {
    return test::complaint_of([&] { (void)read_log(log); });
  }

  void lose_page(std::size_t page) const {
    std::string bytes = read_file(log);
    for (std::size_t i = 0; i < 4096; ++i) bytes.at(page * 4096 + i) = '\0';
    write_file_atomically(log, bytes);
  }
};

/// An answer but for who gave it.
std::string text_of(const Answer& answer) {
  return fmt::format("{} {} {} {}", answer.trial_index, answer.stimulus_id, answer.chosen_index,
                     answer.rating);
}

std::multiset<std::string> texts_of(const LogContents& log) {
  std::multiset<std::string> texts;
  for (const Answer& answer : log.answers) texts.insert(text_of(answer));
  return texts;
}

TEST_F(LogRecoveryTest, AnUndamagedLogIsSavedWholeAndNothingIsSaidToBeLost) {
  const LogContents before = read_log(log);
  const LogRecovery recovery = recover_log(log, saved, {});
  const LogContents after = read_log(saved);
  EXPECT_EQ(texts_of(after), texts_of(before));
  EXPECT_EQ(after.participants.size(), 14U);
  EXPECT_TRUE(recovery.refused.empty());
  for (const LostAnswers& person : recovery.participants)
    EXPECT_TRUE(person.missing_trials.empty()) << person.code;
  EXPECT_THAT(recovery_text(recovery, log, saved), HasSubstr("no gap was found"));
}

TEST_F(LogRecoveryTest, EveryLostPageIsNoticedAndEachLostAnswerIsNamed) {
  const LogContents before = read_log(log);
  const std::string whole = read_file(log);
  const std::size_t pages = whole.size() / 4096;
  ASSERT_GE(pages, 20U);
  int with_losses = 0;
  for (std::size_t page = 0; page < pages; ++page) {
    write_file_atomically(log, whole);
    lose_page(page);
    EXPECT_THAT(complaint_of_reading(), HasSubstr("log recover")) << "page " << page;
    fs::remove(saved);
    const LogRecovery recovery = recover_log(log, saved, folder / "set");
    const LogContents after = read_log(saved);
    std::size_t named = 0;
    for (const LostAnswers& person : recovery.participants) named += person.missing_trials.size();
    const auto refused = recovery.refused.find("answers");
    if (refused != recovery.refused.end()) named += static_cast<std::size_t>(refused->second);
    EXPECT_GE(after.answers.size() + named, before.answers.size()) << "page " << page;
    with_losses += named > 0 ? 1 : 0;
    const std::multiset<std::string> was = texts_of(before), is = texts_of(after);
    EXPECT_TRUE(std::includes(was.begin(), was.end(), is.begin(), is.end())) << "page " << page;
  }
  EXPECT_GE(with_losses, 3);
}

TEST_F(LogRecoveryTest, ALogThatWasCutShortGivesBackItsBeginning) {
  answer(26);  // so long that the study is in what is left
  fs::resize_file(log, fs::file_size(log) * 2 / 3);
  EXPECT_THAT(complaint_of_reading(), HasSubstr("log recover"));
  const LogRecovery recovery = recover_log(log, saved, {});
  EXPECT_FALSE(read_log(saved).participants.empty());
  EXPECT_THAT(recovery_text(recovery, log, saved), HasSubstr("lost"));
}

TEST_F(LogRecoveryTest, RefusesToOverwriteAndFilesThatAreNoLog) {
  write_file_atomically(saved, "something of somebody");
  EXPECT_THROW(recover_log(log, saved, {}), InputError);
  EXPECT_EQ(read_file(saved), "something of somebody");
  write_file_atomically(log, std::string(20000, 'x'));
  EXPECT_THROW(recover_log(log, folder / "other.sqlite", {}), InputError);
  EXPECT_FALSE(fs::exists(folder / "other.sqlite"));
}

}  // namespace
}  // namespace seamline::study
