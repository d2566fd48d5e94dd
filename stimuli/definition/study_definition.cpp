#include "stimuli/definition/study_definition.h"

#include "stimuli/definition/parts/task_definition.h"

namespace seamline::inline stimuli {
int DepthSettings::height_px() const {
  const sensors::PinholeCamera* camera = chain ? camera_of(chain->sources.front()) : nullptr;
  return camera != nullptr ? camera->height_px : width_px / 2;
}

std::string_view word(Estimator estimator) {
  switch (estimator) {
    case Estimator::fast:
      return "fast";
    case Estimator::path:
      return "path";
  }
  return {};
}

std::vector<ConditionDefinition> list_conditions(const StudyDefinition& study) {
  if (!study.conditions.empty()) return study.conditions;
  return {{.name = "", .isolation = study.isolation, .depth = study.depth, .scenes = study.scenes}};
}

std::optional<View> panel_view(const StudyDefinition& study) {
  std::optional<View> found;
  const auto look = [&](const std::vector<SceneDefinition>& scenes) {
    for (const SceneDefinition& scene : scenes) {
      const View& view = scene.view;
      if (view.is_mono() || !view.names_panel()) continue;
      if (!found || view.kind == ViewKind::interleaved) found = view;
    }
  };
  if (study.conditions.empty()) look(study.scenes);
  for (const ConditionDefinition& condition : study.conditions) look(condition.scenes);
  return found;
}

int objects_of(const StudyDefinition& study) {
  return facts_of(study.task.get()).objects;
}

}  // namespace seamline::inline stimuli
