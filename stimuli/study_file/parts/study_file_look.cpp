#include "stimuli/study_file/parts/study_file_look.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace seamline::inline stimuli {
namespace {

constexpr const char* head_hint =
    "Turn your head to look round. Put the cross on an object and pull the trigger.";
constexpr int tile_px = 32;  // of the renderer: whole ones fit around a panorama

LookKind read_look_kind(const TomlTable& table, LookKind usual) {
  if (!table.has("kind")) return usual;
  const std::string text = table.text("kind");
  for (const LookKind kind : {LookKind::fixed, LookKind::mouse, LookKind::head})
    if (text == word(kind)) return kind;
  throw table.complaint("kind", "\"fixed\" or \"mouse\" or \"head\"", "\"" + text + "\"");
}

std::array<double, 2> read_two(const TomlTable& table, const char* key, const char* wanted,
                               const NumberRange& range) {
  const std::vector<double> two = table.numbers(key, range);
  if (two.size() != 2) throw table.complaint(key, wanted, fmt::format("{} numbers", two.size()));
  return {two[0], two[1]};
}

std::array<double, 2> read_limits(const TomlTable& table, const char* key, const std::array<double, 2>& usual,
                                  double most_deg) {
  if (!table.has(key)) return usual;
  const std::array<double, 2> two =
      read_two(table, key, "the least and the largest angle", {-most_deg, most_deg, "degrees"});
  if (!(two[0] <= 0 && two[1] >= 0))
    throw table.complaint(key, "the least and the largest angle, with 0 between them",
                          fmt::format("[{}, {}]", two[0], two[1]));
  return two;
}

void refuse_unused(const TomlTable& table, const LookDefinition& look) {
  const auto refuse = [&](const char* key, const char* wanted) {
    if (table.has(key)) throw table.complaint(key, wanted, fmt::format("kind = \"{}\"", word(look.kind)));
  };
  if (look.kind != LookKind::mouse)
    for (const char* key : {"yaw_deg", "pitch_deg", "start_spread_deg", "follows_device"})
      refuse(key, "kind = \"mouse\" beside it");
  if (look.kind == LookKind::fixed) refuse("hint", "kind = \"mouse\" or \"head\" beside it");
  if (look.kind == LookKind::head) refuse("horizontal_fov_deg", "nothing: a headset has a field of its own");
}

void read_comfort(const TomlTable& table, LookDefinition& look) {
  look.comfort_question = table.text("comfort_question", look.comfort_question);
  if (!table.has("comfort_labels")) return;
  const std::vector<std::string> labels = table.texts("comfort_labels");
  if (look.comfort_question.empty())
    throw table.complaint("comfort_labels", "comfort_question beside it", "the labels alone");
  if (labels.size() != look.comfort_labels.size())
    throw table.complaint("comfort_labels", "five texts, from none to the most",
                          fmt::format("{}", labels.size()));
  std::copy(labels.begin(), labels.end(), look.comfort_labels.begin());
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
  look->kind = read_look_kind(*table, look->kind);
  refuse_unused(*table, *look);
  if (table->has("view_px")) {
    const std::vector<int> sides = table->integers("view_px", {64, 4096, "px"});
    if (sides.size() != 2)
      throw table->complaint("view_px", "width and height of the view, as [960, 540]",
                             fmt::format("{} numbers", sides.size()));
    look->view_px = {sides[0], sides[1]};
  }
  look->horizontal_fov_deg =
      table->number("horizontal_fov_deg", look->horizontal_fov_deg, {10, 140, "degrees"});
  look->yaw_deg = read_limits(*table, "yaw_deg", look->yaw_deg, 180);
  look->pitch_deg = read_limits(*table, "pitch_deg", look->pitch_deg, 90);
  look->follows_device = table->boolean("follows_device", look->follows_device);
  if (table->has("start_deg")) {
    look->start_deg = read_two(*table, "start_deg", "yaw and pitch, as [30, -5]", {-180, 180, "degrees"});
    const auto& [yaw, pitch] = *look->start_deg;
    if (yaw < look->yaw_deg[0] || yaw > look->yaw_deg[1] || pitch < look->pitch_deg[0] ||
        pitch > look->pitch_deg[1])
      throw table->complaint("start_deg", "a direction within yaw_deg and pitch_deg",
                             fmt::format("[{}, {}]", yaw, pitch));
  }
  look->start_spread_deg = table->number("start_spread_deg", look->start_spread_deg, {0, 180, "degrees"});
  // What was said for the mouse says nothing to a head.
  const bool other_kind = usual && usual->kind != look->kind;
  if (look->kind == LookKind::head && (!usual || other_kind)) look->hint = head_hint;
  if (look->kind == LookKind::mouse && other_kind) look->hint = LookDefinition{}.hint;
  look->hint = table->text("hint", look->hint);
  read_comfort(*table, *look);
  table->finish();
  if (look->kind != LookKind::mouse) {  // what has no meaning has its default, so that equal means the same
    look->yaw_deg = LookDefinition{}.yaw_deg;
    look->pitch_deg = LookDefinition{}.pitch_deg;
    look->start_spread_deg = 0;
    look->follows_device = false;
  }
  if (look->kind == LookKind::head) look->horizontal_fov_deg = LookDefinition{}.horizontal_fov_deg;
  return look;
}

void check_looks(const TomlTable& study_table, const StudyDefinition& study) {
  const auto has_panorama = [](const SceneDefinition& scene) { return is_panorama(scene); };
  const bool panoramas = std::any_of(study.scenes.begin(), study.scenes.end(), has_panorama);
  if (panoramas && study.task)
    throw study_table.complaint("task", "the task \"object\" in a study of panoramas, and no table [task]",
                                "a table [task]");
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
