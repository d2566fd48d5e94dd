#pragma once
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/people/recruitment_definition.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::inline stimuli {

/// `[[language]]`: a language besides the study's own (`session.language`), and the files of its texts.
struct LanguageDefinition {
  std::string tag;                 ///< of BCP 47
  std::vector<std::string> texts;  ///< `builtin:de`, or files beside the study file; later ones win
  std::string font = {};           ///< a TrueType file beside the study file; empty: the study's
  bool operator==(const LanguageDefinition&) const = default;
};

/// Not part of a study's hash, as no text of [texts], consent and form is: one set, one log, one analysis.
struct LanguageDefinitions {
  std::vector<LanguageDefinition> languages;
  std::map<std::string, std::string> texts = {};  ///< of `every_language_text`, in place of English
  bool operator==(const LanguageDefinitions&) const = default;
};

/// Texts of the page that only studies of several languages show.
[[nodiscard]] std::span<const PageText> every_language_text();

/// A question of the form in another language; options as many as the study's, in their order.
struct FormFieldTexts {
  std::string label;
  std::vector<std::string> options = {};
};

/// What a condition says before its block, and where its own task asks in words of its own.
struct ConditionTexts {
  std::string instructions = {};
  AskedTexts own = {};
  std::vector<std::string> answers = {}, labels = {};
};

/// The words of a condition's own task, by their keys in a file of texts.
struct AskedKey {
  std::string key;
  std::string AskedTexts::*word;
};
[[nodiscard]] std::vector<AskedKey> every_asked_key();

/// What is known of a study's texts in one language; empty or none: not translated.
struct StudyTexts {
  std::string tag;
  bool is_draft = false;  ///< by a machine, and no speaker has looked at it
  std::string question = {}, rating_question = {}, font = {};
  std::vector<std::string> rating_labels = {};
  std::string consent, accept = {}, decline = {};
  std::map<std::string, FormFieldTexts> form = {};  ///< by the field's name
  std::vector<std::string> instructions = {};       ///< a text a page
  std::string feedback_right = {}, feedback_wrong = {};
  std::vector<std::string> answers = {}, labels = {};     ///< of [task]
  std::map<std::string, ConditionTexts> conditions = {};  ///< by name
  InterfaceTexts texts = {};
  std::map<std::string, std::string> page_texts = {};  ///< of [recruitment] and of several languages
};

/// The keys of texts that people would read in the study's own language, as they stand in a file of texts
/// ("consent.text", "texts.pause_text"). A consent text is asked for where the study has one of its own.
[[nodiscard]] std::vector<std::string> missing_texts(const StudyDefinition& study, const StudyTexts& texts);

/// The study as people read it in that language; what is not translated stays. Options of the form are the
/// translated ones: `answers_of_study` turns answers back.
[[nodiscard]] StudyDefinition in_language(const StudyDefinition& study, const StudyTexts& texts);

/// Answers to a form whose options were translated, with the study's own options, as logs hold them.
[[nodiscard]] std::vector<FormAnswer> answers_of_study(std::span<const FormField> own,
                                                       std::span<const FormField> translated,
                                                       std::span<const FormAnswer> answers);

/// A text of the page beyond `InterfaceTexts` (every_recruitment_text, every_language_text) of this study.
[[nodiscard]] std::map<std::string, std::string> page_texts_of(const StudyDefinition& study);

}  // namespace seamline::inline stimuli
