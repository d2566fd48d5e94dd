#include "study/trials/catch_trials.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace seamline::study {
namespace {

/// Two scenes of three objects at two widths: 12 stimuli.
std::vector<Stimulus> small_set() {
  std::vector<Stimulus> set;
  for (const char* scene : {"room", "hall"})
    for (const int object : {1, 2, 3})
      for (const int width_px : {64, 512})
        set.push_back({.scene = scene,
                       .artifact = Artifact::receiver,
                       .object = "object" + std::to_string(object),
                       .object_index = object,
                       .level = 1.0 * width_px,
                       .depth = {.width_px = width_px}});
  return set;
}

std::vector<Trial> interleaved(int stimuli, const CatchDefinition& definition, int slot) {
  std::vector<int> order(static_cast<std::size_t>(stimuli));
  std::iota(order.begin(), order.end(), 0);
  return interleave(order,
                    draw_catch_trials(definition, small_set(), stimuli, {.study_seed = 3, .slot = slot}));
}

bool is_catch(const Trial& trial) {
  return trial.kind != TrialKind::stimulus;
}

TEST(CatchPlan, HasAsManyOfEachKindAsAskedAndAllOtherTrialsInOrder) {
  for (int slot = 0; slot < 50; ++slot) {
    std::map<TrialKind, int> count;
    int expected = 0;
    for (const Trial& trial : interleaved(84, {.attention = 4, .reference = 6}, slot)) {
      ++count[trial.kind];
      if (!is_catch(trial)) {
        EXPECT_EQ(trial.stimulus, expected++);
      }
    }
    EXPECT_EQ(count[TrialKind::stimulus], 84);
    EXPECT_EQ(count[TrialKind::attention], 4);
    EXPECT_EQ(count[TrialKind::reference], 6);
  }
}

TEST(CatchPlan, NoneIsFirstOrLastAndNoTwoStandTogether) {
  for (int slot = 0; slot < 500; ++slot)
    for (const int catches : {1, 3, 10, 11}) {
      const std::vector<Trial> trials =
          interleaved(12, {.attention = catches / 2, .reference = catches - catches / 2}, slot);
      ASSERT_EQ(static_cast<int>(trials.size()), 12 + catches);
      EXPECT_FALSE(is_catch(trials.front()));
      EXPECT_FALSE(is_catch(trials.back()));
      for (std::size_t i = 1; i < trials.size(); ++i)
        EXPECT_FALSE(is_catch(trials[i]) && is_catch(trials[i - 1])) << slot << " " << catches;
    }
}

/// More catch trials than gaps: they must stand together, but still none is first.
TEST(CatchPlan, CrowdsOnlyWhereItMust) {
  for (int slot = 0; slot < 50; ++slot) {
    const std::vector<Trial> trials = interleaved(3, {.attention = 5, .reference = 4}, slot);
    EXPECT_EQ(trials.size(), 12U);
    EXPECT_FALSE(is_catch(trials.front()));
    EXPECT_TRUE(is_catch(interleaved(1, {.attention = 1}, slot).back()));
  }
  EXPECT_TRUE(interleaved(0, {.attention = 1}, 0).empty());
}

/// Each quarter of the session holds a quarter of them, and each place is as likely as its neighbours.
TEST(CatchPlan, IsSpreadEvenlyButAtRandom) {
  std::map<int, int> at;
  constexpr int people = 4000, catches = 4, stimuli = 81;
  for (int slot = 0; slot < people; ++slot) {
    std::map<int, int> in_quarter;
    for (const CatchTrial& one : draw_catch_trials({.attention = 2, .reference = 2}, small_set(), stimuli,
                                                   {.study_seed = 9, .slot = slot})) {
      ++at[one.after_stimulus_trials];
      ++in_quarter[(one.after_stimulus_trials - 1) / 20];
    }
    EXPECT_EQ(in_quarter, (std::map<int, int>{{0, 1}, {1, 1}, {2, 1}, {3, 1}}));
  }
  ASSERT_EQ(at.size(), 80U);
  const double expected = people * catches / 80.0;
  double chi_squared = 0;
  for (const auto& [place, count] : at) chi_squared += (count - expected) * (count - expected) / expected;
  EXPECT_LT(chi_squared, 135);  // 79 degrees of freedom: p = 1e-4
}

TEST(CatchPlan, GoesThroughScenesAndObjects) {
  const std::vector<Stimulus> set = small_set();
  for (int slot = 0; slot < 50; ++slot) {
    std::map<std::pair<std::string, int>, int> attention;
    std::map<std::string, int> reference;
    for (const CatchTrial& one :
         draw_catch_trials({.attention = 12, .reference = 4}, set, 84, {.study_seed = 3, .slot = slot})) {
      const Stimulus& stimulus = set[static_cast<std::size_t>(one.trial.stimulus)];
      if (one.trial.kind == TrialKind::attention) ++attention[{stimulus.scene, stimulus.object_index}];
      if (one.trial.kind == TrialKind::reference) ++reference[stimulus.scene];
    }
    EXPECT_EQ(attention.size(), 6U);
    for (const auto& [what, times] : attention) EXPECT_EQ(times, 2);
    EXPECT_EQ(reference, (std::map<std::string, int>{{"room", 2}, {"hall", 2}}));
  }
}

TEST(CatchPlan, IsTheSameForTheSameKeyAndAnotherForAnother) {
  EXPECT_EQ(interleaved(84, {2, 2}, 5), interleaved(84, {2, 2}, 5));
  EXPECT_NE(interleaved(84, {2, 2}, 5), interleaved(84, {2, 2}, 6));
}

TEST(CatchPlan, ComesBackOutOfAPlan) {
  for (int slot = 0; slot < 20; ++slot) {
    const std::vector<CatchTrial> catches =
        draw_catch_trials({.attention = 3, .reference = 4}, small_set(), 12, {.study_seed = 3, .slot = slot});
    EXPECT_EQ(catch_trials_of(interleaved(12, {.attention = 3, .reference = 4}, slot)), catches);
  }
}

TrialSequence sequence(int stimuli, const std::vector<CatchTrial>& catches) {
  ConstantProcedure procedure;
  for (int i = 0; i < stimuli; ++i) procedure.order.push_back(i);
  return {.procedure = procedure, .catches = catches};
}

TEST(TrialSequence, ShowsThePlanAndCountsEveryKind) {
  const std::vector<Trial> all = interleaved(12, {.attention = 2, .reference = 3}, 1);
  TrialSequence trials = sequence(12, catch_trials_of(all));
  EXPECT_EQ(most_trials(trials), 17);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(current_trial(trials), all[i]);
    EXPECT_EQ(trial_after_current(trials), i + 1 < all.size() ? std::optional(all[i + 1]) : std::nullopt);
    EXPECT_EQ(answered_trials(trials), static_cast<int>(i));
    trials =
        after_answer(std::move(trials), {.trial_index = static_cast<int>(i), .chosen_index = 1, .rating = 1});
  }
  EXPECT_EQ(current_trial(trials), std::nullopt);
  EXPECT_EQ(trial_after_current(trials), std::nullopt);
}

}  // namespace
}  // namespace seamline::study
