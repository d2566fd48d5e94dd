#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint_thresholds.h"
#include "analysis/over_scenes/scene_curves.h"
#include "analysis/over_scenes/two_spreads.h"

namespace seamline::analysis {

/// A threshold of one artifact in one scene, of the people asked.
struct SceneThreshold {
  std::string scene;
  double x = 0;            ///< on the axis, also where its interval is open; NaN without one
  ThresholdEstimate here;  ///< interval over people
};

/// One threshold over the scenes of a curve: scenes are drawn from others like them, as people are.
struct ThresholdOverScenes {
  JointQuantity quantity = JointQuantity::perceptual;
  std::vector<SceneThreshold> scenes;
  std::string reason;  ///< why there are no numbers; empty where there are
  // All NaN or open without numbers:
  TwoSpreads spreads;
  LevelInterval these;       ///< of the mean threshold of these scenes: 95 % over people
  LevelInterval like_these;  ///< of the mean threshold of scenes like these: 95 % over people and scenes
};

/// A curve of a study with `fewest_scenes` scenes or more.
struct CurveOverScenes {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  std::vector<std::string> scenes;
  int people = 0;
  double between_people = 0;    ///< standard deviation of a person's thresholds, alike in all scenes; or NaN
  double people_by_scenes = 0;  ///< standard deviation of what a person's threshold in one scene has beside
  std::vector<ThresholdOverScenes> thresholds;  ///< in the order of `every_joint_quantity`, those asked for
};

/// The joint model of one curve, in which every scene has a threshold of its own and everything else is
/// shared by the scenes; then `two_spreads` of the scenes' thresholds. There are no numbers where
///
///   - the model has none, or the level lies in the guess floor
///   - a scene has no threshold within the levels tested or one gap beyond: leaving it out would choose
///   scenes
///     by their thresholds
///   - the interval over people and scenes leaves that range on both sides
[[nodiscard]] CurveOverScenes threshold_over_scenes(const SceneCurves& curves, int threads = 0);

}  // namespace seamline::analysis
