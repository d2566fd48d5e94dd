#include "study/visit/visit.h"

#include <gtest/gtest.h>

#include "small_visit.h"

namespace seamline::study {
namespace {

TEST(Visit, GoesFromConsentToThanks) {
  std::vector<std::size_t> screens;
  std::vector<std::size_t> records;
  ScriptedPerson person(1);
  Visit visit = begin_visit(shared(script()));
  for (int i = 0; i < 10000 && !is_over(visit); ++i) {
    if (screens.empty() || screens.back() != visit.screen.index()) screens.push_back(visit.screen.index());
    visit = next(std::move(visit), person.act(visit));
    if (visit.pending) records.push_back(visit.pending->index());
    while (visit.pending) {
      const bool last = std::holds_alternative<CompletionRecord>(*visit.pending);
      visit = std::holds_alternative<ConsentRecord>(*visit.pending)
                  ? next(std::move(visit), Enrolled{trials(7)})
                  : next(std::move(visit), RecordStored{});
      if (!last && visit.pending) records.push_back(visit.pending->index());
    }
  }
  EXPECT_TRUE(on<ThanksScreen>(visit));
  const auto place = [](const Screen& screen) { return screen.index(); };
  EXPECT_EQ(screens,
            (std::vector<std::size_t>{
                place(ConsentScreen{}), place(FormScreen{}), place(DisplayScreen{}),
                place(InstructionScreen{}), place(TrainingScreen{}), place(FeedbackScreen{}),
                place(TrainingScreen{}), place(FeedbackScreen{}), place(ReadyScreen{}), place(TrialScreen{}),
                place(BreakScreen{}), place(TrialScreen{}), place(BreakScreen{}), place(TrialScreen{})}));
  const auto kind = [](const Record& record) { return record.index(); };
  std::vector<std::size_t> expected = {kind(ConsentRecord{}), kind(FormRecord{}), kind(DisplayRecord{}),
                                       kind(TrainingRecord{}), kind(TrainingRecord{})};
  expected.insert(expected.end(), 7, kind(AnswerRecord{}));
  expected.push_back(kind(CompletionRecord{}));
  EXPECT_EQ(records, expected);
}

TEST(Visit, DecliningEndsPolitelyAndAsksForTheFactAlone) {
  Visit visit = next(begin_visit(shared(script())), ConsentRefused{});
  ASSERT_TRUE(visit.pending && std::holds_alternative<DeclineRecord>(*visit.pending));
  EXPECT_FALSE(is_over(visit));
  visit = next(std::move(visit), RecordStored{});
  EXPECT_TRUE(on<DeclinedScreen>(visit));
  EXPECT_TRUE(is_over(visit));
  EXPECT_TRUE(
      on<DeclinedScreen>(after(visit, {ConsentGiven{}, Continued{}, PauseBegun{}, StoreFailed{"x"}})));
}

TEST(Visit, NothingGoesOnWhileSomethingIsToBeStored) {
  const Visit consenting = next(begin_visit(shared(script())), ConsentGiven{.unix_s = 7});
  ASSERT_TRUE(consenting.pending);
  EXPECT_EQ(std::get<ConsentRecord>(*consenting.pending).accepted_unix_s, 7);
  const Visit still = after(consenting, {ConsentRefused{}, Continued{}, PauseBegun{}, RecordStored{}});
  EXPECT_TRUE(on<ConsentScreen>(still) && still.pending);
  EXPECT_TRUE(on<FormScreen>(next(still, Enrolled{trials(3)})));
  EXPECT_TRUE(on<FormScreen>(after(stored(consenting), {Enrolled{trials(9)}, RecordStored{}})));

  const Visit storing = after(until<TrialScreen>(begin_visit(shared(script()))),
                              {Event(Tick{0}), Event(Tick{second}), Event(ImageShown{second}),
                               Event(ObjectChosen{.index = 2, .now_ns = 2 * second}),
                               Event(RatingGiven{.rating = 3, .now_ns = 3 * second})});
  ASSERT_TRUE(storing.pending);
  const Visit hammered = after(storing, {Event(AnswerStored{}), Event(RatingGiven{1, 4 * second}),
                                         PauseBegun{}, Event(ObjectChosen{1, 4 * second}), Continued{}});
  EXPECT_EQ(
      std::get<AnswerRecord>(*hammered.pending).answer,
      (TrialAnswer{
          .trial_index = 0, .chosen_index = 2, .rating = 3, .choice_ns = second, .rating_ns = 2 * second}));
  EXPECT_EQ(answered_trials(next(hammered, RecordStored{}).session.trials), 1);
}

TEST(Visit, AFormWithProblemsStaysAndNamesThem) {
  Visit visit = stored(next(begin_visit(shared(script())), ConsentGiven{}));
  std::vector<FormAnswer> answers = ScriptedPerson::form();
  answers[0].value = "17";
  answers[2].value.clear();
  visit = next(std::move(visit), FormSubmitted{answers});
  EXPECT_FALSE(visit.pending);
  ASSERT_TRUE(on<FormScreen>(visit));
  EXPECT_EQ(std::get<FormScreen>(visit.screen).problems,
            (std::vector<FormProblem>{{"age", FormFault::out_of_range}, {"vision", FormFault::missing}}));
  answers = ScriptedPerson::form();
  answers.push_back({"name", "Ada Lovelace"});  // nobody asked
  visit = next(std::move(visit), FormSubmitted{answers});
  ASSERT_TRUE(visit.pending);
  EXPECT_EQ(std::get<FormRecord>(*visit.pending).answers, ScriptedPerson::form());
  EXPECT_TRUE(on<DisplayScreen>(stored(visit)));
}

TEST(Visit, InstructionsTurnBothWays) {
  Visit visit = until<InstructionScreen>(begin_visit(shared(script())));
  const auto page = [&] { return std::get<InstructionScreen>(visit.screen).page; };
  visit = next(visit, WentBack{});
  EXPECT_EQ(page(), 0);
  visit = next(visit, Continued{});
  EXPECT_EQ(page(), 1);
  visit = next(visit, WentBack{});
  EXPECT_EQ(page(), 0);
  EXPECT_TRUE(on<TrainingScreen>(after(visit, {Continued{}, Continued{}})));
}

TEST(Visit, TrainingTellsWhetherTheChoiceWasRight) {
  Visit visit = until<TrainingScreen>(begin_visit(shared(script())));
  for (const int right : {1, 2}) {
    EXPECT_EQ(trial_on_screen(visit)->stimulus, right == 1 ? 3 : 5);
    visit = after(visit, {Event(Tick{0}), Event(Tick{second}), Event(ImageShown{0}),
                          Event(ObjectChosen{.index = 1, .now_ns = second}),
                          Event(RatingGiven{.rating = 4, .now_ns = second})});
    ASSERT_TRUE(visit.pending);
    EXPECT_EQ(std::get<TrainingRecord>(*visit.pending).answer.trial_index, right - 1);
    visit = stored(visit);
    const auto feedback = std::get<FeedbackScreen>(visit.screen);
    EXPECT_EQ(feedback.right_index, right);
    EXPECT_EQ(feedback.right(), right == 1);
    EXPECT_EQ(trial_on_screen(visit)->stimulus, right == 1 ? 3 : 5);
    EXPECT_TRUE(on<FeedbackScreen>(after(visit, {Event(ObjectChosen{2, 9 * second}), WentBack{}})));
    visit = next(visit, Continued{});
  }
  EXPECT_TRUE(on<ReadyScreen>(visit));
}

TEST(Visit, AnEarlyChoiceDoesNotCountAndGreyComesFirst) {
  Visit visit = until<TrialScreen>(begin_visit(shared(script())));
  EXPECT_TRUE(std::holds_alternative<Grey>(visit.session.phase));
  visit = after(visit, {Event(Tick{100}), Event(Tick{100 + second / 2 - 1}), Event(ImageShown{5})});
  EXPECT_TRUE(std::holds_alternative<Grey>(visit.session.phase));
  visit = next(visit, Event(Tick{100 + second / 2}));
  EXPECT_TRUE(std::holds_alternative<AwaitingImage>(visit.session.phase));
  visit = after(visit, {Event(ImageShown{second}), Event(ObjectChosen{1, second + second / 2 - 1})});
  EXPECT_TRUE(std::holds_alternative<Choosing>(visit.session.phase));
  visit = next(visit, Event(ObjectChosen{1, second + second / 2}));
  EXPECT_TRUE(std::holds_alternative<Rating>(visit.session.phase));
}

TEST(Visit, APauseTakesThePictureAwayAndTheTrialBeginsAgain) {
  const Visit rating = after(until<TrialScreen>(begin_visit(shared(script()))),
                             {Event(Tick{0}), Event(Tick{second}), Event(ImageShown{second}),
                              Event(ObjectChosen{.index = 2, .now_ns = 2 * second})});
  ASSERT_TRUE(std::holds_alternative<Rating>(rating.session.phase));
  const Visit paused = next(rating, PauseBegun{});
  ASSERT_TRUE(on<PauseScreen>(paused));
  EXPECT_EQ(trial_on_screen(paused), std::nullopt);
  EXPECT_TRUE(
      on<PauseScreen>(after(paused, {PauseBegun{}, Event(RatingGiven{1, 9 * second}), Event(Tick{0})})));
  const Visit back = next(paused, Continued{});
  ASSERT_TRUE(on<TrialScreen>(back));
  EXPECT_TRUE(std::holds_alternative<Grey>(back.session.phase));
  EXPECT_EQ(trial_on_screen(back), trial_on_screen(rating));
  const Visit answered =
      after(back, {Event(Tick{20 * second}), Event(Tick{21 * second}), Event(ImageShown{21 * second}),
                   Event(ObjectChosen{.index = 3, .now_ns = 22 * second}),
                   Event(RatingGiven{.rating = 1, .now_ns = 23 * second})});
  EXPECT_EQ(
      std::get<AnswerRecord>(*answered.pending).answer,
      (TrialAnswer{
          .trial_index = 0, .chosen_index = 3, .rating = 1, .choice_ns = second, .rating_ns = 2 * second}));
}

TEST(Visit, PausesWhereItCanAndGoesBackThere) {
  Visit visit = begin_visit(shared(script()));
  EXPECT_TRUE(on<ConsentScreen>(next(visit, PauseBegun{})));
  for (visit = until<InstructionScreen>(visit); !on<ThanksScreen>(visit);) {
    const Visit again = after(visit, {PauseBegun{}, Continued{}});
    EXPECT_EQ(again.screen.index(), visit.screen.index());
    ScriptedPerson person(1);
    visit = stored(next(again, person.act(again)));
    for (int i = 0; i < 6 && (on<TrainingScreen>(visit) || on<TrialScreen>(visit)); ++i)
      visit = stored(next(visit, person.act(visit)));
  }
}

TEST(Visit, BreaksWaitForThePerson) {
  Visit visit = until<BreakScreen>(begin_visit(shared(script())));
  EXPECT_EQ(answered_trials(visit.session.trials), 3);
  EXPECT_TRUE(on<BreakScreen>(
      after(visit, {Event(ImageShown{0}), Event(BreakEnded{}), Event(ObjectChosen{1, 0}), WentBack{}})));
  EXPECT_TRUE(on<TrialScreen>(next(visit, Continued{})));
}

TEST(Visit, AFailedStoreStopsTheVisitWithItsMessage) {
  ScriptedPerson person(1);
  Visit visit = begin_visit(shared(script()));
  for (int records = 0; !is_over(visit);) {
    const bool was_pending = visit.pending.has_value();
    if (was_pending) {
      const Visit stopped = next(visit, StoreFailed{"the disk is full"});
      ASSERT_TRUE(on<StoppedScreen>(stopped));
      EXPECT_EQ(std::get<StoppedScreen>(stopped.screen).message, "the disk is full");
      EXPECT_TRUE(is_over(stopped));
      EXPECT_TRUE(on<StoppedScreen>(after(stopped, {Continued{}, RecordStored{}, Enrolled{trials(2)}})));
      ++records;
    }
    visit = std::holds_alternative<ConsentScreen>(visit.screen) && was_pending
                ? next(std::move(visit), Enrolled{trials(4)})
            : was_pending ? next(std::move(visit), RecordStored{})
                          : next(std::move(visit), person.act(visit));
    ASSERT_LT(records, 100);
  }
  EXPECT_TRUE(on<ThanksScreen>(visit));
  EXPECT_TRUE(on<ThanksScreen>(next(visit, StoreFailed{"late"}))) << "everything is stored by then";
}

TEST(Visit, WhoComesAgainSkipsConsentAndFormButNotInstructionsAndTraining) {
  Visit visit = resume_visit(shared(script()), true, trials(7, 4));
  EXPECT_TRUE(on<DisplayScreen>(visit));
  EXPECT_TRUE(on<TrainingScreen>(until<TrainingScreen>(visit)));
  visit = until<TrialScreen>(visit);
  EXPECT_EQ(trial_on_screen(visit), (Trial{TrialKind::stimulus, 14}));
  EXPECT_TRUE(on<ThanksScreen>(until<ThanksScreen>(visit)));
  EXPECT_TRUE(on<FormScreen>(resume_visit(shared(script()), false, trials(7, 4))));
}

/// Killed between the last answer and the completion.
TEST(Visit, WhoHasNothingLeftOnlyNeedsTheCompletion) {
  const Visit visit = resume_visit(shared(script()), true, trials(7, 7));
  ASSERT_TRUE(visit.pending && std::holds_alternative<CompletionRecord>(*visit.pending));
  EXPECT_TRUE(on<ThanksScreen>(next(visit, RecordStored{})));
}

TEST(Visit, EmptyPartsArePassedOver) {
  const VisitScript bare{.pace = {}};
  Visit visit = stored(next(begin_visit(shared(bare)), ConsentGiven{}), 1);
  EXPECT_TRUE(on<DisplayScreen>(visit));
  visit = stored(next(visit, DisplayConfirmed{}));
  EXPECT_TRUE(on<ReadyScreen>(visit));
  EXPECT_TRUE(on<ThanksScreen>(until<ThanksScreen>(visit)));
}

}  // namespace
}  // namespace seamline::study
