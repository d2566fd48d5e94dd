#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "study/placement/trial.h"

namespace seamline::study {

struct RenderedSet;  // study/trials/rendered_set.h

/// What is asked of each stimulus of a set whose conditions have tasks of their own; null: what the study
/// asks.
using OwnTasks = std::shared_ptr<const std::vector<TaskFacts>>;
[[nodiscard]] OwnTasks own_tasks_of(const RenderedSet& set);

/// What a trial asks, of a study that asks `study`.
[[nodiscard]] const TaskFacts& task_of(const TaskFacts& study, const OwnTasks& own, const Trial& trial);

/// The task of a trial, its own words with it; null: the paper's question.
[[nodiscard]] std::shared_ptr<const TaskDefinition> task_of(const RenderedSet& set, const Trial& trial);

/// Whether a mask follows what a trial shows.
[[nodiscard]] bool is_masked(const RenderedSet& set, const Trial& trial);

/// Which alternative of a participant's trials is right: a pure function of the participant's slot and the
/// trial's place, so that nothing is drawn again when a session resumes. The log keeps it.
struct RightRule {
  TaskFacts task = {};
  std::uint64_t seed = 0;  ///< of the participant
  OwnTasks own_tasks = {};
};
[[nodiscard]] RightRule right_rule(const TaskFacts& task, std::uint64_t study_seed, int slot,
                                   OwnTasks own_tasks = {});

/// `Trial::right_index` of the trial that stands at `trial_index` among those of every kind: drawn, every
/// alternative equally likely; yes or no as something was inserted or not; 0 where the object's place is
/// right or nothing is.
[[nodiscard]] int right_index_of(const RightRule& rule, const Trial& trial, int trial_index);

/// Whether trials show references beside, before or after their pictures.
[[nodiscard]] inline bool shows_references(const TaskFacts& task) {
  return task.draws_right || task.compares;
}

/// The pictures that a trial shows, side by side or one after another: the stimulus (or what a catch trial
/// has in its place) where `right_index` says, and the reference of its scene elsewhere. One of other tasks.
[[nodiscard]] std::vector<Trial> shown_pictures(const TaskFacts& task, const Trial& trial);

}  // namespace seamline::study
