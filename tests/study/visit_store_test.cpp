// A whole visit with scripted events into a real log.
#include "study/running/visit_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "support/text/error.h"
#include "visit_store_fixture.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

TEST_F(VisitStoreTest, NobodyAnswersInTheFirstTenthOfASecond) {
  const auto minimum_viewing_ns = [&](double asked_s) {
    set.study.session.minimum_viewing_s = asked_s;
    return make_visit_script(set).pace.minimum_viewing_ns;
  };
  EXPECT_EQ(minimum_viewing_ns(0), 100'000'000);
  EXPECT_EQ(minimum_viewing_ns(0.05), 100'000'000);
  EXPECT_EQ(minimum_viewing_ns(0.5), 500'000'000);
}

TEST_F(VisitStoreTest, AWholeVisitIsInTheLog) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "p01"});
    Visit visit = store.begin();
    EXPECT_TRUE(on<ConsentScreen>(visit));
    store.note({.monotonic_ns = 5, .kind = "focus_gained", .swap = 3});
    store.count_frames({.shown = 100, .late = 2});
    visit = run(store, std::move(visit), person);
    EXPECT_TRUE(on<ThanksScreen>(visit));
    store.note({.monotonic_ns = 9, .kind = "closed"});
    store.count_frames({.shown = 50, .late = 1});
    EXPECT_TRUE(on<ThanksScreen>(store.flush(visit)));
  }
  const LogContents log = read_log(path);
  ASSERT_EQ(log.participants.size(), 1U);
  const ParticipantRecord& record = log.participants[0];
  EXPECT_TRUE(record.completed && !record.pilot && !record.in_progress);
  EXPECT_EQ(record.stimulus_trials, 12);
  EXPECT_EQ(record.sessions, 1);
  EXPECT_EQ(record.form.size(), 4U);
  EXPECT_EQ(record.form[0], (FormAnswer{"age", "33"}));
  EXPECT_EQ(log.answers.size(), 12U);
  EXPECT_EQ(log.catches.size(), 2U);
  for (const Answer& answer : log.answers) {
    const TrialAnswer wanted = person.answer_to(answer.trial_index);
    EXPECT_EQ(answer.chosen_index, wanted.chosen_index);
    EXPECT_EQ(answer.rating, wanted.rating);
    EXPECT_EQ(answer.choice_ns, wanted.choice_ns);
    EXPECT_EQ(answer.rating_ns, wanted.rating_ns);
    EXPECT_EQ(answer.image_scale, 1);
  }
  EXPECT_EQ(count("SELECT count(*) FROM training_answers"), 3);
  EXPECT_EQ(count("SELECT accepted_unix_s FROM consents"), 1000);
  EXPECT_EQ(count("SELECT count(*) FROM consents JOIN consent_texts USING (text_sha256) WHERE text = 'Our "
                  "own text.'"),
            1);
  EXPECT_EQ(count("SELECT swap FROM events WHERE kind = 'focus_gained'"), 3);
  EXPECT_EQ(count("SELECT count(*) FROM events WHERE kind = 'closed' AND swap IS NULL"), 1);
  EXPECT_EQ(count("SELECT frames FROM sessions"), 150);
  EXPECT_EQ(count("SELECT late_frames FROM sessions"), 3);
  EXPECT_EQ(count("SELECT count(*) FROM displays WHERE monitor = 'Dull 24\"' AND read_back_bytes = 1000"), 1);
}

TEST_F(VisitStoreTest, EveryAnswerIsStoredBeforeTheNextPicture) {
  ScriptedPerson person(5);
  VisitStore store(set, path, {.code = "p01"});
  Visit visit = store.begin();
  for (int i = 0; i < 1000 && !is_over(visit); ++i) {
    visit = store.step(std::move(visit), person.act(visit));
    EXPECT_FALSE(visit.pending);
    const LogContents log = read_log(path);
    EXPECT_EQ(static_cast<int>(log.answers.size() + log.catches.size()),
              answered_trials(visit.session.trials));
  }
}

TEST_F(VisitStoreTest, DecliningStoresTheFactAlone) {
  {
    VisitStore store(set, path, {.code = "zzqdeclined"});
    Visit visit = store.begin();
    store.note({.monotonic_ns = 5, .kind = "shown", .detail = "zzqdeclined"});
    visit = store.step(std::move(visit), ConsentRefused{});
    EXPECT_TRUE(on<DeclinedScreen>(visit));
    visit = store.flush(std::move(visit));
    EXPECT_TRUE(on<DeclinedScreen>(visit));
    for (const char* suffix : {"", "-wal", "-lock"})
      EXPECT_EQ(read_file(path.string() + suffix).find("zzqdeclined"), std::string::npos) << suffix;
  }
  const LogContents log = read_log(path);
  EXPECT_EQ(log.declined_visits, 1);
  EXPECT_TRUE(log.participants.empty());
  EXPECT_EQ(count("SELECT count(*) FROM sessions"), 0);
  EXPECT_EQ(count("SELECT count(*) FROM events"), 0);
  EXPECT_THAT(status_text(log), HasSubstr("1 declined"));
}

TEST_F(VisitStoreTest, TheShippedConsentIsForPilotsOnly) {
  const RenderedSet shipped = write_set(folder / "shipped", "64");
  EXPECT_THAT(complaint(shipped, folder / "other.sqlite", {.code = "p01"}),
              testing::AllOf(HasSubstr("consent.text"), HasSubstr("pilot")));
  EXPECT_FALSE(fs::exists(folder / "other.sqlite"));
  EXPECT_EQ(complaint(shipped, folder / "other.sqlite", {.code = "p01", .pilot = true}), "no complaint");
}

TEST_F(VisitStoreTest, ScalingIsSaidWithEveryAnswer) {
  VisitStore store(set, path, {.code = "p01"});
  ScriptedPerson person(5);
  Visit visit = store.begin();
  DisplayFacts small = ScriptedPerson::display();
  small.scaling_allowed = true;
  small.image_scale = 0.75;
  while (!on<DisplayScreen>(visit)) visit = store.step(std::move(visit), person.act(visit));
  visit = store.step(std::move(visit), DisplayConfirmed{small});
  (void)run(store, std::move(visit), person);
  for (const Answer& answer : read_log(path).answers) EXPECT_EQ(answer.image_scale, 0.75);
  EXPECT_EQ(store.latest_display("lab-1", "Dull 24\""), small);
  EXPECT_EQ(store.latest_display("lab-1", "another"), std::nullopt);
}

TEST_F(VisitStoreTest, ForgettingLeavesNoByteOfTheCodeAnywhere) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "zzqforgotten"});
    store.note({.kind = "shown", .detail = "zzqforgotten looked"});
    (void)run(store, store.begin(), person, 7);
    VisitStore other(set, path, {.code = "kept"});
    (void)run(other, other.begin(), person, 3);
  }
  EXPECT_TRUE(fs::exists(path.string() + "-lock"));
  ASSERT_THAT(read_file(path), HasSubstr("zzqforgotten"));
  forget_participant(path, "zzqforgotten");
  for (const fs::directory_entry& file : fs::directory_iterator(path.parent_path()))
    if (file.is_regular_file()) {
      EXPECT_EQ(read_file(file.path()).find("zzqforgotten"), std::string::npos) << file.path();
    }
  for (const char* table : {"participants", "sessions", "consents", "displays"})
    EXPECT_EQ(count(std::string("SELECT count(*) FROM ") + table), 1) << table;
  EXPECT_EQ(count("SELECT count(*) FROM form_answers"), 4);
  EXPECT_EQ(count("SELECT count(*) FROM training_answers"), 3);
  EXPECT_EQ(count("SELECT count(*) FROM answers"), 3);
  EXPECT_EQ(count("SELECT count(*) FROM events"), 0);
  EXPECT_FALSE(fs::exists(path.string() + "-lock"));
  EXPECT_EQ(complaint(set, path, {.code = "kept"}), "no complaint");
}

TEST_F(VisitStoreTest, StatusSaysWhoHasDoneWhat) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "p01"});
    (void)run(store, store.begin(), person);
    // Who has finished is in no session, though the window or the page is still open.
    EXPECT_THAT(status_text(read_log(path)),
                testing::AllOf(HasSubstr("the last page still open"), Not(HasSubstr("in a session"))));
    VisitStore pilot(set, path, {.code = "try", .pilot = true});
    (void)run(pilot, pilot.begin(), person, 2);
  }
  const std::string text = status_text(read_log(path));
  EXPECT_THAT(text, Not(HasSubstr("still open")));
  for (const char* part :
       {"complete", "pilot", "unfinished", "order 0", "last seen 20", " of 1", "references 1"})
    EXPECT_THAT(text, HasSubstr(part));
}

/// An adaptive study: the picture that was on the screen when the power failed is shown again.
TEST_F(VisitStoreTest, AnAdaptiveStudyPlansBeforeItShows) {
  std::string text = people_text("[quest_plus]\nmax_shows_per_image = 2\nmax_trials = 4\n");
  text.insert(text.find("[session]"), "procedure = \"quest_plus\"\n");
  const RenderedSet adaptive = write_set_of_text(folder / "adaptive", text);
  ScriptedPerson person(5);
  std::optional<Trial> shown;
  for (int answered = 0; answered < 30; ++answered) {
    std::optional<VisitStore> store;
    try {
      store.emplace(adaptive, path, Visitor{.code = "p01"});
    } catch (const InputError&) {
      break;
    }
    Visit visit = store->begin();
    while (!on<TrialScreen>(visit) && !is_over(visit))
      visit = store->step(std::move(visit), person.act(visit));
    if (shown) {
      EXPECT_EQ(trial_on_screen(visit), shown);
    }
    visit = run(*store, std::move(visit), person, answered + 1);
    shown = trial_on_screen(visit);
    const int decided = count("SELECT count(*) FROM trials");
    EXPECT_EQ(decided, answered_trials(visit.session.trials) + (is_over(visit) ? 0 : 1));
  }
  EXPECT_TRUE(read_log(path).participants[0].completed);
}

/// What people agreed to is kept, also when the text is edited between two of them.
TEST_F(VisitStoreTest, KeepsTheConsentTextThatEachPersonSaw) {
  ScriptedPerson person(5);
  {
    VisitStore store(set, path, {.code = "p01"});
    (void)store.step(store.begin(), ConsentGiven{});
  }
  std::string text = people_text();
  text.replace(text.find("Our own text."), 13, "Our new text.");
  write_file_atomically(folder / "set/study.toml", text);
  const RenderedSet edited = load_rendered_set(folder / "set");  // texts can be edited in a rendered set
  {
    VisitStore store(edited, path, {.code = "p02"});
    (void)store.step(store.begin(), ConsentGiven{});
  }
  EXPECT_EQ(
      count("SELECT count(*) FROM consents JOIN consent_texts USING (text_sha256) WHERE text LIKE '%new%'"),
      1);
  EXPECT_EQ(
      count("SELECT count(*) FROM consents JOIN consent_texts USING (text_sha256) WHERE text LIKE '%own%'"),
      1);
}

TEST_F(VisitStoreTest, SharedOrdersAreBalancedByCompletedSessions) {
  const RenderedSet shared = write_set_of_text(folder / "shared", people_text("", "orders = 3\n"));
  ScriptedPerson person(5);
  const auto visit = [&](const std::string& code, int answers) {
    VisitStore store(shared, path, {.code = code});
    (void)run(store, store.begin(), person, answers);
    for (const ParticipantRecord& record : read_log(path).participants)
      if (record.code == code) return record.slot;
    return -1;
  };
  EXPECT_EQ(visit("a", 1000), 0);
  EXPECT_EQ(visit("b", 2), 1);  // leaves
  EXPECT_EQ(visit("c", 1000), 2);
  EXPECT_EQ(visit("d", 1000), 1);  // nobody has completed it
  EXPECT_EQ(visit("e", 1000), 0);  // one each; the unfinished one counts against 1
  EXPECT_EQ(visit("f", 1000), 2);
  EXPECT_EQ(visit("g", 1000), 1);
  exclude_participant(path, "c");
  EXPECT_EQ(visit("h", 1000), 2);  // its place is free again
}

}  // namespace
}  // namespace seamline::study
