#include "stimuli/study_file/idle_settings.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace seamline::inline stimuli {
namespace {

/// A setting of scenes, and when it has a meaning.
struct SceneSetting {
  const char* key;
  bool (*is_used)(const SceneDefinition&);
  const char* wanted;
  std::string (*found)(const SceneDefinition&);
};

constexpr std::array<SceneSetting, 3> scene_settings = {{
    {"ao_distance_m", [](const SceneDefinition& scene) { return scene.ambient_occlusion; },
     "ambient_occlusion = true beside it",
     [](const SceneDefinition&) { return std::string("no ambient_occlusion"); }},
    {"bounces", [](const SceneDefinition& scene) { return !scene.ambient_occlusion || scene.bounces == 0; },
     "0 beside ambient_occlusion, which has no bounce",
     [](const SceneDefinition& scene) { return std::to_string(scene.bounces); }},
    {"sun", [](const SceneDefinition& scene) { return !scene.ambient_occlusion; },
     "no sun beside ambient_occlusion, which has none",
     [](const SceneDefinition&) { return std::string("ambient_occlusion = true"); }},
}};

/// Of the table of a scene, as the conditions show it, or of a condition, which speaks of all scenes.
void refuse_idle_of_scenes(const TomlTable& table, std::span<const SceneDefinition> scenes) {
  for (const SceneSetting& setting : scene_settings)
    if (table.has(setting.key) && std::none_of(scenes.begin(), scenes.end(), setting.is_used))
      throw table.complaint(setting.key, setting.wanted, setting.found(scenes.front()));
}

}  // namespace

void refuse_idle_settings(const TomlTable& table, const StudyDefinition& study) {
  const std::vector<TomlTable> scenes = table.tables("scene"), conditions = table.tables("condition");
  const std::vector<ConditionDefinition> shown = list_conditions(study);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<SceneDefinition> as_shown;
    as_shown.reserve(shown.size());
    for (const ConditionDefinition& condition : shown) as_shown.push_back(condition.scenes[i]);
    refuse_idle_of_scenes(scenes[i], as_shown);
  }
  for (std::size_t i = 0; i < conditions.size(); ++i)
    refuse_idle_of_scenes(conditions[i], study.conditions[i].scenes);
  if (!table.has("mesh_tolerance")) return;
  if (std::all_of(shown.begin(), shown.end(),
                  [](const auto& condition) { return condition.depth.mesh == MeshDensity::full; }))
    throw table.complaint("mesh_tolerance", "mesh = \"adaptive\" beside it: the full mesh has no tolerance",
                          "mesh = \"full\"");
}

}  // namespace seamline::inline stimuli
