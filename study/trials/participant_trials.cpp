#include "study/trials/participant_trials.h"

#include <algorithm>
#include <iterator>

#include "stimuli/definition/looks/condition_tasks.h"
#include "study/placement/placed_answer.h"
#include "study/trials/catch_trials.h"
#include "study/trials/condition_blocks.h"
#include "study/trials/level_ladders.h"
#include "study/trials/stimulus_order.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps the draws of adaptive procedures apart from those of the order and of the renderer.
constexpr std::uint64_t quest_plus_salt = 0x71756573742b;  // "quest+"

/// The trials of the procedure among those of the participant, and their answers as the procedure numbers
/// them.
struct OwnTrials {
  std::vector<int> stimuli;
  std::vector<TrialAnswer> answers;
};

OwnTrials own_trials(const TrialRules& rules, const ParticipantProgress& progress) {
  OwnTrials own;
  for (std::size_t trial = 0; trial < progress.trials.size(); ++trial) {
    if (progress.trials[trial].kind != TrialKind::stimulus) continue;
    own.stimuli.push_back(progress.trials[trial].stimulus);
    if (trial >= progress.answers.size()) continue;
    const Trial& shown = progress.trials[trial];
    const Stimulus& stimulus = rules.stimuli[shown.stimulus];
    own.answers.push_back(placed_answer(progress.answers[trial], shown.right_index, stimulus.object_index));
    own.answers.back().trial_index = static_cast<int>(own.answers.size()) - 1;
  }
  return own;
}

Procedure staircases_at(const TrialRules& rules, int slot, const OwnTrials& own) {
  std::vector<StaircaseAnswer> answers;
  for (std::size_t i = 0; i < own.answers.size(); ++i) {
    const std::size_t stimulus = own.stimuli[i];
    answers.push_back(
        {.stimulus = own.stimuli[i],
         .correct = own.answers[i].chosen_index == rules.staircase->places[stimulus].object_index});
  }
  const bool one_more = own.stimuli.size() > own.answers.size();
  return resume_staircases(begin_staircases(rules.staircase, participant_seed(rules.study_seed, slot)),
                           answers, one_more ? std::optional(own.stimuli[own.answers.size()]) : std::nullopt);
}

Procedure procedure_at(const TrialRules& rules, int slot, const OwnTrials& own) {
  if (rules.quest_plus)
    return resume_quest_plus(begin_quest_plus(rules.quest_plus, participant_seed(rules.study_seed, slot)),
                             own.stimuli, own.answers);
  if (rules.staircase) return staircases_at(rules, slot, own);
  return ConstantProcedure{.order = own.stimuli, .answered = static_cast<int>(own.answers.size())};
}

/// Those that are decided, then the rest of those that are due to come.
std::vector<CatchTrial> catches_at(const TrialRules& rules, const ParticipantProgress& progress) {
  std::vector<CatchTrial> catches = catch_trials_of(progress.trials);
  if (!rules.is_adaptive()) return catches;  // all are decided
  const int most = rules.quest_plus ? most_trials(begin_quest_plus(rules.quest_plus, 0))
                                    : most_trials(begin_staircases(rules.staircase, 0));
  const std::vector<CatchTrial> schedule = draw_catch_trials(
      rules.catches, rules.stimuli, most, {.study_seed = rules.study_seed, .slot = progress.slot});
  for (std::size_t i = catches.size(); i < schedule.size(); ++i) catches.push_back(schedule[i]);
  return catches;
}

/// Every stimulus once in a random order, then every stimulus once again: repetitions spread over the
/// session. Of a match the stimuli that its trials begin with.
std::vector<int> order_of_repetitions(const TrialRules& rules, const OrderKey& key) {
  if (rules.ladders) return match_starts(*rules.ladders, rules.repetitions, key);
  constexpr std::uint64_t repetition_salt = 0x616761696e;  // "again"
  std::vector<int> order;
  const std::vector<int>& own = rules.own_repetitions;
  const int most = own.empty() ? rules.repetitions : *std::max_element(own.begin(), own.end());
  for (int r = 0; r < most; ++r) {
    const std::uint64_t seed = r == 0 ? key.study_seed : mix_bits(key.study_seed ^ repetition_salt) + r;
    const std::vector<int> once =
        stimulus_order(static_cast<int>(rules.stimuli.size()), {.study_seed = seed, .slot = key.slot});
    std::copy_if(once.begin(), once.end(), std::back_inserter(order),
                 [&](int stimulus) { return own.empty() || r < own[stimulus]; });
  }
  return order;
}

}  // namespace

std::uint64_t participant_seed(std::uint64_t study_seed, int slot) {
  return Random(mix_bits(study_seed ^ quest_plus_salt), slot).bits();
}

TrialRules make_trial_rules(const RenderedSet& set) {
  TrialRules rules{.study_seed = set.study.seed,
                   .catches = set.study.catches,
                   .task = facts_of(set.study.task.get()),
                   .repetitions = set.study.task ? set.study.task->repetitions : 1,
                   .blocks = (set.study.task && set.study.task->blocks) || has_own_tasks(set.study),
                   .own_tasks = own_tasks_of(set)};
  for (const ManifestStimulus& record : set.manifest.stimuli) rules.stimuli.push_back(record.stimulus);
  if (rules.own_tasks)
    for (const Stimulus& stimulus : rules.stimuli) {
      const std::shared_ptr<const TaskDefinition> task = stimuli::task_of(set.study, stimulus.condition);
      rules.own_repetitions.push_back(task ? task->repetitions : 1);
    }
  if (rules.task.adjusts())
    rules.ladders = std::make_shared<const LevelLadders>(
        make_level_ladders(rules.stimuli, set.study.level.noticeability));
  if (const auto* definition = std::get_if<QuestPlusDefinition>(&set.study.procedure))
    rules.quest_plus = std::make_shared<QuestPlusDesign>(make_quest_plus_design(*definition, rules.stimuli));
  if (set.study.task && set.study.task->staircase)
    rules.staircase = std::make_shared<StaircaseDesign>(
        make_staircase_design(*set.study.task->staircase, set.study.level.noticeability, rules.stimuli));
  return rules;
}

std::vector<Trial> decided_trials(const TrialRules& rules, int slot, std::span<const Trial> trials) {
  if (rules.is_adaptive() || !trials.empty()) return {trials.begin(), trials.end()};
  const OrderKey key{.study_seed = rules.study_seed, .slot = slot};
  std::vector<int> order = order_of_repetitions(rules, key);
  if (rules.blocks) order = in_condition_blocks(std::move(order), rules.stimuli, slot);
  std::vector<CatchTrial> catches =
      draw_catch_trials(rules.catches, rules.stimuli, static_cast<int>(order.size()), key);
  if (rules.own_tasks) move_into_blocks(catches, order, rules.stimuli);
  std::vector<Trial> decided = interleave(order, catches);
  const RightRule right = right_rule(rules.task, rules.study_seed, slot, rules.own_tasks);
  for (std::size_t i = 0; i < decided.size(); ++i)
    decided[i].right_index = right_index_of(right, decided[i], static_cast<int>(i));
  return decided;
}

TrialSequence trial_sequence(const TrialRules& rules, const ParticipantProgress& progress) {
  const OwnTrials own = own_trials(rules, progress);
  return {.procedure = procedure_at(rules, progress.slot, own),
          .catches = catches_at(rules, progress),
          .catches_answered = static_cast<int>(progress.answers.size() - own.answers.size()),
          .right = right_rule(rules.task, rules.study_seed, progress.slot, rules.own_tasks)};
}

std::optional<Trial> undecided_trial(const TrialSequence& trials, int decided) {
  if (decided > answered_trials(trials)) return std::nullopt;
  return current_trial(trials);
}

}  // namespace seamline::study
