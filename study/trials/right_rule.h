#pragma once
#include <cstdint>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "study/placement/trial.h"

namespace seamline::study {

/// Which alternative of a participant's trials is right: a pure function of the participant's slot and the
/// trial's place, so that nothing is drawn again when a session resumes. The log keeps it.
struct RightRule {
  TaskFacts task = {};
  std::uint64_t seed = 0;  ///< of the participant
};
[[nodiscard]] RightRule right_rule(const TaskFacts& task, std::uint64_t study_seed, int slot);

/// `Trial::right_index` of the trial that stands at `trial_index` among those of every kind: drawn, every
/// alternative equally likely; yes or no as something was inserted or not; 0 where the object's place is
/// right or nothing is.
[[nodiscard]] int right_index_of(const RightRule& rule, const Trial& trial, int trial_index);

/// The pictures that a trial shows, side by side or one after another: the stimulus (or what a catch trial
/// has in its place) where `right_index` says, and the reference of its scene elsewhere. One of other tasks.
[[nodiscard]] std::vector<Trial> shown_pictures(const TaskFacts& task, const Trial& trial);

}  // namespace seamline::study
