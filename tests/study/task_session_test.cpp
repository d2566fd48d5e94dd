// A session of tasks other than the paper's: the same pure function, other phases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "study/trials/right_rule.h"
#include "study/visit/session.h"

namespace seamline::study {
namespace {

TaskFacts facts_of_kind(TaskKind kind, bool second_question = false, int pictures = 2) {
  const TaskDefinition task{.kind = kind, .pictures = pictures, .second_question = second_question};
  return facts_of(&task);
}

Session task_session_of(const TaskFacts& task) {
  ConstantProcedure procedure{.order = std::vector<int>(3)};
  std::iota(procedure.order.begin(), procedure.order.end(), 0);
  return begin_session(
      {.procedure = procedure, .right = right_rule(task, 1, 0)},
      {.minimum_viewing_ns = 10, .task = {.facts = task, .exposure_ns = 500, .gap_ns = 300}});
}

template <class Wanted>
bool in_task_phase(const Session& session) {
  return std::holds_alternative<Wanted>(session.phase);
}

Session after_task_events(Session session, const std::vector<Event>& events) {
  for (const Event& event : events) session = next(std::move(session), event);
  return session;
}

TEST(TaskSession, AnIntervalShowsItsPicturesOneAfterAnotherAndThenAsks) {
  Session session = next(task_session_of(facts_of_kind(TaskKind::interval)), ImageShown{.now_ns = 1000});
  ASSERT_TRUE(in_task_phase<Viewing>(session));
  EXPECT_TRUE(in_task_phase<Viewing>(next(session, Tick{.now_ns = 1499})));
  EXPECT_TRUE(in_task_phase<Viewing>(next(session, ObjectChosen{.index = 1, .now_ns = 1400})));
  session = next(session, Tick{.now_ns = 1500});
  ASSERT_TRUE(in_task_phase<Gap>(session));
  EXPECT_EQ(std::get<Gap>(session.phase).since_ns, 1500);
  EXPECT_TRUE(in_task_phase<Gap>(next(session, Tick{.now_ns = 1799})));
  session = next(session, Tick{.now_ns = 1800});
  ASSERT_TRUE(in_task_phase<AwaitingImage>(session));
  EXPECT_EQ(std::get<AwaitingImage>(session.phase).picture, 1);
  session = after_task_events(session, {ImageShown{.now_ns = 1810}, Tick{.now_ns = 2310}});
  ASSERT_TRUE(in_task_phase<Choosing>(session));
  session = next(session, ObjectChosen{.index = 2, .now_ns = 3000});
  ASSERT_TRUE(in_task_phase<Storing>(session));
  EXPECT_EQ(
      std::get<Storing>(session.phase).answer,
      (TrialAnswer{.trial_index = 0, .chosen_index = 2, .rating = 1, .choice_ns = 1190, .rating_ns = 1190}));
}

TEST(TaskSession, APauseBeginsTheTrialAgain) {
  const Session viewing = next(task_session_of(facts_of_kind(TaskKind::interval)), ImageShown{.now_ns = 0});
  const Session gap = next(viewing, Tick{.now_ns = 500});
  for (const Session& session : {viewing, gap}) {
    const Session again = next(session, PictureTaken{});
    ASSERT_TRUE(in_task_phase<AwaitingImage>(again));
    EXPECT_EQ(std::get<AwaitingImage>(again.phase).picture, 0);
    EXPECT_EQ(current_trial(again.trials), current_trial(session.trials));
  }
}

TEST(TaskSession, OnlyTheTasksAlternativesAreChoices) {
  const std::map<TaskKind, int> alternatives = {
      {TaskKind::object, 3}, {TaskKind::pair, 2}, {TaskKind::yes_no, 2}};
  for (const auto& [kind, count] : alternatives) {
    const Session choosing =
        next(task_session_of(facts_of_kind(kind, kind == TaskKind::object)), ImageShown{.now_ns = 0});
    for (const int index : {0, count + 1})
      EXPECT_TRUE(in_task_phase<Choosing>(next(choosing, ObjectChosen{.index = index, .now_ns = 50})));
    EXPECT_FALSE(in_task_phase<Choosing>(next(choosing, ObjectChosen{.index = count, .now_ns = 50})));
  }
}

TEST(TaskSession, ASecondQuestionFollowsOnlyWhereItIsAsked) {
  for (const bool second : {false, true}) {
    const Session session =
        after_task_events(task_session_of(facts_of_kind(TaskKind::pair, second)),
                          {ImageShown{.now_ns = 0}, ObjectChosen{.index = 1, .now_ns = 50}});
    EXPECT_EQ(in_task_phase<Rating>(session), second);
    EXPECT_EQ(in_task_phase<Storing>(session), !second);
  }
}

TEST(TaskSession, ARatingAloneSaysWhetherAnythingWasSeen) {
  const Session rating = next(task_session_of(facts_of_kind(TaskKind::rating)), ImageShown{.now_ns = 0});
  ASSERT_TRUE(in_task_phase<Rating>(rating));
  EXPECT_TRUE(in_task_phase<Rating>(next(rating, ObjectChosen{.index = 1, .now_ns = 50})));
  EXPECT_TRUE(in_task_phase<Rating>(next(rating, RatingGiven{.rating = 5, .now_ns = 50})));
  EXPECT_TRUE(in_task_phase<Rating>(next(rating, RatingGiven{.rating = 2, .now_ns = 9})));  // too soon
  for (int label = 0; label <= 4; ++label) {
    const Session stored = next(rating, RatingGiven{.rating = label, .now_ns = 50});
    ASSERT_TRUE(in_task_phase<Storing>(stored));
    const TrialAnswer& answer = std::get<Storing>(stored.phase).answer;
    EXPECT_EQ(answer.chosen_index == 1 ? answer.rating : 0, label);
    EXPECT_GE(answer.rating, 1);
  }
}

TEST(TaskSession, ExposuresEndWhileTheAnswerIsAwaited) {
  const SessionTask brief{.facts = facts_of_kind(TaskKind::yes_no), .exposure_ns = 500};
  EXPECT_TRUE(is_picture_seen(brief, 1000, 1499));
  EXPECT_FALSE(is_picture_seen(brief, 1000, 1500));
  EXPECT_TRUE(is_picture_seen({}, 1000, 1'000'000'000));
  EXPECT_FALSE(is_picture_seen({.facts = facts_of_kind(TaskKind::interval)}, 0, 1));
}

TEST(TaskSession, ASlidersPlaceIsANumberAndItsFifthTheRating) {
  const TaskDefinition slider{.kind = TaskKind::rating, .second_question = false, .slider = true};
  const Session rating = next(task_session_of(facts_of(&slider)), ImageShown{.now_ns = 0});
  for (const int outside : {-1, 101})
    EXPECT_TRUE(in_task_phase<Rating>(next(rating, RatingGiven{.now_ns = 50, .position = outside})));
  for (int position = 0; position <= 100; ++position) {
    const Session stored = next(rating, RatingGiven{.now_ns = 50, .position = position});
    ASSERT_TRUE(in_task_phase<Storing>(stored));
    const TrialAnswer& answer = std::get<Storing>(stored.phase).answer;
    EXPECT_EQ(answer.position, position);
    EXPECT_EQ(answer.chosen_index == 1 ? answer.rating : 0, std::min(4, position / 20)) << position;
  }
}

TEST(TaskSession, AMaskCoversWhatFollowsAnExposureForItsTime) {
  const SessionTask masked{.exposure_ns = 500, .mask_ns = 100};
  EXPECT_FALSE(is_mask_seen(masked, 1000, 1499));
  EXPECT_TRUE(is_mask_seen(masked, 1000, 1500));
  EXPECT_TRUE(is_mask_seen(masked, 1000, 1599));
  EXPECT_FALSE(is_mask_seen(masked, 1000, 1600));
  EXPECT_FALSE(is_mask_seen({.exposure_ns = 500}, 1000, 1500));
}

TEST(TaskSession, ABlockWithWordsOfItsOwnBeginsWithThemAndABreakComesFirst) {
  ConstantProcedure procedure{.order = {0, 1, 2, 3, 4}};
  const SessionPace pace{.break_every_trials = 2,
                         .briefed = std::make_shared<const std::vector<int>>(std::vector{0, 0, 1, -1, 1})};
  Session session = begin_session({.procedure = procedure}, pace);
  std::vector<std::string> met;
  for (int i = 0; i < 100 && !in_task_phase<Done>(session); ++i) {
    if (in_task_phase<OnBreak>(session)) met.emplace_back("break");
    if (in_task_phase<Briefing>(session)) met.emplace_back("words");
    if (in_task_phase<Storing>(session)) met.emplace_back("trial");
    session = after_task_events(
        session, {in_task_phase<OnBreak>(session) || in_task_phase<Briefing>(session) ? Event(BreakEnded{})
                  : in_task_phase<AwaitingImage>(session)                             ? Event(ImageShown{})
                  : in_task_phase<Choosing>(session) ? Event(ObjectChosen{.index = 1})
                  : in_task_phase<Rating>(session)   ? Event(RatingGiven{.rating = 1})
                                                     : Event(AnswerStored{})});
  }
  EXPECT_EQ(met, (std::vector<std::string>{"words", "trial", "trial", "break", "words", "trial", "trial",
                                           "break", "words", "trial"}));
}

TEST(RightRule, EveryAlternativeIsRightEquallyOftenAndTheSameAgain) {
  for (const int pictures : {2, 3}) {
    const RightRule rule = right_rule(facts_of_kind(TaskKind::interval, false, pictures), 7, 3);
    std::map<int, int> times;
    constexpr int trials = 6000;
    for (int trial = 0; trial < trials; ++trial) {
      const int right = right_index_of(rule, {}, trial);
      EXPECT_EQ(right, right_index_of(rule, {}, trial));
      ++times[right];
    }
    ASSERT_EQ(times.size(), static_cast<std::size_t>(pictures));
    for (const auto& [right, count] : times)
      EXPECT_NEAR(count, static_cast<double>(trials) / pictures, 4 * std::sqrt(trials)) << right;
  }
}

TEST(RightRule, ThePictureThatIsRightHoldsTheStimulusAndTheOthersItsReference) {
  const TaskFacts task = facts_of_kind(TaskKind::interval, false, 3);
  for (int right = 0; right <= 3; ++right) {
    const std::vector<Trial> shown =
        shown_pictures(task, {.kind = TrialKind::stimulus, .stimulus = 5, .right_index = right});
    ASSERT_EQ(shown.size(), 3U);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(shown[static_cast<std::size_t>(i)].kind,
                i + 1 == right ? TrialKind::stimulus : TrialKind::reference);
  }
  EXPECT_EQ(shown_pictures({}, {.stimulus = 5}), std::vector<Trial>({{.stimulus = 5}}));
}

TEST(RightRule, YesIsRightWhereSomethingWasInserted) {
  const RightRule rule = right_rule(facts_of_kind(TaskKind::yes_no), 7, 3);
  EXPECT_EQ(right_index_of(rule, {.kind = TrialKind::stimulus}, 0), 1);
  EXPECT_EQ(right_index_of(rule, {.kind = TrialKind::attention}, 1), 1);
  EXPECT_EQ(right_index_of(rule, {.kind = TrialKind::reference}, 2), 2);
  EXPECT_EQ(right_index_of(right_rule({}, 7, 3), {}, 0), 0);  // the object's own place
}

}  // namespace
}  // namespace seamline::study
