#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "study/placement/quest_plus_design.h"
#include "study/trials/rendered_set.h"
#include "study/trials/trial_sequence.h"

namespace seamline::study {

// Which trials a participant gets: pure functions of the study, the participant's slot and what was decided
// and answered before. Whoever runs a session (the window, a simulation, a server) calls them and keeps what
// they return:
//
//     trials = decided_trials(rules, slot, trials)                    before the session; keep what is new
//     sequence = trial_sequence(rules, {slot, trials, answers})
//     while current_trial(sequence):
//       undecided_trial(sequence, number of trials)                   before its picture is shown; keep it
//       sequence = after_answer(sequence, answer)                     once the answer is kept

struct LevelLadders;  // study/trials/level_ladders.h

/// What decides the trials of all participants of a study.
struct TrialRules {
  std::vector<Stimulus> stimuli = {};  ///< of the set
  std::uint64_t study_seed = 1;
  CatchDefinition catches = {};
  std::shared_ptr<const QuestPlusDesign> quest_plus = {};  ///< none: constant stimuli, or staircases
  std::shared_ptr<const StaircaseDesign> staircase = {};
  TaskFacts task = {};
  int repetitions = 1;      ///< of every constant stimulus, each time in an order of its own
  bool blocks = false;      ///< of constant stimuli: conditions in blocks
  OwnTasks own_tasks = {};  ///< of conditions that have them; they stand in blocks, catch trials with them
  std::vector<int> own_repetitions = {};             ///< of each stimulus there; else none
  std::shared_ptr<const LevelLadders> ladders = {};  ///< of a match, whose trials are one a ladder; else none

  /// What a trial asks.
  [[nodiscard]] const TaskFacts& task_of(const Trial& trial) const {
    return study::task_of(task, own_tasks, trial);
  }
  /// Whether trials are decided one by one, by the answers before them.
  [[nodiscard]] bool is_adaptive() const { return quest_plus != nullptr || staircase != nullptr; }
};

/// Seed of the draws of an adaptive procedure.
[[nodiscard]] std::uint64_t participant_seed(std::uint64_t study_seed, int slot);

[[nodiscard]] TrialRules make_trial_rules(const RenderedSet& set);

/// How far a participant has come.
struct ParticipantProgress {
  int slot = 0;                          ///< see study/trials/stimulus_order.h
  std::span<const Trial> trials;         ///< decided so far
  std::span<const TrialAnswer> answers;  ///< to the first of them
};

/// The trials of a participant that are known when a session begins: those decided before, `trials`, as they
/// are; where there are none, all trials of constant stimuli with their catch trials; of an adaptive
/// procedure none, since it decides each by the answers before it.
[[nodiscard]] std::vector<Trial> decided_trials(const TrialRules& rules, int slot,
                                                std::span<const Trial> trials);

/// The trials of a participant, at the first one without an answer. What was decided is taken as it is and
/// not decided again, so the result is, bit for bit, what it was before a session broke off. Precondition:
/// those of `decided_trials` are among them.
[[nodiscard]] TrialSequence trial_sequence(const TrialRules& rules, const ParticipantProgress& progress);

/// The trial that is due, unless it is one of the first `decided` trials or the session is over. Constant
/// stimuli have none.
[[nodiscard]] std::optional<Trial> undecided_trial(const TrialSequence& trials, int decided);

}  // namespace seamline::study
