#include "stimuli/study_file/study_file_people.h"

#include <set>

#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/settings/people/form_settings.h"
#include "stimuli/settings/people/session_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "stimuli/study_file/people/study_file_recruitment.h"

namespace seamline::inline stimuli {
namespace {

ConsentDefinition read_consent(const TomlTable& table) {
  ConsentDefinition consent = default_consent();
  read_settings(table, consent);
  table.finish();
  return consent;
}

FormField read_form_field(const TomlTable& table) {
  FormField field;
  read_settings(table, field);
  std::visit([&](auto& kind) { read_settings(table, kind); }, field.kind);
  if (const auto number = number_of(field); number && number->least > number->most)
    throw table.complaint("most", fmt::format("at least {}", number->least), fmt::format("{}", number->most));
  if (const auto* options = options_of(field)) {
    const std::set<std::string> different(options->begin(), options->end());
    if (options->size() < 2 || different.size() != options->size() || different.contains(""))
      throw table.complaint("options", "at least two texts that differ",
                            fmt::format("{}, {} of them different", options->size(), different.size()));
  }
  table.finish();
  return field;
}

std::vector<FormField> read_form(const TomlTable& study) {
  const bool asked = study.boolean("participant_form", true);
  std::vector<FormField> form;
  std::set<std::string> names;
  for (const TomlTable& table : study.tables("form_field")) {
    form.push_back(read_form_field(table));
    if (!names.insert(form.back().name).second)
      throw table.complaint("name", "a name that no other field has", "\"" + form.back().name + "\"");
  }
  if (!asked && !form.empty())
    throw study.complaint("participant_form", "true where there is a [[form_field]]", "false");
  return asked && form.empty() ? default_form() : form;
}

std::vector<InstructionPage> read_instructions(const TomlTable& table) {
  std::vector<InstructionPage> pages;
  for (const TomlTable& page : table.tables("page")) {
    InstructionPage read;
    read_settings(page, read);
    page.finish();
    if (read.text.empty() && read.pictures.empty())
      throw page.complaint("text", "a text, or pictures", "neither");
    pages.push_back(std::move(read));
  }
  table.finish();
  if (pages.empty()) throw table.complaint("page", "at least one [[instructions.page]]", "none");
  return pages;
}

TrainingDefinition read_training(const TomlTable& table) {
  TrainingDefinition training;
  if (table.has("stimuli")) {
    if (table.has("trials"))
      throw table.complaint("trials", "either trials or stimuli in [training]", "both");
    training.stimuli = table.texts("stimuli");
    training.trials = static_cast<int>(training.stimuli.size());
  }
  read_settings(table, training);
  table.finish();
  return training;
}

/// The `{word}` places of a text.
std::set<std::string> places_of(const std::string& text) {
  std::set<std::string> places;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string::npos) break;
    places.insert(text.substr(open, close - open + 1));
  }
  return places;
}

/// `more`: keys that another reader has read.
InterfaceTexts read_texts(const TomlTable& table, std::span<const PageText> more) {
  InterfaceTexts texts;
  for (const PageText& entry : more) static_cast<void>(table.has(std::string(entry.key)));
  for (const PhraseEntry& entry : every_phrase()) {
    const std::string key(entry.key);
    if (!table.has(key)) continue;
    const std::string text = table.text(key);
    const std::set<std::string> known = places_of(std::string(entry.english));
    for (const std::string& place : places_of(text))
      if (!known.contains(place))
        throw table.complaint(key, fmt::format("only places that \"{}\" has", entry.english),
                              "\"" + place + "\"");
    texts[entry.phrase] = text;
  }
  table.finish();
  return texts;
}

}  // namespace

void read_people(const TomlTable& study, StudyDefinition& definition) {
  if (const auto consent = study.table("consent")) definition.consent = read_consent(*consent);
  definition.form = read_form(study);
  if (const auto pages = study.table("instructions")) definition.instructions = read_instructions(*pages);
  if (const auto training = study.table("training")) definition.training = read_training(*training);
  definition.recruitment = read_recruitment(study, definition.form, definition.catches.attention);
  definition.languages = read_languages(study, definition.session.language);
  std::vector<PageText> more;
  const auto add = [&](std::span<const PageText> known) {
    more.insert(more.end(), known.begin(), known.end());
  };
  if (definition.recruitment) add(every_recruitment_text());
  if (definition.languages) add(every_language_text());
  if (const auto texts = study.table("texts")) definition.texts = read_texts(*texts, more);
}

}  // namespace seamline::inline stimuli
