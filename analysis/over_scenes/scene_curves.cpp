#include "analysis/over_scenes/scene_curves.h"

#include <algorithm>
#include <utility>

namespace seamline::analysis {

namespace {

/// A log of one curve's answers, in which each scene is a condition.
study::LogContents with_scenes_as_conditions(const study::LogContents& log, const ArtifactScores& curve) {
  study::LogContents part;
  part.file = log.file;
  part.quantity = log.quantity;
  part.noticeability = log.noticeability;
  part.participants = log.participants;
  part.task = log.task;
  for (const study::Answer& answer : log.answers)
    if (answer.artifact == curve.artifact && answer.condition == curve.condition) {
      part.answers.push_back(answer);
      part.answers.back().condition = answer.scene;
    }
  return part;
}

}  // namespace

std::vector<std::string> scenes_of(const NoticeabilityData& averages, Artifact artifact,
                                   const std::string& condition) {
  std::vector<std::string> scenes;
  for (const ObjectCurve& object : averages.objects)
    if (object.artifact == artifact && object.condition == condition &&
        std::find(scenes.begin(), scenes.end(), object.scene) == scenes.end())
      scenes.push_back(object.scene);
  return scenes;
}

bool has_random_scenes(const NoticeabilityData& averages) {
  return std::any_of(averages.artifacts.begin(), averages.artifacts.end(), [&](const ArtifactScores& curve) {
    return std::ssize(scenes_of(averages, curve.artifact, curve.condition)) >= fewest_scenes;
  });
}

std::vector<SceneCurves> curves_by_scene(const study::LogContents& log,
                                         const std::vector<ParticipantUse>& people,
                                         const NoticeabilityData& averages, const Guessers& guessers,
                                         const std::vector<ReferenceAnswer>& references) {
  std::vector<SceneCurves> curves;
  for (const ArtifactScores& curve : averages.artifacts) {
    std::vector<std::string> scenes = scenes_of(averages, curve.artifact, curve.condition);
    if (std::ssize(scenes) < fewest_scenes) continue;
    const study::LogContents part = with_scenes_as_conditions(log, curve);
    const NoticeabilityData by_scene = average_answers(part, people, scenes);
    JointData data = joint_data(count_guess_trials(part, by_scene, references), averages.axis, guessers);
    data.curves = scenes;
    curves.push_back({.artifact = curve.artifact,
                      .condition = curve.condition,
                      .scenes = std::move(scenes),
                      .data = std::move(data)});
  }
  return curves;
}

}  // namespace seamline::analysis
