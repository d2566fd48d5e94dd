#pragma once
#include <vector>

#include "stimuli/definition/people/language_definition.h"

namespace seamline::study {

/// The texts of every language of a study besides its own ([[language]]), each whole. Throws InputError where
/// one lacks a text, naming the first of them.
[[nodiscard]] std::vector<StudyTexts> whole_languages(const StudyDefinition& study);

/// Throws InputError unless nothing is missing.
void check_whole(const StudyDefinition& study, const StudyTexts& texts);

}  // namespace seamline::study
