#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/scores/participants.h"
#include "stimuli/definition/artifact.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// Mean noticeability (0 to 4) of a group of participants at one width. Each participant counts once: their
/// answers to one object are averaged first, then their objects.
struct CellMean {
  int width_px = 0;    ///< of the depth map
  int n = 0;           ///< participants
  double mean = 0;     ///< noticeability, 0 to 4
  double sem = 0;      ///< standard error of the mean over participants, SD with n - 1; NaN when n is 1
  double correct = 0;  ///< share of right choices
};

/// One line of the paper's Fig. 6: an object under one artifact, against width.
struct ObjectCurve {
  Artifact artifact = Artifact::none;
  std::string scene;
  std::string object;
  int object_index = 0;  ///< 1 left, 2 middle, 3 right
  std::vector<CellMean> cells;
};

/// One line of the paper's Fig. 7 together with the people behind it: what thresholds are computed from.
struct ArtifactScores {
  Artifact artifact = Artifact::none;
  std::vector<int> width_px;          ///< rising
  std::vector<std::string> people;    ///< codes, in the log's order
  Eigen::MatrixXd noticeability;      ///< people x widths, objects averaged within a person
  std::vector<CellMean> cells;        ///< over the people above
  std::vector<std::string> left_out;  ///< used participants who lack an answer at one of the widths
};

/// Everything that is averaged from a log, artifacts in the order of `every_artifact`.
struct NoticeabilityData {
  std::vector<ArtifactScores> artifacts;
  std::vector<ObjectCurve> objects;
};

/// Throws InputError when none of the participants marked `Use::used` has answered, and when an answer names
/// a participant that the log does not list.
void require_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people);

/// Averages the answers of the participants marked `Use::used`. Throws InputError as `require_answers`.
[[nodiscard]] NoticeabilityData average_answers(const study::LogContents& log,
                                                const std::vector<ParticipantUse>& people);

/// Mean, standard error and n of one value a participant. `values` must not be empty.
[[nodiscard]] CellMean mean_over_participants(const std::vector<double>& values);

}  // namespace seamline::analysis
