#include "stimuli/study_file/parts/study_file_look.h"

#include <fmt/core.h>

#include <algorithm>

#include "stimuli/settings/look_settings.h"
#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {
namespace {

constexpr const char* head_hint =
    "Turn your head to look round. Put the cross on an object and pull the trigger.";
constexpr const char* zoom_hint =
    "Drag, or press arrow keys, to look round; press + and - to see nearer and wider. Click an object, or put "
    "the cross on it and press Enter.";
constexpr int tile_px = 32;  // of the renderer: whole ones fit around a panorama

void read_comfort_labels(const TomlTable& table, LookDefinition& look) {
  if (!table.has("comfort_labels")) return;
  const std::vector<std::string> labels = table.texts("comfort_labels");
  if (look.comfort_question.empty())
    throw table.complaint("comfort_labels", "comfort_question beside it", "the labels alone");
  if (labels.size() != look.comfort_labels.size())
    throw table.complaint("comfort_labels", "five texts, from none to the most",
                          fmt::format("{}", labels.size()));
  std::copy(labels.begin(), labels.end(), look.comfort_labels.begin());
}

void check_start(const TomlTable& table, const LookDefinition& look) {
  if (!look.start_deg || !table.has("start_deg")) return;
  const auto& [yaw, pitch] = *look.start_deg;
  if (yaw < look.yaw_deg[0] || yaw > look.yaw_deg[1] || pitch < look.pitch_deg[0] ||
      pitch > look.pitch_deg[1])
    throw table.complaint("start_deg", "a direction within yaw_deg and pitch_deg",
                          fmt::format("[{}, {}]", yaw, pitch));
}

void check_fields(const TomlTable& table, const LookDefinition& look) {
  if (!look.fov_limits_deg) return;
  const auto& [least, most] = *look.fov_limits_deg;
  if (!(least <= look.horizontal_fov_deg && look.horizontal_fov_deg <= most))
    throw table.complaint("fov_limits_deg", "two angles with horizontal_fov_deg between them",
                          fmt::format("[{}, {}] around {}", least, most, look.horizontal_fov_deg));
}

/// What one condition has beside panoramas that only one perspective view can have.
void refuse_views_own(const TomlTable& table, const ConditionDefinition& condition) {
  const auto refuse = [&](const char* key, const std::string& found) {
    throw table.complaint(key,
                          "nothing that is bound to one perspective view, because [scene.camera] has "
                          "projection = \"panorama\"",
                          found + (condition.name.empty() ? "" : " in the condition " + condition.name));
  };
  const DepthSettings& depth = condition.depth;
  for (const SceneDefinition& scene : condition.scenes)
    if (!scene.view.is_mono() && scene.view.kind != ViewKind::omnidirectional)
      refuse("view.kind", "\"" + std::string(word(scene.view.kind)) + "\"");
  if (depth.albedo == MeshAlbedo::photograph) refuse("mesh_albedo", "\"photograph\"");
  if (depth.mitigation.occlusion != Occlusion::mesh)
    refuse("mitigation.occlusion", "\"" + std::string(word(depth.mitigation.occlusion)) + "\"");
  if (depth.mitigation.shadow != ShadowMitigation::none)
    refuse("mitigation.shadow", "\"" + std::string(word(depth.mitigation.shadow)) + "\"");
  if (depth.pipeline != Pipeline{}) refuse("pipeline", canonical_text(depth.pipeline));
  if (!depth.chain) return;
  if (!stimuli::is_panorama(*depth.chain))
    refuse("depth.source", "\"" + std::string(kind_of(depth.chain->sources.front())) + "\"");
  if (tests_pixels(depth.chain->occlusion)) refuse("depth.occlusion", "a depth test");
  if (guided_by_photograph(*depth.chain)) refuse("depth.repair", "a repair guided by the photograph");
}

/// Two eyes see two panoramas in a headset only.
void check_eyes(const TomlTable& table, const StudyDefinition& study) {
  for (const ConditionDefinition& condition : list_conditions(study)) {
    const LookDefinition* look = look_of(study, condition);
    for (const SceneDefinition& scene : condition.scenes)
      if (scene.view.kind == ViewKind::omnidirectional && (look == nullptr || look->kind != LookKind::head))
        throw table.complaint(
            "view.kind",
            "look.kind = \"head\" beside \"omnidirectional\", because only a headset shows each eye its own "
            "panorama",
            (look == nullptr ? std::string("no [look]")
                             : "look.kind = \"" + std::string(word(look->kind)) + "\"") +
                (condition.name.empty() ? "" : " in the condition " + condition.name));
  }
}

void check_panoramas(const TomlTable& table, const StudyDefinition& study) {
  for (const SceneDefinition& scene : study.scenes)
    if (!is_panorama(scene))
      throw table.complaint("scene.camera.projection", "panoramas in all scenes, or in none",
                            "none in the scene \"" + scene.name + "\"");
  if (study.width_px != 2 * study.height_px || study.width_px % (2 * tile_px) != 0)
    throw table.complaint("width_px",
                          fmt::format("twice height_px and a multiple of {}, because [scene.camera] has "
                                      "projection = \"panorama\"",
                                      2 * tile_px),
                          fmt::format("{} x {}", study.width_px, study.height_px));
  for (const ConditionDefinition& condition : list_conditions(study)) {
    refuse_views_own(table, condition);
    if (look_of(study, condition) == nullptr)
      throw table.complaint(
          "look",
          "a table [look] with kind = \"mouse\" or \"fixed\" or \"head\": how people look at "
          "panoramas",
          "none" + (condition.name.empty() ? "" : " in the condition " + condition.name));
  }
}

}  // namespace

std::shared_ptr<const LookDefinition> read_look(const TomlTable& settings,
                                                const std::shared_ptr<const LookDefinition>& usual) {
  const std::optional<TomlTable> table = settings.table("look");
  if (!table) return usual;
  auto look = usual ? std::make_shared<LookDefinition>(*usual) : std::make_shared<LookDefinition>();
  read_setting(*table, "kind", *look);
  // What was said for the mouse says nothing to a head.
  const bool other_kind = usual && usual->kind != look->kind;
  if (look->kind == LookKind::head && (!usual || other_kind)) look->hint = head_hint;
  if (look->kind == LookKind::mouse && other_kind) look->hint = LookDefinition{}.hint;
  read_settings(*table, *look);
  if (look->fov_limits_deg && look->hint == LookDefinition{}.hint) look->hint = zoom_hint;
  read_comfort_labels(*table, *look);
  check_start(*table, *look);
  check_fields(*table, *look);
  table->finish();
  const std::string hint = look->hint;  // a fixed view keeps the study's, which it does not show
  drop_idle(*look);
  look->hint = hint;
  return look;
}

void check_looks(const TomlTable& study_table, const StudyDefinition& study) {
  const auto has_panorama = [](const SceneDefinition& scene) { return is_panorama(scene); };
  const bool panoramas = std::any_of(study.scenes.begin(), study.scenes.end(), has_panorama);
  if (panoramas && study.languages && comfort_asked(study) != nullptr)
    throw study_table.complaint("look.comfort_question", "a study in one language, because it has one text",
                                "a table [[language]]");
  check_eyes(study_table, study);
  if (panoramas) return check_panoramas(study_table, study);
  for (const ConditionDefinition& condition : list_conditions(study))
    if (look_of(study, condition) != nullptr)
      throw study_table.complaint(
          "look",
          "[scene.camera] with projection = \"panorama\" in every scene, which has something to look "
          "round at",
          "perspective pictures" + (condition.name.empty() ? "" : " in the condition " + condition.name));
}

}  // namespace seamline::inline stimuli
