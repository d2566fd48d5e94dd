#include "stimuli/definition/looks/study_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::inline stimuli {

bool is_panorama(const CameraDefinition& camera) {
  return camera.horizontal_fov_deg == panorama_fov_deg;
}

bool is_panorama(const SceneDefinition& scene) {
  return scene.camera && is_panorama(*scene.camera);
}

bool is_panorama(const StudyDefinition& study) {
  return !study.scenes.empty() && is_panorama(study.scenes.front());
}

const LookDefinition* look_of(const StudyDefinition& study, const ConditionDefinition& condition) {
  return condition.look ? condition.look.get() : study.look.get();
}

const LookDefinition* look_of(const StudyDefinition& study, std::string_view condition) {
  const auto found = std::find_if(study.conditions.begin(), study.conditions.end(),
                                  [&](const ConditionDefinition& one) { return one.name == condition; });
  return found == study.conditions.end() ? study.look.get() : look_of(study, *found);
}

const LookDefinition* comfort_asked(const StudyDefinition& study) {
  if (!is_panorama(study)) return nullptr;
  if (study.look && !study.look->comfort_question.empty()) return study.look.get();
  for (const ConditionDefinition& condition : study.conditions)
    if (condition.look && !condition.look->comfort_question.empty()) return condition.look.get();
  return nullptr;
}

std::array<double, 2> start_deg(const LookDefinition& look, const SceneDefinition& scene) {
  if (look.start_deg || !scene.camera) return look.start_deg.value_or(std::array{0.0, 0.0});
  const Eigen::Vector3d ahead = scene.camera->look_at_m - scene.camera->position_m;
  const double pitch_deg = std::atan2(ahead.y(), std::hypot(ahead.x(), ahead.z())) * 180 / std::numbers::pi;
  return {0.0, std::clamp(pitch_deg, look.pitch_deg[0], look.pitch_deg[1])};
}

std::array<double, 2> start_deg(const LookDefinition& look, const StudyDefinition& study,
                                std::string_view scene) {
  const auto found = std::find_if(study.scenes.begin(), study.scenes.end(),
                                  [&](const SceneDefinition& one) { return one.name == scene; });
  return start_deg(look, found == study.scenes.end() ? SceneDefinition{} : *found);
}

}  // namespace seamline::inline stimuli
