// People who come again, and two visits at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "visit_store_fixture.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(VisitStoreTest, WhoComesAgainGoesOn) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "p01"});
    (void)run(store, store.begin(), person, 5);
  }
  VisitStore store(set, path, {.code = "p01"});
  Visit visit = store.begin();
  EXPECT_TRUE(on<DisplayScreen>(visit));
  EXPECT_EQ(answered_trials(visit.session.trials), 5);
  visit = run(store, std::move(visit), person);
  EXPECT_TRUE(on<ThanksScreen>(visit));
  const LogContents log = read_log(path);
  EXPECT_EQ(log.answers.size() + log.catches.size(), 14U);
  EXPECT_EQ(log.participants[0].sessions, 2);
  EXPECT_EQ(count("SELECT count(*) FROM training_answers"), 6);
}

TEST_F(VisitStoreTest, WhoHasFinishedOrIsExcludedIsRefused) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "p01"});
    (void)run(store, store.begin(), person);
    VisitStore other(set, path, {.code = "p02"});
    (void)run(other, other.begin(), person, 2);
  }
  EXPECT_THAT(complaint(set, path, {.code = "p01"}), HasSubstr("not overwritten"));
  EXPECT_EQ(complaint(set, path, {.code = "p02"}), "no complaint");
  exclude_participant(path, "p02");
  EXPECT_THAT(complaint(set, path, {.code = "p02"}), HasSubstr("excluded"));
  EXPECT_THAT(complaint(set, path, {.code = "p01", .pilot = true}), HasSubstr("pilot"));
  EXPECT_THAT(complaint(set, path, {.code = "Ada Lovelace"}), HasSubstr("never a name"));
}

TEST_F(VisitStoreTest, ASessionInProgressElsewhereIsRefused) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "p01"});
    Visit visit = run(store, store.begin(), person, 2);
    EXPECT_THAT(complaint(set, path, {.code = "p01"}), HasSubstr("in a session"));
    EXPECT_TRUE(read_log(path).participants[0].in_progress);
    EXPECT_THAT(status_text(read_log(path)), HasSubstr("in a session now"));
    EXPECT_EQ(complaint(set, path, {.code = "p02"}), "no complaint");  // two at once are fine
    visit = run(store, std::move(visit), person, 4);
    EXPECT_EQ(answered_trials(visit.session.trials), 4);
  }
  EXPECT_FALSE(read_log(path).participants[0].in_progress);
  EXPECT_EQ(complaint(set, path, {.code = "p01"}), "no complaint");
}

/// Two visits take turns in one log.
TEST_F(VisitStoreTest, TwoSessionsAtOnceBothWork) {
  ScriptedPerson anna(1), berta(2);
  VisitStore first(set, path, {.code = "anna"});
  VisitStore second(set, path, {.code = "berta"});
  Visit one = first.begin();
  Visit other = second.begin();
  while (!is_over(one) || !is_over(other)) {
    if (!is_over(one)) one = first.step(std::move(one), anna.act(one));
    if (!is_over(other)) other = second.step(std::move(other), berta.act(other));
  }
  EXPECT_TRUE(on<ThanksScreen>(one));
  EXPECT_TRUE(on<ThanksScreen>(other));
  const LogContents log = read_log(path);
  EXPECT_EQ(log.answers.size(), 24U);
  EXPECT_NE(log.participants[0].slot, log.participants[1].slot);
  for (const Answer& answer : log.answers) {
    const ScriptedPerson& person = answer.participant == "anna" ? anna : berta;
    EXPECT_EQ(answer.rating, person.answer_to(answer.trial_index).rating);
  }
}

/// Two newcomers with one code: nobody is in the log when the second window opens.
TEST_F(VisitStoreTest, ACodeThatAppearsMeanwhileStopsTheSecondVisit) {
  VisitStore first(set, path, {.code = "p01"});
  VisitStore second(set, path, {.code = "p01"});
  Visit one = first.begin();
  Visit other = second.begin();
  EXPECT_TRUE(on<FormScreen>(first.step(std::move(one), ConsentGiven{})));
  other = second.step(std::move(other), ConsentGiven{});
  ASSERT_TRUE(on<StoppedScreen>(other));
  EXPECT_THAT(std::get<StoppedScreen>(other.screen).message, HasSubstr("in a session"));
  EXPECT_TRUE(on<StoppedScreen>(second.flush(other)));
  EXPECT_EQ(read_log(path).participants.size(), 1U);
}

TEST_F(VisitStoreTest, RestartSetsAnswersAsideAndRefuseRefuses) {
  const RenderedSet restart =
      write_set_of_text(folder / "restart", people_text("", "resume = \"restart\"\n"));
  ScriptedPerson person(5);
  std::vector<Trial> first_plan;
  for (int attempt = 0; attempt < 3; ++attempt) {
    VisitStore store(restart, path, {.code = "p01"});
    Visit visit = store.begin();
    EXPECT_EQ(answered_trials(visit.session.trials), 0);
    visit = run(store, std::move(visit), person, attempt == 2 ? 1000 : 3 + attempt);
  }
  const LogContents log = read_log(path);
  EXPECT_EQ(log.answers.size() + log.catches.size(), 14U);
  EXPECT_TRUE(log.participants[0].completed);
  EXPECT_EQ(log.participants[0].restarts, 2);
  EXPECT_EQ(count("SELECT count(*) FROM set_aside_answers WHERE attempt = 1"), 3);
  EXPECT_EQ(count("SELECT count(*) FROM set_aside_answers WHERE attempt = 2"), 4);

  const RenderedSet refuse = write_set_of_text(folder / "refuse", people_text("", "resume = \"refuse\"\n"));
  const fs::path other = folder / "other.sqlite";
  {
    VisitStore store(refuse, other, {.code = "p01"});
    (void)run(store, store.begin(), person, 0);
  }
  {
    VisitStore store(refuse, other, {.code = "p01"});  // nothing was answered yet
    (void)run(store, store.begin(), person, 1);
  }
  EXPECT_THAT(complaint(refuse, other, {.code = "p01"}), HasSubstr("session.resume = \"refuse\""));
}

}  // namespace
}  // namespace seamline::study
