#pragma once
#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "analysis/scores/level_axis.h"
#include "analysis/scores/participants.h"
#include "stimuli/definition/artifact.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// Mean noticeability (0 to 4) of a group of participants at one level. Each participant counts once: their
/// answers to one object are averaged first, then their objects.
struct CellMean {
  double level = 0;    ///< of the log's quantity, 0 also where it stands apart
  int n = 0;           ///< participants
  double mean = 0;     ///< noticeability, 0 to 4
  double sem = 0;      ///< standard error of the mean over participants, SD with n - 1; NaN when n is 1
  double correct = 0;  ///< share of right choices
};

/// One line of the paper's Fig. 6: an object under one artifact, against the level.
struct ObjectCurve {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  std::string scene;
  std::string object;
  int object_index = 0;  ///< from the left, from 1
  std::vector<CellMean> cells;
};

/// One line of the paper's Fig. 7 together with the people behind it: what thresholds are computed from.
struct ArtifactScores {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  LevelAxis axis;
  std::vector<double> level;        ///< in the order of `comes_before`: widths rise
  std::vector<std::string> people;  ///< codes of who has an answer at a level at least, in the log's order
  /// People x levels, objects averaged within a person; NaN where a person has no answer.
  Eigen::MatrixXd noticeability;
  std::vector<CellMean> cells;          ///< each over the people who answered at its level
  std::vector<std::string> incomplete;  ///< of the people, who lack an answer at one of the levels
};

/// Participants at the level where the fewest answered, and at the one where the most did; (0, 0) without
/// cells.
[[nodiscard]] std::pair<int, int> people_at_levels(const ArtifactScores& scores);

/// Everything that is averaged from a log: artifacts in the order of `every_artifact`, conditions of each in
/// the order of `conditions`.
struct NoticeabilityData {
  LevelAxis axis;
  std::vector<std::string> conditions = {};  ///< seen in the answers; one empty name where the study has one
  std::vector<ArtifactScores> artifacts;
  std::vector<ObjectCurve> objects;
};

/// Throws InputError when none of the participants marked `Use::used` has answered, and when an answer names
/// a participant that the log does not list.
void require_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people);

/// " (soft)" behind the name of an artifact; nothing where the study has one condition.
[[nodiscard]] std::string in_condition(const std::string& condition);

/// Whether a study tells conditions apart, so that results name them.
[[nodiscard]] bool has_conditions(const NoticeabilityData& data);

/// The conditions of a log's answers: those of `order` first, in its order, then others as they appear.
[[nodiscard]] std::vector<std::string> conditions_of(const study::LogContents& log,
                                                     const std::vector<std::string>& order);

/// Averages the answers of the participants marked `Use::used`; `order` is that of the study's conditions.
/// Throws InputError as `require_answers`.
[[nodiscard]] NoticeabilityData average_answers(const study::LogContents& log,
                                                const std::vector<ParticipantUse>& people,
                                                const std::vector<std::string>& order = {});

/// x of a curve's levels, without one that stands apart, which is the last.
[[nodiscard]] std::vector<double> levels_on_axis(const ArtifactScores& scores);
/// Their means, of the same levels.
[[nodiscard]] std::vector<double> means_on_axis(const ArtifactScores& scores);

/// Mean, standard error and n of one value a participant. `values` must not be empty.
[[nodiscard]] CellMean mean_over_participants(const std::vector<double>& values);

}  // namespace seamline::analysis
