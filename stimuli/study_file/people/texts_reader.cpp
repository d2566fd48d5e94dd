#include "stimuli/study_file/people/texts_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/settings/people/session_settings.h"
#include "stimuli/study_file/people/study_file_recruitment.h"

namespace seamline::inline stimuli {
namespace {

/// What Seamline says of a kind of task where nothing else is set: what built-in files translate.
TaskTexts plain_texts(const TaskDefinition& task) {
  return usual_texts({.kind = task.kind, .same = task.same, .second_question = false, .slider = task.slider});
}

/// What a built-in file calls a text of a task: of a slider by a name of its own where the labels' differs.
std::string key_of(const TaskDefinition& task, const std::string& text) {
  return (task.slider ? "slider_" : "") + text;
}

/// One file of texts: what it may translate, and where that goes.
struct TextsReader {
  const StudyDefinition& study;
  const StudyDefinition shipped = {};  ///< what Seamline says of itself
  bool builtin = false;
  StudyTexts& into;

  /// Whether a built-in file knows this text, whose own words are `own` and usual ones `usual`.
  [[nodiscard]] bool counts(const std::string& own, const std::string& usual) const {
    return !builtin || own == usual;
  }
  void check_places(const TomlTable& table, const std::string& key, const std::string& own,
                    const std::string& text) const {
    const std::vector<std::string> allowed = places_in(own);
    for (const std::string& place : places_in(text))
      if (std::find(allowed.begin(), allowed.end(), place) == allowed.end())
        throw table.complaint(key, fmt::format("only places that \"{}\" has", own), "\"{" + place + "}\"");
  }
  void take(const TomlTable& table, const std::string& key, const std::string& own, const std::string& usual,
            std::string& target) const {
    const std::string text = table.text(key, "");
    if (text.empty() || !counts(own, usual)) return;
    check_places(table, key, own, text);
    target = text;
  }
  void take_list(const TomlTable& table, const std::string& key, const std::vector<std::string>& own,
                 const std::vector<std::string>& usual, std::vector<std::string>& target) const;
  void read_task_texts(const TomlTable& table) const;
  void read_usual_task_texts(const TomlTable& table) const;
  void read_usual_texts_of_conditions(const TomlTable& table) const;
  void read_usual_texts_of_objects(const TomlTable& table) const;
  void read_condition(const TomlTable& table) const;
  void set_page(const std::string& usual, const std::string& text) const;
  void read_form_field(const TomlTable& table) const;
  void read(const TomlTable& table) const;
};

/// As many texts that differ as the study has.
void TextsReader::take_list(const TomlTable& table, const std::string& key,
                            const std::vector<std::string>& own, const std::vector<std::string>& usual,
                            std::vector<std::string>& target) const {
  if (!table.has(key)) return;
  const std::vector<std::string> texts = table.texts(key);
  if (builtin && own != usual) return;
  const std::set<std::string> different(texts.begin(), texts.end());
  if (texts.size() != own.size() || different.size() != own.size() || different.contains(""))
    throw table.complaint(key, fmt::format("{} texts that differ, in the study's order", own.size()),
                          fmt::format("{}, {} of them different", texts.size(), different.size()));
  target = texts;
}

/// `[task]` of a study's own file of texts.
void TextsReader::read_task_texts(const TomlTable& table) const {
  const TaskDefinition* task = study.task.get();
  if (task == nullptr)
    throw table.complaint("answers", "no texts of a [task], which the study has not", "[task]");
  take_list(table, "answers", task->answers, task->answers, into.answers);
  take_list(table, "labels", task->labels, task->labels, into.labels);
  table.finish();
}

/// Whether a `[[task_texts]]` is of this task.
bool is_said_of(const TomlTable& table, const TaskDefinition* task) {
  const std::string kind = table.text("kind"), asks = table.text("asks", "");
  return task != nullptr && kind == word(task->kind) && task->same == (asks == "same");
}

/// `[[task_texts]]` of a built-in file: what Seamline says of one kind of task.
void TextsReader::read_usual_task_texts(const TomlTable& table) const {
  read_usual_texts_of_conditions(table);
  if (!is_said_of(table, study.task.get())) return;
  const TaskTexts usual = plain_texts(*study.task);
  take(table, "question", study.session.question, usual.question, into.question);
  take(table, "feedback_right", study.training.feedback_right, usual.feedback_right, into.feedback_right);
  take(table, "feedback_wrong", study.training.feedback_wrong, usual.feedback_wrong, into.feedback_wrong);
  const Phrase phrase = study.task->kind == TaskKind::rating ? Phrase::rating_hint : Phrase::choice_hint;
  std::string hint;
  take(table, key_of(*study.task, "hint"), phrase_text(study.texts, phrase), usual.hint, hint);
  if (!hint.empty()) into.texts[phrase] = hint;
  if (!study.task->answers.empty())
    take_list(table, "answers", study.task->answers, usual.answers, into.answers);
  if (!study.task->labels.empty())
    take_list(table, "labels", study.task->labels, impairment_labels(), into.labels);
  set_page(usual.instructions, table.text(key_of(*study.task, "instructions"), ""));
}

/// Each page of the instructions that has the text Seamline gives it.
void TextsReader::set_page(const std::string& usual, const std::string& text) const {
  for (std::size_t i = 0; i < study.instructions.size(); ++i)
    if (!text.empty() && !usual.empty() && study.instructions[i].text == usual) {
      into.instructions.resize(study.instructions.size());
      into.instructions[i] = text;
    }
}

/// The same of the conditions that ask so.
void TextsReader::read_usual_texts_of_conditions(const TomlTable& table) const {
  for (const ConditionDefinition& condition : study.conditions) {
    const TaskDefinition* task = condition.task.get();
    if (!is_said_of(table, task)) continue;
    const TaskTexts usual = plain_texts(*task);
    ConditionTexts& texts = into.conditions[condition.name];
    take(table, "question", task->own.question, usual.question, texts.own.question);
    take(table, key_of(*task, "hint"), task->own.hint, usual.hint, texts.own.hint);
    take(table, "feedback_right", task->own.feedback_right, usual.feedback_right, texts.own.feedback_right);
    take(table, "feedback_wrong", task->own.feedback_wrong, usual.feedback_wrong, texts.own.feedback_wrong);
    if (!task->answers.empty()) take_list(table, "answers", task->answers, usual.answers, texts.answers);
    if (!task->labels.empty()) take_list(table, "labels", task->labels, impairment_labels(), texts.labels);
    set_page(usual.instructions, table.text(key_of(*task, "instructions"), ""));
  }
}

/// Of conditions that ask which of three objects: what the built-in file says of the study.
void TextsReader::read_usual_texts_of_objects(const TomlTable& table) const {
  for (const ConditionDefinition& condition : study.conditions) {
    if (!condition.task) continue;
    const AskedTexts& own = condition.task->own;
    AskedTexts& texts = into.conditions[condition.name].own;
    const auto from = [&](const char* part, const std::string& key, const std::string& said,
                          const std::string& usual, std::string& target) {
      if (const auto found = table.table(part)) take(*found, key, said, usual, target);
    };
    const std::string choice_hint = phrase_text({}, Phrase::choice_hint),
                      rating_hint = phrase_text({}, Phrase::rating_hint);
    from("session", "question", own.question, shipped.session.question, texts.question);
    from("texts", "choice_hint", own.hint, choice_hint, texts.hint);
    from("texts", "rating_hint", own.rating_hint, rating_hint, texts.rating_hint);
    from("training", "feedback_right", own.feedback_right, shipped.training.feedback_right,
         texts.feedback_right);
    from("training", "feedback_wrong", own.feedback_wrong, shipped.training.feedback_wrong,
         texts.feedback_wrong);
  }
}

/// `[[condition]]` of a study's own file of texts.
void TextsReader::read_condition(const TomlTable& table) const {
  const std::string name = table.text("name");
  const auto own = std::find_if(study.conditions.begin(), study.conditions.end(),
                                [&](const ConditionDefinition& one) { return one.name == name; });
  if (own == study.conditions.end())
    throw table.complaint("name", "the name of a [[condition]] of the study", "\"" + name + "\"");
  ConditionTexts& texts = into.conditions[name];
  take(table, "instructions", own->instructions, own->instructions, texts.instructions);
  if (const TaskDefinition* task = own->task.get()) {
    for (const AskedKey& asked : every_asked_key())
      take(table, asked.key, task->own.*asked.word, task->own.*asked.word, texts.own.*asked.word);
    take_list(table, "answers", task->answers, task->answers, texts.answers);
    take_list(table, "labels", task->labels, task->labels, texts.labels);
  }
  table.finish();
}

void TextsReader::read_form_field(const TomlTable& table) const {
  const std::string name = table.text("name");
  FormFieldTexts texts{.label = table.text("label", "")};
  if (table.has("options")) texts.options = table.texts("options");
  table.finish();
  const auto is_named = [&](const FormField& field) { return field.name == name; };
  const auto own = std::find_if(study.form.begin(), study.form.end(), is_named);
  if (builtin) {
    const auto usual = std::find_if(shipped.form.begin(), shipped.form.end(), is_named);
    if (own == study.form.end() || usual == shipped.form.end() || own->label != usual->label) return;
    const auto *options = options_of(*own), *usual_options = options_of(*usual);
    if (own->kind.index() != usual->kind.index() || (options != nullptr && *options != *usual_options))
      return;
  }
  if (own == study.form.end())
    throw table.complaint("name", "the name of a [[form_field]] of the study", "\"" + name + "\"");
  const auto* options = options_of(*own);
  const std::size_t wanted = options == nullptr ? 0 : options->size();
  const std::set<std::string> different(texts.options.begin(), texts.options.end());
  if (!texts.options.empty() && (texts.options.size() != wanted || different.size() != wanted))
    throw table.complaint("options", fmt::format("{} texts that differ, in the study's order", wanted),
                          fmt::format("{}", different.size()));
  into.form[name] = texts;
}

void TextsReader::read(const TomlTable& table) const {
  if (table.text("format") != texts_format)
    throw table.complaint("format", fmt::format("\"{}\"", texts_format), "\"" + table.text("format") + "\"");
  if (const std::string tag = table.text("language"); tag != into.tag)
    throw table.complaint("language", "\"" + into.tag + "\", as [[language]] says", "\"" + tag + "\"");
  into.is_draft = table.boolean("draft", false) || into.is_draft;
  if (const auto session = table.table("session")) {
    take(*session, "question", study.session.question, shipped.session.question, into.question);
    take(*session, "rating_question", study.session.rating_question, shipped.session.rating_question,
         into.rating_question);
    if (session->has("rating_labels")) {
      const std::vector<std::string> labels = session->texts("rating_labels");
      if (labels.size() != study.session.rating_labels.size())
        throw session->complaint("rating_labels", fmt::format("{} texts", study.session.rating_labels.size()),
                                 fmt::format("{}", labels.size()));
      if (!builtin || study.session.rating_labels == shipped.session.rating_labels)
        into.rating_labels = labels;
    }
    session->finish();
  }
  if (const auto consent = table.table("consent")) {
    take(*consent, "text", study.consent.text, shipped.consent.text, into.consent);
    take(*consent, "accept", study.consent.accept, shipped.consent.accept, into.accept);
    take(*consent, "decline", study.consent.decline, shipped.consent.decline, into.decline);
    consent->finish();
  }
  if (const auto task = table.table("task")) read_task_texts(*task);
  if (builtin)
    for (const TomlTable& usual : table.tables("task_texts")) read_usual_task_texts(usual);
  if (builtin) read_usual_texts_of_objects(table);
  if (!builtin)
    for (const TomlTable& condition : table.tables("condition")) read_condition(condition);
  for (const TomlTable& field : table.tables("form_field")) read_form_field(field);
  if (const auto instructions = table.table("instructions")) {
    std::vector<std::string> pages;
    for (const TomlTable& page : instructions->tables("page")) {
      pages.push_back(page.text("text", ""));
      page.finish();
    }
    instructions->finish();
    if (!builtin && pages.size() != study.instructions.size())
      throw instructions->complaint("page", fmt::format("{} pages", study.instructions.size()),
                                    fmt::format("{}", pages.size()));
    if (!builtin) into.instructions = pages;
    for (std::size_t i = 0; builtin && i < std::min(pages.size(), shipped.instructions.size()); ++i)
      set_page(shipped.instructions[i].text, pages[i]);
  }
  if (const auto training = table.table("training")) {
    take(*training, "feedback_right", study.training.feedback_right, shipped.training.feedback_right,
         into.feedback_right);
    take(*training, "feedback_wrong", study.training.feedback_wrong, shipped.training.feedback_wrong,
         into.feedback_wrong);
    training->finish();
  }
  if (const auto texts = table.table("texts")) {
    for (const PhraseEntry& entry : every_phrase()) {
      std::string text;
      take(*texts, std::string(entry.key), phrase_text(study.texts, entry.phrase), std::string(entry.english),
           text);
      if (!text.empty()) into.texts[entry.phrase] = text;
    }
    const std::map<std::string, std::string> own = page_texts_of(study);
    for (const auto known : {every_recruitment_text(), every_language_text()})
      for (const PageText& entry : known) {
        const std::string key(entry.key);
        const auto found = own.find(key);
        std::string text;
        take(*texts, key, found == own.end() ? std::string(entry.english) : found->second,
             std::string(entry.english), text);
        if (!text.empty()) into.page_texts[key] = text;
      }
    texts->finish();
  }
  table.finish();
}

}  // namespace

void read_texts_file(const TomlTable& file, const StudyDefinition& study, bool builtin, StudyTexts& into) {
  TextsReader{.study = study, .builtin = builtin, .into = into}.read(file);
}

}  // namespace seamline::inline stimuli
