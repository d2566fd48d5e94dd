#pragma once
// stimuli/: the contract between all parts.
//
// A study file becomes a StudyDefinition (study_file/study_file.h), a study is a list of stimuli
// (definition/stimulus.h), and a set of their pictures has a manifest (set/manifest.h). What people would see
// of a difference: pictures/.

#include "stimuli/definition/stimulus.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/pictures/visible_difference.h"
#include "stimuli/set/manifest.h"
#include "stimuli/study_file/study_file.h"
