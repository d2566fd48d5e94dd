#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"
#include "analysis/scores/level_axis.h"
#include "stimuli/definition/artifact.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// What participants say of themselves, by code: "technical", "other". May be empty.
using ParticipantGroups = std::map<std::string, std::string>;

/// One artifact of a study, in one condition, as the model sees it.
struct DesignArtifact {
  Artifact artifact = Artifact::none;
  std::string condition;             ///< empty where the study has one
  std::vector<std::string> objects;  ///< told apart by scene and place where the name alone does not
  int level_column = -1;             ///< difference from the first artifact; -1 for the first
  int slope_column = -1;             ///< along the axis of levels; -1 when one level was tested
  int first_object_column = -1;      ///< objects - 1 columns, one set an artifact; -1 with one object
};

/// The columns of the study's model. Objects are nested in artifacts, because each artifact has objects of
/// its own, and coded so that their effects sum to 0 within the artifact (the last object is minus the sum of
/// the others): an artifact's level is then the mean over its objects.
struct StudyDesign {
  OrdinalData data;  ///< scores 0 to 4
  std::vector<DesignArtifact> artifacts;
  LevelAxis axis;
  double reference_level = 0;       ///< where means are compared
  std::vector<std::string> groups;  ///< in alphabetical order; empty when there is no group column
  int first_group_column = -1;      ///< groups - 1 columns: difference from the first group
  int participants = 0;
  std::vector<std::string> notes;
};

/// `reference_level` 0 takes the geometric centre of the widths tested (512 for 64 to 4096). Throws
/// InputError when there are no answers or the reference is negative.
/// `order` is that of the study's conditions. Answers at a level that stands apart are left out, with a note.
[[nodiscard]] StudyDesign study_design(std::span<const study::Answer> answers,
                                       const ParticipantGroups& groups, double reference_level,
                                       const LevelAxis& axis = {},
                                       const std::vector<std::string>& order = {});

/// "receiver", or "receiver (soft)".
[[nodiscard]] std::string name_of(const DesignArtifact& artifact);

/// What a slope is over: "octave of width", "degree".
[[nodiscard]] std::string step_text(const LevelAxis& axis);

/// "per octave of width", "per degree".
[[nodiscard]] std::string slope_text(const LevelAxis& axis);

/// "512 px", "2.5 degrees", "a mesh tolerance of 0.01".
[[nodiscard]] std::string reference_text(const StudyDesign& design);

/// "at 512 px", "at 2.5 degrees".
[[nodiscard]] std::string at_reference(const StudyDesign& design);

}  // namespace seamline::analysis
