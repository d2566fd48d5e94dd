#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "stimuli/definition/people/language_definition.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Reads the `[[language]]` tables of a study file whose own language is `own`; none where there are none.
/// Their files are not looked at. Throws InputError as read_study does.
[[nodiscard]] std::shared_ptr<const LanguageDefinitions> read_languages(const TomlTable& study,
                                                                        const std::string& own);

/// Whether a text is a tag of BCP 47 as far as its form goes.
[[nodiscard]] bool is_language_tag(const std::string& text);

/// The files of texts and fonts that lie beside the study file: all but `builtin:` ones.
[[nodiscard]] std::vector<std::string> language_files(const StudyDefinition& study);

/// Reads the texts of one language ("seamline texts 1") from beside the study's file. A built-in file
/// translates what Seamline itself says; where the study says something else of its own it does not count.
/// Throws InputError when a file is missing or wrong: an unknown key, a place that the study's text does not
/// have, another number of options.
[[nodiscard]] StudyTexts read_study_texts(const StudyDefinition& study, const LanguageDefinition& language);

/// Of a tag that is the study's own or one of its [[language]] tables; `where` is what a complaint names.
/// None: the study's own.
[[nodiscard]] std::optional<StudyTexts> read_study_texts(const StudyDefinition& study, const std::string& tag,
                                                         const std::string& where);

/// A file of texts to translate, with what is known of the language in it; what is missing stands there in
/// the study's own words, behind a comment that says so.
[[nodiscard]] std::string texts_to_translate(const StudyDefinition& study, const StudyTexts& known);

}  // namespace seamline::inline stimuli
