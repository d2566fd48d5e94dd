#include "study/visit/visit_script.h"

#include <algorithm>
#include <utility>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/moving/clip_definition.h"
#include "study/trials/participant_trials.h"
#include "study/trials/training_trials.h"
#include "study/trials/trial_picture.h"

namespace seamline::study {
namespace {

/// Nobody has seen a picture and answered it sooner after its onset: that was a press of before, or of two
/// keys.
constexpr std::int64_t fastest_choice_ns = 100'000'000;

std::int64_t nanoseconds(double seconds) {
  return static_cast<std::int64_t>(seconds * 1e9);
}

/// After which the question is open: once a clip has been shown, where it is asked after it.
double viewing_s(const StudyDefinition& study) {
  const ClipDefinition* clip = study.clip.get();
  if (clip == nullptr || clip->question == ClipQuestion::during) return study.session.minimum_viewing_s;
  return std::max(study.session.minimum_viewing_s, clip->frames / clip->frames_per_s);
}

SessionTask session_task(const TaskDefinition* task) {
  if (task == nullptr) return {};
  return {.facts = facts_of(task),
          .exposure_ns = nanoseconds(task->exposure_s),
          .gap_ns = nanoseconds(task->gap_s),
          .mask_ns = task->mask == TaskMask::none ? 0 : nanoseconds(task->mask_s),
          .ladders = {}};
}

SessionTask session_task(const RenderedSet& set) {
  SessionTask task = session_task(set.study.task.get());
  if (task.facts.adjusts()) task.ladders = make_trial_rules(set).ladders;
  return task;
}

OwnSessionTasks own_session_tasks(const RenderedSet& set) {
  if (!has_own_tasks(set.study)) return nullptr;
  std::vector<SessionTask> tasks;
  for (const ManifestStimulus& record : set.manifest.stimuli)
    tasks.push_back(session_task(stimuli::task_of(set.study, record.stimulus.condition).get()));
  return std::make_shared<const std::vector<SessionTask>>(std::move(tasks));
}

BriefedBlocks briefed_blocks(const RenderedSet& set) {
  const std::vector<ConditionDefinition>& conditions = set.study.conditions;
  const auto is_briefed = [](const ConditionDefinition& one) { return !one.instructions.empty(); };
  if (std::none_of(conditions.begin(), conditions.end(), is_briefed)) return nullptr;
  std::vector<int> blocks;
  for (const ManifestStimulus& record : set.manifest.stimuli) {
    const auto own = std::find_if(conditions.begin(), conditions.end(),
                                  [&](const auto& one) { return one.name == record.stimulus.condition; });
    const bool has = own != conditions.end() && is_briefed(*own);
    blocks.push_back(has ? static_cast<int>(own - conditions.begin()) : -1);
  }
  return std::make_shared<const std::vector<int>>(std::move(blocks));
}

}  // namespace

VisitScript make_visit_script(const RenderedSet& set) {
  const StudyDefinition& study = set.study;
  VisitScript script{
      .form = study.form,
      .instruction_pages = static_cast<int>(study.instructions.size()),
      .training = training_trials(set),
      .pace = {.break_every_trials = study.session.break_every_trials,
               .minimum_viewing_ns = std::max(fastest_choice_ns, nanoseconds(viewing_s(study))),
               .inter_trial_ns = nanoseconds(study.session.inter_trial_s),
               .task = session_task(set),
               .own_tasks = own_session_tasks(set),
               .briefed = briefed_blocks(set)},
      .training_rule = right_rule(facts_of(study.task.get()), study.seed, 0, own_tasks_of(set))};
  for (std::size_t i = 0; i < script.training.size(); ++i)
    script.training[i].right_index =
        right_index_of(script.training_rule, script.training[i], static_cast<int>(i));
  for (const Trial& trial : script.training) script.training_right.push_back(right_object(set, trial));
  return script;
}

}  // namespace seamline::study
