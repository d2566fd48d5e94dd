#include "study/app/screens/study_texts.h"

#include <fmt/core.h>

#include "stimuli/definition/parts/task_definition.h"

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
  if (study.task) {
    for (const std::string& answer : study.task->answers) texts.push_back({"task.answers", answer});
    for (const std::string& label : study.task->labels) texts.push_back({"task.labels", label});
  }
  for (const FormField& field : study.form) {
    const std::string where = "form." + field.name;
    texts.push_back({where, field.label});
    if (const auto* choice = std::get_if<ChoiceField>(&field.kind))
      for (const std::string& option : choice->options) texts.push_back({where, option});
  }
  for (std::size_t i = 0; i < study.instructions.size(); ++i)
    texts.push_back({fmt::format("instructions[{}]", i), study.instructions[i].text});
  for (const PhraseEntry& entry : every_phrase())
    texts.push_back({fmt::format("texts.{}", entry.key), phrase_text(study.texts, entry.phrase)});
  return texts;
}

}  // namespace seamline::study::app
