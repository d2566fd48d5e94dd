// Messages become rows of the log, each once; everything that contradicts the study or the log is refused.
#include "study/online/intake/intake.h"

#include <gmock/gmock.h>

#include <set>

#include "intake_fixture.h"
#include "study/log/log.h"
#include "study/log/log_admin.h"

namespace seamline::study::online {
namespace {

using test::complaint_of;
using testing::HasSubstr;

TEST_F(IntakeTest, AWholeVisitIsInTheLogAsOneOfTheWindowWouldBe) {
  {
    Intake intake(set, path);
    Page page = enrolled(intake, 1);
    EXPECT_EQ(page.slot, 0);
    EXPECT_EQ(intake.where(page.code).next_sequence, 1);
    take_all(intake, page.the_rest());
    const Whereabouts at = intake.where(page.code);
    EXPECT_TRUE(at.completed);
    EXPECT_TRUE(at.form_done);
    EXPECT_EQ(at.training_done, 2);
    EXPECT_EQ(at.answered.size(), 26U);
    EXPECT_EQ(at.next_sequence, page.sequence);
    EXPECT_TRUE(intake.gaps(page.code).empty());
  }
  const LogContents log = read_log(path);
  ASSERT_EQ(log.participants.size(), 1U);
  EXPECT_EQ(log.participants[0].origin, Origin::serve);
  EXPECT_TRUE(log.participants[0].completed);
  EXPECT_FALSE(log.participants[0].simulated);
  EXPECT_EQ(log.participants[0].form.size(), set.study.form.size());
  EXPECT_EQ(log.answers.size(), 24U);
  EXPECT_EQ(log.catches.size(), 2U);
  const Page page{.set = &set, .number = 1};
  for (const Answer& answer : log.answers) {
    EXPECT_EQ(answer.chosen_index, page.answer_to(answer.trial_index).chosen_index);
    EXPECT_EQ(answer.rating, page.answer_to(answer.trial_index).rating);
  }
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 5);
  EXPECT_EQ(database.execAndGet("SELECT content_scale FROM displays").getDouble(), 1.25);
  EXPECT_EQ(
      database.execAndGet("SELECT text FROM consents JOIN consent_texts USING (text_sha256)").getString(),
      "Our own text.");
  EXPECT_EQ(database.execAndGet("SELECT user_agent FROM online_sittings").getString(), "Mozilla/5.0 (test)");
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM online_messages").getInt(), 1 + 1 + 1 + 2 + 2 * 26 + 1);
}

TEST_F(IntakeTest, NobodyWhoHearsTheReplyLearnsTheRightAnswer) {
  Intake server(set, path);
  Page page = enrolled(server, 1);
  const Trial due = page.order()[0];
  Message guess = page.answer(0);
  std::vector<std::string> sentences;
  for (const ManifestStimulus& stimulus : set.manifest.stimuli) {  // the id of the planned one among them
    std::get<AnswerBody>(guess.body).answer.stimulus_id = stimulus.id;
    std::string sentence = refusal(server, guess);
    EXPECT_THAT(sentence, HasSubstr("wanted the planned"));
    sentence.replace(sentence.find(stimulus.id), stimulus.id.size(), "GUESS");
    sentences.push_back(sentence);
  }
  EXPECT_EQ(std::set(sentences.begin(), sentences.end()).size(), 1U) << "all are the same to who asks";
  EXPECT_THAT(sentences.front(), HasSubstr(ShownNames(set).name_of(due)));
  Message practice = page.training(0);
  std::get<TrainingBody>(practice.body).answer.stimulus_id = page.id_of(training_trials(set)[0]);
  EXPECT_THAT(refusal(server, practice), HasSubstr("wanted the planned"));
  EXPECT_EQ(rows("answers") + rows("training_answers"), 0);
}

TEST_F(IntakeTest, ARefusalDoesNotTellTheRightAnswer) {
  Intake intake(set, path);
  Page page = enrolled(intake, 1);
  const std::vector<Trial> trials = page.order();
  const std::string sentence = refusal(intake, page.answer(trials[1], page.answer_to(0)));
  EXPECT_THAT(sentence, testing::Not(HasSubstr(page.id_of(trials[0]))));
  EXPECT_THAT(sentence, HasSubstr(ShownNames(set).name_of(trials[0])));
}

TEST_F(IntakeTest, AMessageThatCameBeforeIsTakenOnce) {
  Intake intake(set, path);
  Page page = enrolled(intake, 1);
  const std::vector<Message> messages = page.the_rest();
  for (const Message& message : messages) {
    EXPECT_TRUE(take(intake, message));
    EXPECT_FALSE(take(intake, message));
  }
  for (const Message& message : messages) EXPECT_FALSE(take(intake, message));
  EXPECT_EQ(rows("answers"), 26);
  EXPECT_EQ(rows("events"), 26);
  EXPECT_EQ(rows("training_answers"), 2);
}

TEST_F(IntakeTest, AnotherProgramGoesOnWhereTheLastOneEnded) {
  Page page{.set = &set, .number = 1};
  const Message enrolment = page.enrol();
  {
    Intake intake(set, path);
    intake.transaction([&] { page.slot = intake.enrol(enrolment, given(1)).slot; });
  }
  page.code = "s-1";
  for (const Message& message : page.the_rest()) {
    Intake intake(set, path);
    EXPECT_TRUE(take(intake, message));
    EXPECT_EQ(intake.where("s-1").next_sequence, message.sequence + 1);
  }
  EXPECT_EQ(rows("sessions"), 1);
  EXPECT_TRUE(read_log(path).participants[0].completed);
}

TEST_F(IntakeTest, TheSameEnrolmentFindsTheSamePersonAgainUntilTheyBegin) {
  Intake intake(set, path);
  Page page{.set = &set, .number = 1};
  const Message message = page.enrol();
  intake.transaction([&] { EXPECT_TRUE(intake.enrol(message, given(1)).is_new); });
  intake.transaction([&] {
    const EnrolledPerson again = intake.enrol(message, given(2));
    EXPECT_FALSE(again.is_new);
    EXPECT_EQ(again.code, "s-1");
  });
  EXPECT_EQ(intake.secrets(), (std::map<std::string, std::string>{{sha256("secret 2"), "s-1"}}));
  page.code = "s-1";
  page.slot = 0;
  EXPECT_TRUE(take(intake, page.form()));
  EXPECT_THAT(complaint_of([&] { intake.transaction([&] { (void)intake.enrol(message, given(3)); }); }),
              HasSubstr("somebody who has begun"));
  EXPECT_EQ(rows("participants"), 1);
}

TEST_F(IntakeTest, NewcomersGetTheSlotThatTheFewestHaveCompleted) {
  Intake intake(set, path);
  EXPECT_EQ(enrolled(intake, 1).slot, 0);
  EXPECT_EQ(enrolled(intake, 2).slot, 1);
  exclude_participant(path, "s-1");
  EXPECT_EQ(enrolled(intake, 3).slot, 0);
  Page few{.set = &set, .number = 4};
  GivenIdentity with_few = given(4);
  with_few.slots = 2;  // the page has no third order: people share
  const Message message = few.enrol();
  intake.transaction([&] { EXPECT_EQ(intake.enrol(message, with_few).slot, 0); });

  std::string text = online_study_text("64");
  text.insert(text.find("break_every_trials"), "orders = 2\n");
  const RenderedSet shared = write_set_of_text(folder / "shared", text);
  Intake of_two(shared, folder / "shared.sqlite");
  for (int number = 0; number < 6; ++number) {
    Page page{.set = &shared, .number = static_cast<std::uint64_t>(20 + number)};
    const Message enrolment = page.enrol();
    of_two.transaction([&] { page.slot = of_two.enrol(enrolment, given(page.number)).slot; });
    page.code = given(page.number).code;
    EXPECT_EQ(page.slot, number == 0 ? 0 : 1);  // the second order is completed by nobody
    if (page.slot == 0) take_all(of_two, page.the_rest());
  }
}

TEST_F(IntakeTest, EverythingThatContradictsTheStudyOrTheLogIsRefusedAndStoresNothing) {
  Intake intake(set, path);
  Page page = enrolled(intake, 1);
  (void)enrolled(intake, 2);
  Message other_study = page.form();
  --page.sequence;
  other_study.study_hash = std::string(64, 'e');
  EXPECT_THAT(refusal(intake, other_study), HasSubstr("this log's study"));
  Message other_set = page.form();
  --page.sequence;
  other_set.set_hash = std::string(64, 'e');
  EXPECT_THAT(refusal(intake, other_set), HasSubstr("this log's set"));

  Message unknown = page.form();
  --page.sequence;
  unknown.participant = "s-99";
  EXPECT_THAT(refusal(intake, unknown), HasSubstr("one who is enrolled"));

  Message form = page.form();
  std::get<FormBody>(form.body).answers.push_back({"shoe_size", "43"});
  EXPECT_THAT(refusal(intake, form), HasSubstr("fields of the study's form"));
  std::get<FormBody>(form.body).answers = {{"age", "a hundred"}};
  EXPECT_THAT(refusal(intake, form), HasSubstr("no number"));
  --page.sequence;
  EXPECT_TRUE(take(intake, page.form()));
  EXPECT_THAT(refusal(intake, page.form()), HasSubstr("one form"));
  --page.sequence;

  Message same_number = page.answer(0);
  same_number.sequence = 1;
  EXPECT_THAT(refusal(intake, same_number), HasSubstr("which another message of s-1 has"));
  --page.sequence;
  Message same_id = page.answer(0);
  same_id.id = uuid_of(1, 1);  // the form's
  EXPECT_THAT(refusal(intake, same_id), HasSubstr("an id of its own"));
  same_id.participant = "s-2";
  EXPECT_THAT(refusal(intake, same_id), HasSubstr("an id of its own"));
  --page.sequence;

  const std::vector<Trial> trials = page.order();
  Message other_stimulus = page.answer(trials[1], page.answer_to(0));
  EXPECT_THAT(refusal(intake, other_stimulus), HasSubstr("wanted the planned"));
  Message other_kind = other_stimulus;
  std::get<AnswerBody>(other_kind.body).answer.stimulus_id = ShownNames(set).name_of(trials[0]);
  std::get<AnswerBody>(other_kind.body).answer.kind = TrialKind::attention;
  EXPECT_THAT(refusal(intake, other_kind), HasSubstr("wanted the planned"));
  Message too_far = page.answer(trials[0], page.answer_to(26));
  EXPECT_THAT(refusal(intake, too_far), HasSubstr("26 planned trials"));
  EXPECT_THAT(refusal(intake, page.say(TrainingBody{.training_index = 9, .answer = {}})),
              HasSubstr("practice trials"));
  EXPECT_THAT(refusal(intake, page.say(CompletionBody{})), HasSubstr("0 of 26 answered"));
  EXPECT_EQ(rows("answers"), 0);
  EXPECT_EQ(rows("online_messages"), 3);

  page.sequence = 2;
  EXPECT_TRUE(take(intake, page.answer(0)));
  page.sequence = 70;
  EXPECT_THAT(refusal(intake, page.answer(0)), HasSubstr("one answer to a trial"));
  page.sequence = 3;
  for (int i = 1; i < 26; ++i) EXPECT_TRUE(take(intake, page.answer(i)));
  EXPECT_TRUE(take(intake, page.say(CompletionBody{})));
  EXPECT_THAT(refusal(intake, page.answer(25)), HasSubstr("an answer after the end"));
  EXPECT_THAT(refusal(intake, page.say(CompletionBody{})), HasSubstr("one completion"));
  EXPECT_EQ(rows("answers"), 26);
}

TEST_F(IntakeTest, ATransactionThatFailsLeavesNothingAndIsForgotten) {
  Intake intake(set, path);
  Page page = enrolled(intake, 1);
  const Message form = page.form(), answer = page.answer(0);
  EXPECT_THROW(intake.transaction([&] {
    EXPECT_TRUE(intake.take(form));
    EXPECT_TRUE(intake.take(answer));
    throw input_error({.wanted = "a disk", .found = "none"});
  }),
               InputError);
  EXPECT_EQ(intake.where("s-1").next_sequence, 1);
  EXPECT_FALSE(intake.where("s-1").form_done);
  EXPECT_TRUE(take(intake, form));
  EXPECT_TRUE(take(intake, answer));
}

TEST_F(IntakeTest, WhoeverReadNoConsentOrTheShippedOneIsNotEnrolled) {
  Intake intake(set, path);
  Page page = page_elsewhere(set, 1);
  Message message = page.enrol();
  std::get<EnrolBody>(message.body).consent_sha256 = std::string(64, 'f');
  EXPECT_THAT(refusal(intake, message), HasSubstr("of this study's consent"));
  EXPECT_EQ(rows("participants"), 0);

  const RenderedSet shipped = write_set_of_text(folder / "shipped", study_text("online", "64"));
  Intake other(shipped, folder / "shipped.sqlite");
  Page person = page_elsewhere(shipped, 1);
  EXPECT_THAT(complaint_of([&] {
                const Message enrolment = person.enrol();
                other.transaction([&] { (void)other.take(enrolment); });
              }),
              HasSubstr("a pilot"));
  Page pilot = page_elsewhere(shipped, 2);
  pilot.pilot = true;
  EXPECT_TRUE(take(other, pilot.enrol()));
  EXPECT_TRUE(read_log(folder / "shipped.sqlite").participants[0].pilot);
}

TEST_F(IntakeTest, WhoDeclinesIsCountedOnceAndNotKnown) {
  Intake intake(set, path);
  Page page{.set = &set, .number = 5};
  const Message decline = page.say(DeclineBody{});
  EXPECT_TRUE(take(intake, decline));
  EXPECT_FALSE(take(intake, decline));
  EXPECT_EQ(read_log(path).declined_visits, 1);
  EXPECT_EQ(rows("participants"), 0);
}

}  // namespace
}  // namespace seamline::study::online
