// The log that browsers answer into: shared with the window, deleted from, saved, and placing adaptive
// trials.
#include <gmock/gmock.h>

#include "intake_fixture.h"
#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "study/log/recovery/log_recovery.h"
#include "study/running/participant_session.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;

class IntakeLog : public IntakeTest {};

TEST_F(IntakeLog, ForgettingLeavesNothingOfSomebody) {
  {
    Intake intake(set, path);
    Page page = enrolled(intake, 1), other = enrolled(intake, 2);
    take_all(intake, page.the_rest());
    take_all(intake, other.the_rest());
    EXPECT_THAT(complaint_of([&] { forget_participant(path, "s-1"); }),
                HasSubstr("no other program has in use"));
  }
  forget_participant(path, "s-1");
  const std::string bytes = read_file(path);
  for (const std::string& trace : {std::string("s-1"), sha256("secret 1"), uuid_of(1, 0), uuid_of(1, 5)})
    EXPECT_EQ(bytes.find(trace), std::string::npos) << trace;
  EXPECT_EQ(rows("answers"), 26);
  EXPECT_EQ(rows("online_participants"), 1);
  EXPECT_EQ(rows("online_sittings"), 1);
}

TEST_F(IntakeLog, ALogOfTheWindowBecomesOneOfBothAndTheWindowGoesOnInIt) {
  const auto window = [&](const std::string& code, int answers) {
    LogWriter log(path, set);
    OpenSession session = enter_session(log, {.code = code}, 0);
    (void)open_trials(make_trial_rules(set), log, session);
    const Page answers_of{.set = &set, .number = 77};
    for (int i = 0; i < answers; ++i) log.append_answer(session, answers_of.answer_to(session.answered));
    return session.slot;
  };
  EXPECT_EQ(window("p01", 5), 0);
  const LogContents before = read_log(path);
  {
    Intake intake(set, path);
    EXPECT_EQ(enrolled(intake, 1).slot, 1);
  }
  EXPECT_EQ(window("p01", 3), 0);
  EXPECT_EQ(window("p02", 3), 2);
  EXPECT_THAT(complaint_of([&] { (void)window("s-1", 1); }), HasSubstr("wanted a participant of the window"));
  Intake intake(set, path);
  Page page{.set = &set, .number = 9, .code = "p01", .slot = 0, .sequence = 5};
  EXPECT_THAT(refusal(intake, page.form()), HasSubstr("one of the window"));
  const LogContents log = read_log(path);
  EXPECT_EQ(log.answers.size() + log.catches.size(), 11U);
  ASSERT_EQ(log.participants.size(), 3U);
  EXPECT_EQ(log.participants[0].origin, Origin::window);
  EXPECT_EQ(log.participants[1].origin, Origin::serve);
  for (std::size_t i = 0; i < before.answers.size(); ++i)
    EXPECT_EQ(log.answers[i].rating, before.answers[i].rating);
}

TEST_F(IntakeLog, ADamagedLogOfBrowsersIsSavedWithWhatTheySaid) {
  {
    Intake intake(set, path);
    Page page = enrolled(intake, 1);
    take_all(intake, page.the_rest());
  }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec("CREATE VIEW v AS SELECT 1");
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("log recover"));
  const fs::path saved = folder / "saved.sqlite";
  const LogRecovery recovery = recover_log(path, saved, {});
  EXPECT_TRUE(recovery.refused.empty());
  EXPECT_EQ(recovery.saved.at("online_messages"), 58);
  EXPECT_EQ(read_log(saved).participants.at(0).origin, Origin::serve);
  Intake intake(set, saved);
  EXPECT_TRUE(intake.where("s-1").completed);
  EXPECT_EQ(intake.secrets().size(), 1U);
}

std::string adaptive_text() {
  std::string text = online_study_text("64, 128, 256, 512, 1024", "");
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\nmax_shows_per_image = 3\nmax_trials = 6\n");
  return text;
}

TEST_F(IntakeLog, TheServerPlacesTheNextTrialOfAnAdaptiveStudyAsTheWindowDoes) {
  const RenderedSet adaptive = write_set_of_text(folder / "adaptive", adaptive_text());
  Page page{.set = &adaptive, .number = 3};
  std::vector<Trial> shown;
  {
    Intake intake(adaptive, path);
    const Message enrolment = page.enrol();
    intake.transaction([&] { page.slot = intake.enrol(enrolment, given(3)).slot; });
  }
  page.code = "s-3";
  for (;;) {
    Intake intake(adaptive, path);  // another program each time: nothing is remembered
    std::optional<std::pair<int, Trial>> due, again;
    intake.transaction([&] { due = intake.next_trial("s-3"); });
    intake.transaction([&] { again = intake.next_trial("s-3"); });
    EXPECT_EQ(due, again);
    if (!due) break;
    ASSERT_EQ(due->first, static_cast<int>(shown.size()));
    shown.push_back(due->second);
    const Message early = page.answer(due->second, page.answer_to(due->first + 1));
    --page.sequence;
    EXPECT_THAT(refusal(intake, early), HasSubstr("planned trials"));
    EXPECT_TRUE(take(intake, page.answer(due->second, page.answer_to(due->first))));
    ASSERT_LT(shown.size(), 100U);
  }
  {
    Intake intake(adaptive, path);
    EXPECT_TRUE(take(intake, page.say(CompletionBody{})));
  }
  // The window, with the same answers.
  LogWriter log(folder / "window.sqlite", adaptive);
  const TrialRules rules = make_trial_rules(adaptive);
  OpenSession place = enter_session(log, {.code = "p1"}, 0);
  TrialSequence sequence = open_trials(rules, log, place);
  std::vector<Trial> of_window;
  while (const std::optional<Trial> due = current_trial(sequence)) {
    store_due_trial(sequence, log, place);
    const TrialAnswer answer = page.answer_to(place.answered);
    log.append_answer(place, answer);
    sequence = after_answer(std::move(sequence), answer);
    of_window.push_back(*due);
  }
  EXPECT_EQ(shown, of_window);
  EXPECT_GT(shown.size(), 10U);
}

}  // namespace
}  // namespace seamline::study::online
