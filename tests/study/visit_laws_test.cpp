#include <gtest/gtest.h>

#include "small_visit.h"

namespace seamline::study {
namespace {

VisitEvent random_visit_event(Random& random, std::int64_t now_ns) {
  const int number = static_cast<int>(random.below(6)) - 1;
  switch (random.below(15)) {
    case 0:
      return ConsentGiven{};
    case 1:
      return FormSubmitted{random.below(2) == 0 ? ScriptedPerson::form() : std::vector<FormAnswer>{}};
    case 2:
      return DisplayConfirmed{};
    case 3:
    case 4:
      return Continued{};
    case 5:
      return WentBack{};
    case 6:
      return PauseBegun{};
    case 7:
      return Enrolled{trials(9)};
    case 8:
      return Event(Tick{now_ns});
    case 9:
      return Event(ImageShown{now_ns});
    case 10:
      return Event(ObjectChosen{.index = number, .now_ns = now_ns});
    case 11:
      return Event(RatingGiven{.rating = number, .now_ns = now_ns});
    case 12:
      return Event(AnswerStored{});
    case 13:
      return Event(BreakEnded{});
    default:
      return RecordStored{};
  }
}

/// Whatever is hammered: every record comes once and in order, no trial is skipped or doubled, and the screen
/// stays while a record waits.
TEST(Visit, LawsHoldUnderRandomEvents) {
  Random random(77);
  for (int run = 0; run < 100; ++run) {
    Visit visit = begin_visit(shared(script()));
    int answers = 0, practice = 0;
    std::vector<int> others(std::variant_size_v<Record>, 0);
    int waiting = -1;  // the kind of record that was pending before the event
    std::int64_t now_ns = 0;
    for (int i = 0; !is_over(visit); ++i) {
      ASSERT_LT(i, 200000);
      now_ns += second / 3;
      const Screen before = visit.screen;
      visit = next(std::move(visit), random_visit_event(random, now_ns));
      if (!visit.pending) {
        waiting = -1;
        continue;
      }
      const int kind = static_cast<int>(visit.pending->index());
      if (waiting == kind) {
        ASSERT_EQ(visit.screen.index(), before.index());
        continue;
      }
      waiting = kind;
      ++others[static_cast<std::size_t>(kind)];
      if (const auto* answer = std::get_if<AnswerRecord>(&*visit.pending)) {
        ASSERT_EQ(answer->answer.trial_index, answers++);
      }
      if (const auto* training = std::get_if<TrainingRecord>(&*visit.pending)) {
        ASSERT_EQ(training->answer.trial_index, practice++);
      }
    }
    EXPECT_TRUE(on<ThanksScreen>(visit));
    EXPECT_EQ(answers, 9);
    EXPECT_EQ(practice, 2);
    EXPECT_EQ(others, (std::vector<int>{0, 1, 1, 1, 2, 9, 1}));
  }
}

}  // namespace
}  // namespace seamline::study
