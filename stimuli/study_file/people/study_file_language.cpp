#include "stimuli/study_file/people/study_file_language.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/settings/people/language_settings.h"
#include "stimuli/settings/people/session_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/people/study_file_recruitment.h"
#include "stimuli/study_file/people/texts_reader.h"
#include "support/files/assets.h"
#include "support/files/confined_path.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;
namespace {

constexpr const char* builtin_texts = "builtin:";

bool is_builtin_texts(const std::string& file) {
  return file.starts_with(builtin_texts);
}

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '\n') {
      quoted += "\\n";
      continue;
    }
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + "\"";
}

std::string toml_list(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml_text(text);
  return "[" + list + "]";
}

/// What a condition says in words of its own; empty: nothing.
std::string condition_lines(const ConditionDefinition& condition,
                            const std::function<std::string(const std::string&)>& mark) {
  std::string lines;
  const auto add = [&](const std::string& key, const std::string& value) {
    lines += mark("condition." + condition.name + "." + key) + fmt::format("{} = {}\n", key, value);
  };
  if (!condition.instructions.empty()) add("instructions", toml_text(condition.instructions));
  if (const TaskDefinition* task = condition.task.get()) {
    for (const AskedKey& asked : every_asked_key())
      if (!(task->own.*asked.word).empty()) add(asked.key, toml_text(task->own.*asked.word));
    if (!task->answers.empty()) add("answers", toml_list(task->answers));
    if (!task->labels.empty()) add("labels", toml_list(task->labels));
  }
  return lines.empty() ? lines
                       : fmt::format("\n[[condition]]\nname = {}\n", toml_text(condition.name)) + lines;
}

}  // namespace

bool is_language_tag(const std::string& text) {
  return fault_of_language({.language = text}).empty();
}

std::shared_ptr<const LanguageDefinitions> read_languages(const TomlTable& study, const std::string& own) {
  LanguageDefinitions read;
  std::set<std::string> tags = {own};
  for (const TomlTable& table : study.tables("language")) {
    LanguageDefinition language;
    read_settings(table, language);
    if (!is_language_tag(language.tag) || !tags.insert(language.tag).second)
      throw table.complaint(
          "tag",
          "a tag such as \"de\" or \"pt-BR\", other than \"" + own + "\" (session.language) and those above",
          "\"" + language.tag + "\"");
    if (table.is_text("texts"))
      language.texts = {table.text("texts")};
    else
      read_setting(table, "texts", language);
    for (const std::string& file : language.texts)
      if (!is_builtin_texts(file) && !is_written_below(file))
        throw table.complaint("texts", "builtin:TAG, or a file beside the study file or in a folder below it",
                              "\"" + file + "\"");
    table.finish();
    read.languages.push_back(std::move(language));
  }
  if (read.languages.empty()) return nullptr;
  if (const auto texts = study.table("texts")) read.texts = read_page_texts(*texts, every_language_text());
  return std::make_shared<const LanguageDefinitions>(std::move(read));
}

std::vector<std::string> language_files(const StudyDefinition& study) {
  std::vector<std::string> files;
  if (study.languages)
    for (const LanguageDefinition& language : study.languages->languages) {
      std::vector<std::string> named = language.texts;
      if (!language.font.empty()) named.push_back(language.font);
      for (const std::string& file : named)
        if (!is_builtin_texts(file) && std::find(files.begin(), files.end(), file) == files.end())
          files.push_back(file);
    }
  return files;
}

StudyTexts read_study_texts(const StudyDefinition& study, const LanguageDefinition& language) {
  StudyTexts texts{.tag = language.tag, .font = language.font, .consent = {}};
  for (const std::string& file : language.texts) {
    const bool builtin = is_builtin_texts(file);
    const fs::path path = builtin ? builtin_study("texts/" + file.substr(std::string(builtin_texts).size()))
                                  : study.file.parent_path() / file;
    if (std::error_code error; !fs::is_regular_file(path, error))
      throw input_error({.file = study.file.string(),
                         .field = "language.texts",
                         .wanted = builtin ? "builtin:de, es, fr, ja, zh or ar" : "a file that is there",
                         .found = "\"" + file + "\""});
    read_texts_file(TomlTable::read(path), study, builtin, texts);
  }
  return texts;
}

std::optional<StudyTexts> read_study_texts(const StudyDefinition& study, const std::string& tag,
                                           const std::string& where) {
  if (tag == study.session.language) return std::nullopt;
  std::string known = study.session.language;
  if (study.languages)
    for (const LanguageDefinition& language : study.languages->languages) {
      if (language.tag == tag) return read_study_texts(study, language);
      known += ", " + language.tag;
    }
  throw input_error(
      {.field = where, .wanted = "a language of the study: " + known, .found = "\"" + tag + "\""});
}

std::string texts_to_translate(const StudyDefinition& study, const StudyTexts& known) {
  const StudyDefinition read = in_language(study, known);
  const std::vector<std::string> missing = missing_texts(study, known);
  const auto mark = [&](const std::string& key) {
    return std::find(missing.begin(), missing.end(), key) == missing.end() ? "" : "# to translate\n";
  };
  std::string out = fmt::format(
      "# Texts of the study \"{}\". Places like {{done}} are filled in, and stay as they are.\n"
      "format = \"{}\"\nlanguage = {}\n{}\n[session]\n",
      study.name, texts_format, toml_text(known.tag), known.is_draft ? "draft = true\n" : "");
  const auto line = [&](const std::string& table, const std::string& key, const std::string& text) {
    if (!text.empty()) out += mark(table + "." + key) + fmt::format("{} = {}\n", key, toml_text(text));
  };
  line("session", "question", read.session.question);
  line("session", "rating_question", read.session.rating_question);
  out += mark("session.rating_labels") +
         fmt::format("rating_labels = {}\n",
                     toml_list({read.session.rating_labels.begin(), read.session.rating_labels.end()}));
  if (read.task && !(read.task->answers.empty() && read.task->labels.empty())) {
    out += "\n[task]\n";
    const auto list = [&](const std::string& key, const std::vector<std::string>& texts) {
      if (!texts.empty()) out += mark("task." + key) + fmt::format("{} = {}\n", key, toml_list(texts));
    };
    list("answers", read.task->answers);
    list("labels", read.task->labels);
  }
  for (const ConditionDefinition& condition : read.conditions) out += condition_lines(condition, mark);
  out += "\n[consent]\n";
  if (!is_default_consent(study.consent) || !known.consent.empty())
    line("consent", "text", read.consent.text);
  line("consent", "accept", read.consent.accept);
  line("consent", "decline", read.consent.decline);
  for (const FormField& field : read.form) {
    out += fmt::format("\n[[form_field]]\nname = {}\n", toml_text(field.name));
    out += mark("form_field." + field.name + ".label") + fmt::format("label = {}\n", toml_text(field.label));
    if (const auto* options = options_of(field))
      out +=
          mark("form_field." + field.name + ".options") + fmt::format("options = {}\n", toml_list(*options));
  }
  for (std::size_t i = 0; i < read.instructions.size(); ++i)
    out += "\n[[instructions.page]]\n" + std::string(mark(fmt::format("instructions.page[{}].text", i))) +
           fmt::format("text = {}\n", toml_text(read.instructions[i].text));
  out += "\n[training]\n";
  line("training", "feedback_right", read.training.feedback_right);
  line("training", "feedback_wrong", read.training.feedback_wrong);
  out += "\n[texts]\n";
  for (const PhraseEntry& entry : every_phrase())
    line("texts", std::string(entry.key), phrase_text(read.texts, entry.phrase));
  for (const auto& [key, text] : page_texts_of(read)) line("texts", key, text);
  return out;
}

}  // namespace seamline::inline stimuli
