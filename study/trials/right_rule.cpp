#include "study/trials/right_rule.h"

#include <utility>

#include "stimuli/definition/looks/condition_tasks.h"
#include "study/trials/rendered_set.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// Keeps these draws apart from those of the order, which has the same key.
constexpr std::uint64_t right_salt = 0x7269676874;  // "right"

}  // namespace

OwnTasks own_tasks_of(const RenderedSet& set) {
  if (!has_own_tasks(set.study)) return nullptr;
  std::vector<TaskFacts> tasks;
  for (const ManifestStimulus& record : set.manifest.stimuli)
    tasks.push_back(facts_of(stimuli::task_of(set.study, record.stimulus.condition).get()));
  return std::make_shared<const std::vector<TaskFacts>>(std::move(tasks));
}

const TaskFacts& task_of(const TaskFacts& study, const OwnTasks& own, const Trial& trial) {
  return own ? own->at(trial.stimulus) : study;
}

std::shared_ptr<const TaskDefinition> task_of(const RenderedSet& set, const Trial& trial) {
  const ManifestStimulus& record = set.manifest.stimuli.at(trial.stimulus);
  return stimuli::task_of(set.study, record.stimulus.condition);
}

bool is_masked(const RenderedSet& set, const Trial& trial) {
  return facts_of(task_of(set, trial).get()).masks;
}

RightRule right_rule(const TaskFacts& task, std::uint64_t study_seed, int slot, OwnTasks own_tasks) {
  return {.task = task,
          .seed = Random(mix_bits(study_seed ^ right_salt), slot).bits(),
          .own_tasks = std::move(own_tasks)};
}

int right_index_of(const RightRule& rule, const Trial& trial, int trial_index) {
  const bool nothing = trial.kind == TrialKind::reference;
  const TaskFacts& task = task_of(rule.task, rule.own_tasks, trial);
  if (task.right_is_yes) return nothing ? 2 : 1;
  if (!task.draws_right || nothing) return 0;
  Random random(rule.seed, trial_index);
  return 1 + static_cast<int>(random.below(task.alternatives));
}

std::vector<Trial> shown_pictures(const TaskFacts& task, const Trial& trial) {
  const Trial own{.kind = trial.kind, .stimulus = trial.stimulus};
  if (task.compares) return {{.kind = TrialKind::reference, .stimulus = trial.stimulus}, own};
  if (!task.draws_right) return {own};
  std::vector<Trial> shown(task.alternatives, {.kind = TrialKind::reference, .stimulus = trial.stimulus});
  if (trial.right_index >= 1) shown.at(trial.right_index - 1) = own;
  return shown;
}

}  // namespace seamline::study
