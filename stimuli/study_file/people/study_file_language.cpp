#include "stimuli/study_file/people/study_file_language.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/settings/people/session_settings.h"
#include "stimuli/study_file/people/study_file_recruitment.h"
#include "support/files/assets.h"
#include "support/files/confined_path.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;
namespace {

constexpr const char* texts_format = "seamline texts 1";
constexpr const char* builtin_texts = "builtin:";

bool is_builtin_texts(const std::string& file) {
  return file.starts_with(builtin_texts);
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

/// `[[task_texts]]` of a built-in file: what Seamline says of one kind of task.
void TextsReader::read_usual_task_texts(const TomlTable& table) const {
  const std::string kind = table.text("kind");
  if (!study.task || study.task->same || kind != word(study.task->kind)) return;
  const TaskTexts usual = usual_texts(*study.task);
  take(table, "question", study.session.question, usual.question, into.question);
  take(table, "feedback_right", study.training.feedback_right, usual.feedback_right, into.feedback_right);
  take(table, "feedback_wrong", study.training.feedback_wrong, usual.feedback_wrong, into.feedback_wrong);
  const Phrase phrase = study.task->kind == TaskKind::rating ? Phrase::rating_hint : Phrase::choice_hint;
  std::string hint;
  take(table, "hint", phrase_text(study.texts, phrase), usual.hint, hint);
  if (!hint.empty()) into.texts[phrase] = hint;
  if (!study.task->answers.empty())
    take_list(table, "answers", study.task->answers, usual.answers, into.answers);
  if (!study.task->labels.empty())
    take_list(table, "labels", study.task->labels, impairment_labels(), into.labels);
  std::string instructions;
  if (study.instructions.size() == 1)
    take(table, "instructions", study.instructions.front().text, usual.instructions, instructions);
  if (!instructions.empty()) into.instructions = {instructions};
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
    const auto* options = std::get_if<ChoiceField>(&own->kind);
    const auto* usual_options = std::get_if<ChoiceField>(&usual->kind);
    if ((options == nullptr) != (usual_options == nullptr) ||
        (options != nullptr && options->options != usual_options->options))
      return;
  }
  if (own == study.form.end())
    throw table.complaint("name", "the name of a [[form_field]] of the study", "\"" + name + "\"");
  const auto* choice = std::get_if<ChoiceField>(&own->kind);
  const std::size_t wanted = choice == nullptr ? 0 : choice->options.size();
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
  for (const TomlTable& field : table.tables("form_field")) read_form_field(field);
  if (const auto instructions = table.table("instructions")) {
    std::vector<std::string> pages;
    for (const TomlTable& page : instructions->tables("page")) {
      pages.push_back(page.text("text", ""));
      page.finish();
    }
    instructions->finish();
    const auto same = [](const InstructionPage& a, const InstructionPage& b) { return a.text == b.text; };
    const bool usual = std::equal(study.instructions.begin(), study.instructions.end(),
                                  shipped.instructions.begin(), shipped.instructions.end(), same);
    if (!builtin && pages.size() != study.instructions.size())
      throw instructions->complaint("page", fmt::format("{} pages", study.instructions.size()),
                                    fmt::format("{}", pages.size()));
    if (!builtin || usual) into.instructions = pages;
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

}  // namespace

bool is_language_tag(const std::string& text) {
  return fault_of_language({.language = text}).empty();
}

std::shared_ptr<const LanguageDefinitions> read_languages(const TomlTable& study, const std::string& own) {
  LanguageDefinitions read;
  std::set<std::string> tags = {own};
  for (const TomlTable& table : study.tables("language")) {
    LanguageDefinition language{.tag = table.text("tag"), .texts = {}};
    if (!is_language_tag(language.tag) || !tags.insert(language.tag).second)
      throw table.complaint(
          "tag",
          "a tag such as \"de\" or \"pt-BR\", other than \"" + own + "\" (session.language) and those above",
          "\"" + language.tag + "\"");
    if (table.is_text("texts"))
      language.texts = {table.text("texts")};
    else
      language.texts = table.texts("texts");
    language.font = table.text("font", "");
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
    TextsReader{.study = study, .builtin = builtin, .into = texts}.read(TomlTable::read(path));
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
  out += "\n[consent]\n";
  if (!is_default_consent(study.consent) || !known.consent.empty())
    line("consent", "text", read.consent.text);
  line("consent", "accept", read.consent.accept);
  line("consent", "decline", read.consent.decline);
  for (const FormField& field : read.form) {
    out += fmt::format("\n[[form_field]]\nname = {}\n", toml_text(field.name));
    out += mark("form_field." + field.name + ".label") + fmt::format("label = {}\n", toml_text(field.label));
    if (const auto* choice = std::get_if<ChoiceField>(&field.kind))
      out += mark("form_field." + field.name + ".options") +
             fmt::format("options = {}\n", toml_list(choice->options));
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
