// Staircases: their steps, where they converge, and that a session that broke off goes on with the same
// trials.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "study/log/log.h"
#include "study/placement/staircase.h"
#include "study/running/simulation.h"
#include "study/running/staircase_results.h"
#include "study/trials/participant_trials.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

TEST(Staircase, ConvergesWhereLevittSays) {
  // Levitt (1971), Table I: 1 up and so many down.
  const std::map<int, double> published = {{1, 0.5}, {2, 0.707}, {3, 0.794}, {4, 0.841}};
  for (const auto& [down, target] : published)
    EXPECT_NEAR(staircase_target({.down = down, .up = 1}), target, 5e-4);
  EXPECT_NEAR(staircase_target({.down = 1, .up = 2}), 1 - 0.707, 5e-4);  // the mirror image
}

TEST(Staircase, StepsAndTurnsAsWrittenDown) {
  // Two right: one level on; one wrong: one back. Right and wrong by hand, levels and turns by hand.
  const StaircaseDefinition rule{.down = 2, .up = 1, .reversals = 4, .max_trials = 100};
  const std::string answers = "rrrrwrrwrw";
  const std::vector<int> levels = {0, 1, 1, 2, 1, 1, 2, 1, 1, 0};  // after each answer
  Staircase stairs;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_FALSE(stairs.stopped) << i;
    stairs = after_answer(std::move(stairs), answers[i] == 'r', 5, rule);
    EXPECT_EQ(stairs.level, levels[i]) << i;
  }
  EXPECT_EQ(stairs.reversals, (std::vector<int>{2, 1, 2}));
  EXPECT_FALSE(stairs.stopped);
  stairs = after_answer(after_answer(std::move(stairs), true, 5, rule), true, 5, rule);
  EXPECT_EQ(stairs.reversals, (std::vector<int>{2, 1, 2, 0}));
  EXPECT_TRUE(stairs.stopped);
}

TEST(Staircase, EndsAfterItsLastTrialAndStaysWithinTheLevels) {
  const StaircaseDefinition rule{.down = 1, .up = 1, .reversals = 4, .max_trials = 10};
  Staircase stairs;
  for (int trial = 0; trial < 10; ++trial) {
    EXPECT_FALSE(stairs.stopped);
    stairs = after_answer(std::move(stairs), true, 3, rule);
    EXPECT_LE(stairs.level, 2);
  }
  EXPECT_TRUE(stairs.stopped);
  EXPECT_TRUE(stairs.reversals.empty());
}

TEST(Staircase, TheMeanOfReversalsLeavesOutTheFirstTwoAndAnOddOne) {
  StimulusTrack curve;
  curve.levels = {16, 32, 64, 128, 256};
  Staircase stairs;
  stairs.reversals = {4, 0, 2, 1};
  EXPECT_DOUBLE_EQ(reversals_mean(stairs, curve, Axis::log2).value(), 5.5);
  stairs.reversals = {4, 0, 0, 3, 1};  // three are left: the last two
  EXPECT_DOUBLE_EQ(reversals_mean(stairs, curve, Axis::log2).value(), 6);
  EXPECT_DOUBLE_EQ(reversals_mean(stairs, curve, Axis::linear).value(), (128 + 32) / 2.0);
  stairs.reversals = {4, 0, 2};
  EXPECT_FALSE(reversals_mean(stairs, curve, Axis::log2));
}

std::string staircase_text(const std::string& task, const std::string& widths, const std::string& more) {
  std::string text = study_text("stairs", widths);
  text.insert(text.find("seed ="), "procedure = \"staircase\"\n");
  return text + "[observer]\npeople_sd_octaves = 0\n" + task + "[staircase]\n" + more;
}

/// Widths a quarter of an octave apart: Levitt's levels are those of small steps.
std::string fine_widths() {
  std::string widths;
  for (int quarter = 4 * 5; quarter <= 4 * 13; ++quarter)
    widths += fmt::format("{}{}", widths.empty() ? "" : ", ", 2 * std::lround(std::exp2(quarter / 4.0 - 1)));
  return widths;
}

TEST(Staircase, ReversalsOfSimulatedPeopleAverageToTheTarget) {
  for (const int down : {2, 3}) {
    const TemporaryFolder folder;
    const RenderedSet set = write_set_of_text(
        folder / "set", staircase_text("[task]\nkind = \"pair\"\n", fine_widths(),
                                       fmt::format("down = {}\nreversals = 40\nmax_trials = 400\n", down)));
    run_simulated_study({.set_folder = folder / "set",
                         .log = folder / "log",
                         .observer = ObserverKind::threshold,
                         .count = 12,
                         .seed = 3});
    std::map<Artifact, double> sum;
    std::map<Artifact, int> count;
    for (const StaircaseEstimate& one : staircase_estimates(read_log(folder / "log"))) {
      ASSERT_TRUE(one.level) << one.track;
      EXPECT_TRUE(one.by_reversals);
      sum[one.artifact] += std::log2(*one.level);
      ++count[one.artifact];
    }
    ASSERT_EQ(sum.size(), 4U);
    // In a pair p = 1/2 + psi / 2, psi logistic: seen with psi = 2 target - 1 so many scales past the middle.
    const double seen = 2 * staircase_target({.down = down, .up = 1}) - 1;
    const double past = set.study.observer.scale_octaves * std::log((1 - seen) / seen);
    for (const auto& [artifact, total] : sum)
      EXPECT_NEAR(total / count[artifact], std::log2(set.study.observer.midpoint.at(artifact)) + past, 0.2)
          << down << " " << word(artifact);
  }
}

TEST(Staircase, ASessionThatBreaksOffGoesOnWithTheSameTrials) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(
      folder / "set", staircase_text("", paper_widths_px, "start = [64, 4096]\nmax_trials = 12\n") +
                          "[catch]\nattention = 2\n");
  const TrialRules rules = make_trial_rules(set);
  const auto answer_of = [](int trial) {
    return TrialAnswer{.trial_index = trial, .chosen_index = 1 + (trial * 7 + trial / 3) % 3, .rating = 2};
  };
  std::vector<Trial> trials;
  std::vector<TrialAnswer> answers;
  TrialSequence whole = trial_sequence(rules, {.slot = 3, .trials = {}, .answers = {}});
  while (const std::optional<Trial> due = current_trial(whole)) {
    const TrialSequence again = trial_sequence(rules, {.slot = 3, .trials = trials, .answers = answers});
    EXPECT_EQ(current_trial(again), due) << trials.size();
    trials.push_back(*due);
    const TrialSequence decided = trial_sequence(rules, {.slot = 3, .trials = trials, .answers = answers});
    EXPECT_EQ(current_trial(decided), due);
    EXPECT_EQ(std::get<StaircaseProcedure>(decided.procedure).stairs,
              std::get<StaircaseProcedure>(whole.procedure).stairs);
    answers.push_back(answer_of(static_cast<int>(answers.size())));
    whole = after_answer(std::move(whole), answers.back());
  }
  EXPECT_GT(trials.size(), 8U * 8);  // two staircases of four artifacts, at most 12 trials each
  EXPECT_LE(trials.size(), 8U * 12 + 2);
}

}  // namespace
}  // namespace seamline::study
