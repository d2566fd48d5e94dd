#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "analysis/scores/participants.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// What one image showed.
struct ScoredStimulus {
  Artifact artifact = Artifact::none;
  int condition_index = 0;  ///< place of the condition in the study's order
  std::string condition;    ///< empty where the study has one
  double level = 0;
  std::string scene;
  int object_index = 0;
  std::string object;
  auto operator<=>(const ScoredStimulus&) const = default;
};

/// One answer: places in the matrix, and its noticeability.
struct ScoredAnswer {
  int person = 0, stimulus = 0;
  int score = 0;
};

/// Noticeability (0 to 4) of every participant for every stimulus: what participants are screened by and
/// opinion scores are computed from.
struct ScoreMatrix {
  std::vector<std::string> people;      ///< used participants, in the log's order
  std::vector<ScoredStimulus> stimuli;  ///< by artifact, condition, level, scene, object
  std::vector<int> cell;                ///< of each stimulus: artifact, condition and level, numbered from 0
  Eigen::MatrixXd score;                ///< people x stimuli; repeats averaged; NaN where there is no answer
  std::vector<ScoredAnswer> answers;    ///< in the log's order, repeats one by one
  double guess_rate = 1.0 / 3;          ///< how often who sees nothing is right
};

/// Scores of the participants marked `Use::used`; `order` is that of the study's conditions.
[[nodiscard]] ScoreMatrix score_matrix(const study::LogContents& log,
                                       const std::vector<ParticipantUse>& people,
                                       const std::vector<std::string>& order = {});

}  // namespace seamline::analysis
