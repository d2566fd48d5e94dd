// What adaptive placement is for: the planted threshold of simulated people, in fewer trials than constant
// stimuli need for the same error. Both are estimated by the same posterior mean, so only the placement
// differs.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "quest_plus_task.h"
#include "study/observers/observer.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

constexpr int most_trials = 84;
constexpr double planted_spread_octaves = 1.0;

/// An outcome of a person whose threshold lies `shift_octaves` from the study's.
using Answering = std::function<int(const Task&, double shift_octaves, int width_px, Random&)>;

constexpr double planted_width_px = 620;

/// The simulated observer that studies use.
int answer_of_observer(const Task& task, double shift_octaves, int width_px, Random& random) {
  const ThresholdObserver person{.definition = {}, .shift_octaves = shift_octaves};
  EXPECT_EQ(person.definition.midpoint.at(Artifact::occlusion), planted_width_px);
  Stimulus stimulus;
  stimulus.artifact = Artifact::occlusion;
  stimulus.object_index = 2;
  stimulus.level = width_px;
  stimulus.depth.width_px = width_px;
  const Response response = respond(person, stimulus, random);
  return outcome_of(task.definition, {.chosen_index = response.chosen_index, .rating = response.rating}, 2);
}

/// Somebody who answers as the model says, off the grid's points.
int answer_of_model(const Task& task, double shift_octaves, int width_px, Random& random) {
  const QuestPlusGrid truth{
      .values = {{{std::log2(planted_width_px) + shift_octaves}, {0.45}, {0.03}, {1.0 / 3}, {0.4}}}};
  double rest = random.uniform();
  int outcome = 0;
  for (const double p : outcome_probabilities(task.definition, truth, 0, width_px)) {
    if (rest < p) return outcome;
    rest -= p;
    ++outcome;
  }
  return outcome - 1;
}

/// Root mean square error of log2 threshold (octaves) after 1..most_trials trials.
struct Errors {
  std::vector<double> rms = std::vector<double>(most_trials + 1, 0);
  double bias = 0;  ///< mean error after the last trial
  std::uint64_t trace = 0;

  /// The first trial from which on the error stays at or under `rms_octaves`; most_trials + 1 when never.
  [[nodiscard]] int trials_to(double rms_octaves) const {
    int trial = most_trials + 1;
    while (trial > 1 && rms[static_cast<std::size_t>(trial - 1)] <= rms_octaves) --trial;
    return trial;
  }
};

using Placement = std::function<int(const QuestPlusPosterior&, int trial, Random&)>;

/// Constant stimuli: every width once, in a new order, again and again.
Placement constant_placement(std::size_t widths) {
  std::vector<int> order(widths);
  for (std::size_t i = 0; i < widths; ++i) order[i] = static_cast<int>(i);
  return [order](const QuestPlusPosterior&, int trial, Random& random) mutable {
    const auto place = static_cast<std::size_t>(trial) % order.size();
    if (place == 0) shuffle(std::span<int>(order), random);
    return order[place];
  };
}

Errors simulate(const Task& task, const Answering& answer, Placement place, int people) {
  Errors errors;
  for (int number = 0; number < people; ++number) {
    Random random(21, static_cast<std::uint64_t>(number)), placing(22, static_cast<std::uint64_t>(number));
    const double shift = planted_spread_octaves * random.normal();
    QuestPlusPosterior posterior = uniform_posterior(task.grid.points());
    for (int trial = 1; trial <= most_trials; ++trial) {
      const int width = place(posterior, trial - 1, placing);
      learn(posterior, task.tables, width,
            answer(task, shift, task.width_px[static_cast<std::size_t>(width)], random));
      const double error =
          moments(task.grid, posterior, Parameter::threshold).mean - std::log2(planted_width_px) - shift;
      errors.rms[static_cast<std::size_t>(trial)] += error * error / people;
      if (trial == most_trials) errors.bias += error / people;
      errors.trace = mix_bits(errors.trace + static_cast<std::uint64_t>(width));
    }
  }
  for (double& square : errors.rms) square = std::sqrt(square);
  return errors;
}

void compare(const Task& task, const Answering& answer, int people, const char* what, double least_gain) {
  const Placement adaptive = [&](const QuestPlusPosterior& posterior, int, Random&) {
    return task.best(posterior);
  };
  const Errors quest = simulate(task, answer, adaptive, people);
  const Errors constant = simulate(task, answer, constant_placement(task.width_px.size()), people);
  const int needed = quest.trials_to(constant.rms[most_trials]);
  // A row of documentation/evidence/planning.md each: root mean square errors in octaves.
  const auto print_row = [&](const char* way, const Errors& errors) {
    std::printf("| %s | %s | %.2f | %.2f | %.2f | %.2f |\n", what, way, errors.rms[14], errors.rms[28],
                errors.rms[42], errors.rms[84]);
  };
  print_row("constant", constant);
  print_row("QUEST+", quest);
  std::printf("QUEST+ has the error of 84 constant trials after %d; bias %.3f and %.3f\n", needed,
              constant.bias, quest.bias);
  EXPECT_LT(needed * least_gain, most_trials);
  EXPECT_LT(quest.rms[28], constant.rms[28]);
  EXPECT_LT(quest.rms[most_trials], 0.35);
  EXPECT_NEAR(quest.bias, 0, 0.2);
}

TEST(QuestPlusRecovery, FindsThePlantedThresholdInFewerTrialsThanConstantStimuli) {
  compare(make_task(PlacementOutcome::correct), answer_of_observer, 300, "right or wrong, threshold observer",
          1.5);
}

TEST(QuestPlusRecovery, DoesSoWithNoticeability) {
  compare(make_task(PlacementOutcome::noticeability), answer_of_model, 100,
          "noticeability, people of the model", 1.2);
}

TEST(QuestPlusRecovery, ChoicesAreDeterministic) {
  const Task one = make_task(PlacementOutcome::correct), same = make_task(PlacementOutcome::correct);
  const auto trace = [](const Task& task) {
    return simulate(
               task, answer_of_observer,
               [&](const QuestPlusPosterior& posterior, int, Random&) { return task.best(posterior); }, 20)
        .trace;
  };
  EXPECT_EQ(trace(one), trace(same));
}

}  // namespace
}  // namespace seamline::study
