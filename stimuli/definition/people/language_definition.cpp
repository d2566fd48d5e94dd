#include "stimuli/definition/people/language_definition.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/people/form_kinds.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::array<PageText, 1> language_texts = {{{"language", "Language"}}};

void replace(std::string& text, const std::string& translated) {
  if (!translated.empty()) text = translated;
}

FormField in_language(FormField field, const StudyTexts& texts) {
  const auto found = texts.form.find(field.name);
  if (found == texts.form.end()) return field;
  replace(field.label, found->second.label);
  if (auto* options = options_of(field);
      options != nullptr && options->size() == found->second.options.size())
    *options = found->second.options;
  return field;
}

void list_missing_of_form(const std::vector<FormField>& form, const StudyTexts& texts,
                          std::vector<std::string>& missing) {
  for (const FormField& field : form) {
    const auto found = texts.form.find(field.name);
    const bool known = found != texts.form.end();
    if (!known || found->second.label.empty()) missing.push_back("form_field." + field.name + ".label");
    const auto* options = options_of(field);
    if (options != nullptr && (!known || found->second.options.size() != options->size()))
      missing.push_back("form_field." + field.name + ".options");
  }
}

}  // namespace

namespace {

constexpr std::array<std::string AskedTexts::*, 5> asked_words = {
    &AskedTexts::question, &AskedTexts::hint, &AskedTexts::rating_hint, &AskedTexts::feedback_right,
    &AskedTexts::feedback_wrong};
constexpr std::array<const char*, 5> asked_keys = {"question", "hint", "rating_hint", "feedback_right",
                                                   "feedback_wrong"};

void list_missing_of_conditions(const StudyDefinition& study, const StudyTexts& texts,
                                std::vector<std::string>& missing) {
  for (const ConditionDefinition& condition : study.conditions) {
    const auto found = texts.conditions.find(condition.name);
    const ConditionTexts known = found == texts.conditions.end() ? ConditionTexts{} : found->second;
    const auto want = [&](const std::string& key, bool is_missing) {
      if (is_missing) missing.push_back("condition." + condition.name + "." + key);
    };
    want("instructions", !condition.instructions.empty() && known.instructions.empty());
    if (!condition.task) continue;
    for (std::size_t i = 0; i < asked_words.size(); ++i)
      want(asked_keys[i],
           !(condition.task->own.*asked_words[i]).empty() && (known.own.*asked_words[i]).empty());
    want("answers", known.answers.size() != condition.task->answers.size());
    want("labels", known.labels.size() != condition.task->labels.size());
  }
}

ConditionDefinition in_language(ConditionDefinition condition, const StudyTexts& texts) {
  const auto found = texts.conditions.find(condition.name);
  if (found == texts.conditions.end()) return condition;
  const ConditionTexts& known = found->second;
  replace(condition.instructions, known.instructions);
  if (!condition.task) return condition;
  TaskDefinition task = *condition.task;
  for (const auto word : asked_words) replace(task.own.*word, known.own.*word);
  if (known.answers.size() == task.answers.size()) task.answers = known.answers;
  if (known.labels.size() == task.labels.size()) task.labels = known.labels;
  condition.task = std::make_shared<const TaskDefinition>(std::move(task));
  return condition;
}

}  // namespace

std::vector<AskedKey> every_asked_key() {
  std::vector<AskedKey> keys;
  for (std::size_t i = 0; i < asked_words.size(); ++i) keys.push_back({asked_keys[i], asked_words[i]});
  return keys;
}

std::span<const PageText> every_language_text() {
  return language_texts;
}

std::vector<std::string> missing_texts(const StudyDefinition& study, const StudyTexts& texts) {
  std::vector<std::string> missing;
  const auto want = [&](const std::string& key, const std::string& own, const std::string& translated) {
    if (translated.empty() && !own.empty()) missing.push_back(key);
  };
  want("session.question", study.session.question, texts.question);
  want("session.rating_question", study.session.rating_question, texts.rating_question);
  if (texts.rating_labels.empty()) missing.emplace_back("session.rating_labels");
  if (!is_default_consent(study.consent)) want("consent.text", study.consent.text, texts.consent);
  want("consent.accept", study.consent.accept, texts.accept);
  want("consent.decline", study.consent.decline, texts.decline);
  list_missing_of_form(study.form, texts, missing);
  for (std::size_t i = 0; i < study.instructions.size(); ++i)
    want(fmt::format("instructions.page[{}].text", i), study.instructions[i].text,
         i < texts.instructions.size() ? texts.instructions[i] : "");
  if (study.task && texts.answers.size() != study.task->answers.size()) missing.emplace_back("task.answers");
  if (study.task && texts.labels.size() != study.task->labels.size()) missing.emplace_back("task.labels");
  list_missing_of_conditions(study, texts, missing);
  want("training.feedback_right", study.training.feedback_right, texts.feedback_right);
  want("training.feedback_wrong", study.training.feedback_wrong, texts.feedback_wrong);
  for (const PhraseEntry& entry : every_phrase())
    if (!texts.texts.contains(entry.phrase)) missing.push_back("texts." + std::string(entry.key));
  for (const auto& [key, text] : page_texts_of(study))
    if (!texts.page_texts.contains(key)) missing.push_back("texts." + key);
  return missing;
}

StudyDefinition in_language(const StudyDefinition& study, const StudyTexts& texts) {
  StudyDefinition read = study;
  read.session.language = texts.tag;
  replace(read.session.question, texts.question);
  replace(read.session.rating_question, texts.rating_question);
  replace(read.session.font, texts.font);
  if (texts.rating_labels.size() == read.session.rating_labels.size())
    std::copy(texts.rating_labels.begin(), texts.rating_labels.end(), read.session.rating_labels.begin());
  replace(read.consent.text, texts.consent);
  replace(read.consent.accept, texts.accept);
  replace(read.consent.decline, texts.decline);
  for (FormField& field : read.form) field = in_language(field, texts);
  for (std::size_t i = 0; i < std::min(read.instructions.size(), texts.instructions.size()); ++i)
    replace(read.instructions[i].text, texts.instructions[i]);
  replace(read.training.feedback_right, texts.feedback_right);
  replace(read.training.feedback_wrong, texts.feedback_wrong);
  for (const auto& [phrase, text] : texts.texts) read.texts[phrase] = text;
  if (study.task) {
    auto task = std::make_shared<TaskDefinition>(*study.task);
    if (texts.answers.size() == task->answers.size()) task->answers = texts.answers;
    if (texts.labels.size() == task->labels.size()) task->labels = texts.labels;
    read.task = task;
  }
  for (ConditionDefinition& condition : read.conditions) condition = in_language(condition, texts);
  if (study.recruitment) {
    auto recruitment = std::make_shared<RecruitmentDefinition>(*study.recruitment);
    for (const PageText& entry : every_recruitment_text())
      if (const auto own = texts.page_texts.find(std::string(entry.key)); own != texts.page_texts.end())
        recruitment->texts[own->first] = own->second;
    read.recruitment = recruitment;
  }
  if (study.languages) {
    auto languages = std::make_shared<LanguageDefinitions>(*study.languages);
    for (const PageText& entry : every_language_text())
      if (const auto own = texts.page_texts.find(std::string(entry.key)); own != texts.page_texts.end())
        languages->texts[own->first] = own->second;
    read.languages = languages;
  }
  return read;
}

std::vector<FormAnswer> answers_of_study(std::span<const FormField> own,
                                         std::span<const FormField> translated,
                                         std::span<const FormAnswer> answers) {
  std::vector<FormAnswer> turned(answers.begin(), answers.end());
  for (FormAnswer& answer : turned)
    for (std::size_t i = 0; i < std::min(own.size(), translated.size()); ++i) {
      const auto *from = options_of(translated[i]), *into = options_of(own[i]);
      if (own[i].name != answer.field || number_of(own[i]) || from == nullptr || into == nullptr) continue;
      const auto at = std::find(from->begin(), from->end(), answer.value);
      if (at != from->end()) answer.value = into->at(static_cast<std::size_t>(at - from->begin()));
    }
  return turned;
}

std::map<std::string, std::string> page_texts_of(const StudyDefinition& study) {
  std::map<std::string, std::string> texts;
  const auto add = [&](std::span<const PageText> known, const std::map<std::string, std::string>& own) {
    for (const PageText& entry : known) texts[std::string(entry.key)] = entry.english;
    for (const auto& [key, text] : own) texts[key] = text;
  };
  if (study.recruitment) add(every_recruitment_text(), study.recruitment->texts);
  if (study.languages) add(every_language_text(), study.languages->texts);
  return texts;
}

}  // namespace seamline::inline stimuli
