// A participant's trials without a log: what a server would hand to a browser.
#include "study/trials/participant_trials.h"

#include <gtest/gtest.h>

#include <set>

#include "study/trials/stimulus_order.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

constexpr const char* catch_section = "[catch]\nattention = 2\nreference = 2\n";

class ParticipantTrialsTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  [[nodiscard]] TrialRules rules(const std::string& name, const std::string& more) const {
    return make_trial_rules(write_set_of_text(folder / name, more + catch_section));
  }
  [[nodiscard]] TrialRules constant() const { return rules("constant", study_text("tiny", "64, 512")); }
  [[nodiscard]] TrialRules adaptive() const {
    std::string text = study_text("tiny", "64, 512");
    text.insert(text.find('\n') + 1, "procedure = \"quest_plus\"\n");
    return rules("adaptive", text + "[quest_plus]\nmax_shows_per_image = 3\nmax_trials = 12\n");
  }
  static TrialAnswer answer(int trial) {
    return {.trial_index = trial, .chosen_index = 1 + trial % 3, .rating = 1 + trial % 4};
  }
};

/// A session that keeps its sequence, and one that knows nothing but what was kept, decide the same trials.
TEST_F(ParticipantTrialsTest, WhatWasKeptIsEnoughToGoOn) {
  for (const TrialRules& study : {constant(), adaptive()}) {
    std::vector<Trial> kept = decided_trials(study, 4, {});
    std::vector<TrialAnswer> answers;
    TrialSequence sequence = trial_sequence(study, {.slot = 4, .trials = kept, .answers = answers});
    for (int trial = 0; current_trial(sequence); ++trial) {
      const auto due = undecided_trial(sequence, static_cast<int>(kept.size()));
      EXPECT_EQ(due.has_value(), study.quest_plus != nullptr);
      if (due) kept.push_back(*due);
      EXPECT_EQ(undecided_trial(sequence, static_cast<int>(kept.size())), std::nullopt);
      EXPECT_EQ(decided_trials(study, 4, kept), kept);
      const TrialSequence again = trial_sequence(study, {.slot = 4, .trials = kept, .answers = answers});
      ASSERT_EQ(current_trial(again), kept[static_cast<std::size_t>(trial)]);
      ASSERT_EQ(current_trial(again), current_trial(sequence));
      EXPECT_EQ(answered_trials(again), trial);
      answers.push_back(answer(trial));
      sequence = after_answer(std::move(sequence), answers.back());
    }
    EXPECT_EQ(kept.size(), answers.size());
    EXPECT_GT(kept.size(), 4U);
  }
}

TEST_F(ParticipantTrialsTest, ConstantStimuliAreAllDecidedBeforeTheSession) {
  const TrialRules study = constant();
  for (int slot = 0; slot < 20; ++slot) {
    const std::vector<Trial> trials = decided_trials(study, slot, {});
    ASSERT_EQ(trials.size(), study.stimuli.size() + 4);
    std::set<int> stimuli;
    for (const Trial& trial : trials)
      if (trial.kind == TrialKind::stimulus) stimuli.insert(trial.stimulus);
    EXPECT_EQ(stimuli.size(), study.stimuli.size());
    EXPECT_EQ(decided_trials(study, slot, {}), trials);
    EXPECT_NE(decided_trials(study, slot + 1, {}), trials);
  }
}

TEST(Slot, IsTheLowestThatNobodyHoldsWithoutSharedOrders) {
  EXPECT_EQ(newcomer_slot(0, {}), 0);
  EXPECT_EQ(newcomer_slot(0, std::vector<HeldSlot>{{0, true}, {2, false}, {1, false}}), 3);
  EXPECT_EQ(newcomer_slot(0, std::vector<HeldSlot>{{3, true}, {0, false}}), 1);
  EXPECT_EQ(slot_in_turn(0, 11), 11);
}

TEST(Slot, OfSharedOrdersHasTheFewestCompletedThenTheFewestUnfinished) {
  EXPECT_EQ(newcomer_slot(3, {}), 0);
  EXPECT_EQ(newcomer_slot(3, std::vector<HeldSlot>{{0, true}, {1, false}}), 2);
  EXPECT_EQ(newcomer_slot(3, std::vector<HeldSlot>{{0, true}, {1, false}, {2, true}}), 1);
  EXPECT_EQ(newcomer_slot(3, std::vector<HeldSlot>{{0, true}, {1, true}, {1, false}, {2, true}}), 0);
  EXPECT_EQ(newcomer_slot(2, std::vector<HeldSlot>{{5, true}, {0, false}}), 1);  // 5 is no order of two
  EXPECT_EQ(slot_in_turn(3, 11), 2);
}

/// Whoever comes when everybody before has finished, all orders are used equally often.
TEST(Slot, SharedOrdersStayBalanced) {
  std::vector<HeldSlot> held;
  std::vector<int> uses(7, 0);
  for (int i = 0; i < 70; ++i) {
    held.push_back({.slot = newcomer_slot(7, held), .completed = true});
    ++uses[static_cast<std::size_t>(held.back().slot)];
  }
  EXPECT_EQ(uses, std::vector<int>(7, 10));
}

}  // namespace
}  // namespace seamline::study
