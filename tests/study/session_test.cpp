#include "study/visit/session.h"

#include <gtest/gtest.h>

#include <numeric>

#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

TrialSequence constant(int trials, int answered = 0) {
  ConstantProcedure procedure{.order = std::vector<int>(static_cast<std::size_t>(trials)),
                              .answered = answered};
  std::iota(procedure.order.begin(), procedure.order.end(), 100);
  return {.procedure = procedure};
}

template <class Wanted>
bool is(const Session& session) {
  return std::holds_alternative<Wanted>(session.phase);
}

Session after(Session session, const std::vector<Event>& events) {
  for (const Event& event : events) session = next(std::move(session), event);
  return session;
}

TEST(Session, GoesFromImageToChoiceToRatingToStoredAnswer) {
  Session session = begin_session(constant(2), {.break_every_trials = 0});
  EXPECT_TRUE(is<AwaitingImage>(session));
  EXPECT_EQ(current_trial(session.trials), (Trial{.stimulus = 100}));
  session = next(session, ImageShown{.now_ns = 1000});
  EXPECT_TRUE(is<Choosing>(session));
  session = next(session, ObjectChosen{.index = 3, .now_ns = 1500});
  EXPECT_TRUE(is<Rating>(session));
  session = next(session, RatingGiven{.rating = 2, .now_ns = 1900});
  ASSERT_TRUE(is<Storing>(session));
  EXPECT_EQ(
      std::get<Storing>(session.phase).answer,
      (TrialAnswer{.trial_index = 0, .chosen_index = 3, .rating = 2, .choice_ns = 500, .rating_ns = 900}));
  session = next(session, AnswerStored{});
  EXPECT_TRUE(is<AwaitingImage>(session));
  EXPECT_EQ(current_trial(session.trials), (Trial{.stimulus = 101}));
  session =
      after(session, {ImageShown{}, ObjectChosen{.index = 1}, RatingGiven{.rating = 1}, AnswerStored{}});
  EXPECT_TRUE(is<Done>(session));
  EXPECT_EQ(current_trial(session.trials), std::nullopt);
}

TEST(Session, CannotSkipTheChoiceOrTheRating) {
  const Session choosing = after(begin_session(constant(2), {.break_every_trials = 0}), {ImageShown{}});
  EXPECT_TRUE(
      is<Choosing>(after(choosing, {RatingGiven{.rating = 4}, AnswerStored{}, BreakEnded{}, ImageShown{}})));
  const Session rating = after(choosing, {ObjectChosen{.index = 2}});
  EXPECT_TRUE(is<Rating>(after(rating, {AnswerStored{}, BreakEnded{}, ImageShown{}})));
}

TEST(Session, TheLastChoiceBeforeTheRatingCountsAndNoneAfterIt) {
  const Session rating =
      after(begin_session(constant(1), {.break_every_trials = 0}),
            {ImageShown{.now_ns = 10}, ObjectChosen{.index = 2, .now_ns = 20},
             ObjectChosen{.index = 3, .now_ns = 40}, RatingGiven{.rating = 1, .now_ns = 50}});
  const Session late =
      after(rating, {ObjectChosen{.index = 1, .now_ns = 60}, RatingGiven{.rating = 4, .now_ns = 70}});
  ASSERT_TRUE(is<Storing>(late));
  EXPECT_EQ(
      std::get<Storing>(late.phase).answer,
      (TrialAnswer{.trial_index = 0, .chosen_index = 3, .rating = 1, .choice_ns = 30, .rating_ns = 40}));
}

TEST(Session, IgnoresNumbersOutOfRangeAndTimesThatRunBackwards) {
  const Session choosing =
      after(begin_session(constant(1), {.break_every_trials = 0}), {ImageShown{.now_ns = 100}});
  for (const int index : {-1, 0, 4, 1000})
    EXPECT_TRUE(is<Choosing>(next(choosing, ObjectChosen{.index = index, .now_ns = 200})));
  EXPECT_TRUE(is<Choosing>(next(choosing, ObjectChosen{.index = 1, .now_ns = 99})));
  const Session rating = next(choosing, ObjectChosen{.index = 1, .now_ns = 200});
  for (const int value : {-1, 0, 5, 1000})
    EXPECT_TRUE(is<Rating>(next(rating, RatingGiven{.rating = value, .now_ns = 300})));
  EXPECT_TRUE(is<Rating>(next(rating, RatingGiven{.rating = 1, .now_ns = 199})));
  const Session kept = next(rating, ObjectChosen{.index = 9, .now_ns = 250});
  EXPECT_EQ(std::get<Rating>(kept.phase).chosen_index, 1);
}

TEST(Session, BreaksAfterEveryNAnswersButNotAfterTheLast) {
  Session session = begin_session(constant(9), {.break_every_trials = 3});
  std::vector<int> breaks;
  while (!is<Done>(session)) {
    session =
        after(session, {ImageShown{}, ObjectChosen{.index = 1}, RatingGiven{.rating = 1}, AnswerStored{}});
    if (!is<OnBreak>(session)) continue;
    breaks.push_back(answered_trials(session.trials));
    EXPECT_TRUE(is<OnBreak>(after(session, {ImageShown{}, ObjectChosen{.index = 1}, AnswerStored{}})));
    session = next(session, BreakEnded{});
  }
  EXPECT_EQ(breaks, (std::vector<int>{3, 6}));
}

TEST(Session, ResumesAtTheFirstUnansweredTrial) {
  Session session = begin_session(constant(5, 3), {.break_every_trials = 3});
  EXPECT_TRUE(is<AwaitingImage>(session));
  EXPECT_EQ(current_trial(session.trials), (Trial{.stimulus = 103}));
  session = after(session, {ImageShown{}, ObjectChosen{.index = 1}, RatingGiven{.rating = 1}});
  EXPECT_EQ(std::get<Storing>(session.phase).answer.trial_index, 3);
  EXPECT_TRUE(is<Done>(begin_session(constant(5, 5), {.break_every_trials = 3})));
  EXPECT_TRUE(is<Done>(begin_session(constant(0), {.break_every_trials = 3})));
}

Event random_event(Random& random, std::int64_t now_ns) {
  switch (random.below(5)) {
    case 0:
      return ImageShown{.now_ns = now_ns};
    case 1:
      return ObjectChosen{.index = static_cast<int>(random.below(6)) - 1, .now_ns = now_ns};
    case 2:
      return RatingGiven{.rating = static_cast<int>(random.below(7)) - 1, .now_ns = now_ns};
    case 3:
      return AnswerStored{};
    default:
      return BreakEnded{};
  }
}

/// Whatever keys are hammered: answers are complete, come once a trial and in order, and no image is due
/// while an answer waits to be stored.
TEST(Session, LawsHoldUnderRandomEvents) {
  Random random(2024);
  for (int run = 0; run < 200; ++run) {
    Session session = begin_session(constant(12), {.break_every_trials = 5});
    int answers = 0;
    for (std::int64_t now_ns = 1; !is<Done>(session); ++now_ns) {
      ASSERT_LT(now_ns, 100000);
      const Event event = random_event(random, now_ns);
      const bool was_storing = is<Storing>(session);
      session = next(std::move(session), event);
      if (was_storing && !is<Storing>(session)) {
        ASSERT_TRUE(std::holds_alternative<AnswerStored>(event));
        ASSERT_EQ(answered_trials(session.trials), answers);
      }
      if (!was_storing && is<Storing>(session)) {
        const TrialAnswer answer = std::get<Storing>(session.phase).answer;
        ASSERT_EQ(answer.trial_index, answers++);
        ASSERT_TRUE(answer.chosen_index >= 1 && answer.chosen_index <= 3);
        ASSERT_TRUE(answer.rating >= 1 && answer.rating <= 4);
        ASSERT_TRUE(answer.choice_ns >= 0 && answer.rating_ns >= answer.choice_ns);
      }
    }
    EXPECT_EQ(answers, 12);
  }
}

}  // namespace
}  // namespace seamline::study
