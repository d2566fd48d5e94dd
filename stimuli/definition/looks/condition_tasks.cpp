#include "stimuli/definition/looks/condition_tasks.h"

#include <algorithm>

namespace seamline::inline stimuli {

std::shared_ptr<const TaskDefinition> task_of(const StudyDefinition& study, const std::string& condition) {
  for (const ConditionDefinition& one : study.conditions)
    if (one.name == condition && one.task) return one.task;
  return study.task;
}

bool has_own_tasks(const StudyDefinition& study) {
  return std::any_of(study.conditions.begin(), study.conditions.end(),
                     [](const ConditionDefinition& condition) { return condition.task != nullptr; });
}

std::string meaning_of_task(const TaskDefinition* task) {
  static const TaskDefinition papers;
  return canonical_text(task == nullptr ? &papers : task);
}

std::vector<TaskGroup> task_groups(const StudyDefinition& study) {
  std::vector<TaskGroup> groups = {{.task = study.task, .conditions = {}}};
  for (const ConditionDefinition& condition : study.conditions) {
    const std::shared_ptr<const TaskDefinition> task = condition.task ? condition.task : study.task;
    const std::string meaning = meaning_of_task(task.get());
    auto found = std::find_if(groups.begin(), groups.end(), [&](const TaskGroup& group) {
      return meaning_of_task(group.task.get()) == meaning;
    });
    if (found == groups.end()) found = groups.insert(groups.end(), TaskGroup{.task = task, .conditions = {}});
    found->conditions.push_back(condition.name);
  }
  if (groups.size() > 1 && groups.front().conditions.empty()) groups.erase(groups.begin());
  return groups;
}

StudyDefinition study_of_group(const StudyDefinition& study, const TaskGroup& group) {
  StudyDefinition part = study;
  part.task = group.task;
  std::erase_if(part.conditions, [&](const ConditionDefinition& condition) {
    return std::find(group.conditions.begin(), group.conditions.end(), condition.name) ==
           group.conditions.end();
  });
  for (ConditionDefinition& condition : part.conditions) condition.task = nullptr;
  return part;
}

AskedTexts asked_texts(const StudyDefinition& study, const TaskDefinition* task) {
  const bool only_rates = !facts_of(task).chooses;
  AskedTexts texts{.question = study.session.question,
                   .hint = phrase_text(study.texts, only_rates ? Phrase::rating_hint : Phrase::choice_hint),
                   .rating_hint = phrase_text(study.texts, Phrase::rating_hint),
                   .feedback_right = study.training.feedback_right,
                   .feedback_wrong = study.training.feedback_wrong};
  if (task == nullptr) return texts;
  for (std::string AskedTexts::*text : {&AskedTexts::question, &AskedTexts::hint, &AskedTexts::rating_hint,
                                        &AskedTexts::feedback_right, &AskedTexts::feedback_wrong})
    if (!(task->own.*text).empty()) texts.*text = task->own.*text;
  return texts;
}

}  // namespace seamline::inline stimuli
