#include "stimuli/study_file/idle_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/views/look_definition.h"

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

/// Without what its scenes do not look at.
ConditionDefinition without_idle(ConditionDefinition condition) {
  for (SceneDefinition& scene : condition.scenes) {
    const SceneDefinition usual;
    if (!scene.ambient_occlusion) {
      scene.ao_distance_m = usual.ao_distance_m;
      continue;
    }
    scene.bounces = usual.bounces;
    scene.sun = usual.sun;
    scene.suns = usual.suns;
    scene.lamps = usual.lamps;
    scene.environment = usual.environment;
  }
  return condition;
}

/// What people would be shown and asked.
std::string meaning(const ConditionDefinition& condition, const StudyDefinition& study) {
  const DepthClock clock = study.clip ? study.clip->clocks.at(condition.name) : DepthClock{};
  std::string text =
      fmt::format("{} {} {} {} {}\n", word(condition.isolation), condition.depth.width_px,
                  condition.depth.yaw_texels, word(condition.depth.mesh), condition.depth.mesh_tolerance) +
      canonical_text(condition.depth.chain) +
      fmt::format(" {} {} {}\n", word(condition.depth.albedo), canonical_text(condition.depth.mitigation),
                  canonical_text(condition.depth.pipeline));
  for (const SceneDefinition& scene : condition.scenes) text += canonical_text(scene);
  if (condition.look) text += "look " + canonical_text(*condition.look) + "\n";
  return text + meaning_of_task(condition.task ? condition.task.get() : study.task.get()) +
         fmt::format("depth clock {} {}", clock.frames_per_s, clock.delay_ms);
}

/// Two conditions of one meaning would be asked about twice.
void refuse_twins(std::span<const TomlTable> tables, const StudyDefinition& study) {
  std::map<std::string, std::string> names;  // by meaning
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string& name = study.conditions[i].name;
    const auto [twin, added] = names.emplace(meaning(without_idle(study.conditions[i]), study), name);
    if (!added)
      throw tables[i].complaint("name", "settings that no other condition has",
                                "those of \"" + twin->second + "\" under the name \"" + name + "\"");
  }
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
  refuse_twins(conditions, study);
  if (!table.has("mesh_tolerance")) return;
  if (std::all_of(shown.begin(), shown.end(),
                  [](const auto& condition) { return condition.depth.mesh == MeshDensity::full; }))
    throw table.complaint("mesh_tolerance", "mesh = \"adaptive\" beside it: the full mesh has no tolerance",
                          "mesh = \"full\"");
}

}  // namespace seamline::inline stimuli
