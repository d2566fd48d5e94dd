#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint_data.h"
#include "analysis/scores/cells.h"
#include "analysis/scores/guess_trials.h"
#include "analysis/scores/participants.h"
#include "analysis/thresholds/guess_model.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// With fewer scenes of an artifact nothing is said of others.
inline constexpr int fewest_scenes = 3;

/// An artifact in a condition, taken apart by its scenes: a curve each in `data`.
struct SceneCurves {
  Artifact artifact = Artifact::none;
  std::string condition;            ///< empty where the study has one
  std::vector<std::string> scenes;  ///< in the order of the log's objects, as the curves of `data`
  JointData data;
};

/// The scenes of a curve of the averages, in their order there.
[[nodiscard]] std::vector<std::string> scenes_of(const NoticeabilityData& averages, Artifact artifact,
                                                 const std::string& condition);

/// Whether some curve has `fewest_scenes` scenes.
[[nodiscard]] bool has_random_scenes(const NoticeabilityData& averages);

/// The curves of `averages` with `fewest_scenes` scenes or more, in their order. `log`, `people` and
/// `references` are those of the averages.
[[nodiscard]] std::vector<SceneCurves> curves_by_scene(const study::LogContents& log,
                                                       const std::vector<ParticipantUse>& people,
                                                       const NoticeabilityData& averages,
                                                       const Guessers& guessers,
                                                       const std::vector<ReferenceAnswer>& references);

}  // namespace seamline::analysis
