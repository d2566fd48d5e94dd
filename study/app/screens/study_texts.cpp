#include "study/app/screens/study_texts.h"

#include <fmt/core.h>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/people/form_kinds.h"

namespace seamline::study::app {

std::vector<ShownText> shown_texts(const StudyDefinition& study) {
  std::vector<ShownText> texts = {{"session.question", study.session.question},
                                  {"session.rating_question", study.session.rating_question},
                                  {"consent.text", study.consent.text},
                                  {"consent.accept", study.consent.accept},
                                  {"consent.decline", study.consent.decline},
                                  {"training.feedback_right", study.training.feedback_right},
                                  {"training.feedback_wrong", study.training.feedback_wrong}};
  for (const std::string& label : study.session.rating_labels)
    texts.push_back({"session.rating_labels", label});
  for (const TaskGroup& group : task_groups(study)) {
    const TaskDefinition* task = group.task.get();
    if (task == nullptr) continue;
    const std::string table = task == study.task.get() ? "task" : "condition.task";
    for (const std::string& answer : task->answers) texts.push_back({table + ".answers", answer});
    for (const std::string& label : task->labels) texts.push_back({table + ".labels", label});
    if (!task->own.question.empty()) texts.push_back({table + ".question", task->own.question});
  }
  for (const ConditionDefinition& condition : study.conditions)
    if (!condition.instructions.empty()) texts.push_back({"condition.instructions", condition.instructions});
  for (const FormField& field : study.form) {
    const std::string where = "form." + field.name;
    texts.push_back({where, field.label});
    if (const auto* options = options_of(field))
      for (const std::string& option : *options) texts.push_back({where, option});
  }
  for (std::size_t i = 0; i < study.instructions.size(); ++i)
    texts.push_back({fmt::format("instructions[{}]", i), study.instructions[i].text});
  for (const PhraseEntry& entry : every_phrase())
    texts.push_back({fmt::format("texts.{}", entry.key), phrase_text(study.texts, entry.phrase)});
  return texts;
}

}  // namespace seamline::study::app
