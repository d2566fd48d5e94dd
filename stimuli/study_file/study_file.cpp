#include "stimuli/study_file/study_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/settings/people/observer_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/settings/study_settings.h"
#include "stimuli/study_file/carried_files.h"
#include "stimuli/study_file/idle_settings.h"
#include "stimuli/study_file/moving/study_file_clip.h"
#include "stimuli/study_file/moving/study_file_late_frames.h"
#include "stimuli/study_file/parts/study_file_condition_task.h"
#include "stimuli/study_file/parts/study_file_look.h"
#include "stimuli/study_file/parts/study_file_task.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "stimuli/study_file/study_file_depth.h"
#include "stimuli/study_file/study_file_level.h"
#include "stimuli/study_file/study_file_mitigation.h"
#include "stimuli/study_file/study_file_people.h"
#include "stimuli/study_file/study_file_pipeline.h"
#include "stimuli/study_file/study_file_procedure.h"
#include "stimuli/study_file/study_file_scene.h"
#include "stimuli/study_file/study_file_session.h"
#include "stimuli/study_file/study_file_view.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/request_name.h"

namespace seamline::inline stimuli {
namespace {

constexpr const char* study_format = "seamline study 1";

void check_format(const TomlTable& table) {
  const std::string format = table.text("format");
  if (format != study_format)
    throw table.complaint("format", std::string("\"") + study_format + "\"", "\"" + format + "\"");
}

/// Where people see half of what there is to see, for each artifact, in the level's unit.
void read_midpoints(const TomlTable& table, std::map<Artifact, double>& midpoint,
                    const LevelDefinition& level) {
  const QuantityFacts& about = facts(level.quantity);
  const NumberRange range{level.quantity == Quantity::depth_width_px ? 1e-3
                          : level.axis() == Axis::log2               ? 1e-12
                                                                     : -1e9,
                          1e9, about.unit};
  for (const Artifact artifact : every_artifact) {
    const std::string key(word(artifact));
    if (table.has(key)) midpoint[artifact] = table.number(key, 0, range);
  }
  table.finish();
}

/// Of widths as the papers have them, and of what a width means; of other levels nobody knows.
std::map<Artifact, double> usual_midpoints(const LevelDefinition& level) {
  std::map<Artifact, double> midpoint = ObserverDefinition{}.midpoint;
  if (level.quantity == Quantity::depth_width_px) return midpoint;
  if (level.quantity == Quantity::texels_per_degree) {
    for (auto& [artifact, value] : midpoint) value = value / 360;
    return midpoint;
  }
  if (level.quantity == Quantity::depth_samples) {
    for (auto& [artifact, value] : midpoint) value = value * value / 2;
    return midpoint;
  }
  return {};
}

void read_linear_scales(const TomlTable& table, const LevelDefinition& level, ObserverDefinition& observer) {
  const QuantityFacts& about = facts(level.quantity);
  const double span = level.values.back() - level.values.front();
  const double usual = span > 0 ? span / 12 : 1;  // as half an octave is of the paper's six
  const std::string unit(about.unit_key);
  observer.scale_linear = table.number("scale_" + unit, usual, {1e-9, 1e9, about.unit});
  observer.people_sd_linear = table.number("people_sd_" + unit, usual, {0, 1e9, about.unit});
}

ObserverDefinition read_observer(const TomlTable& table, const LevelDefinition& level,
                                 const std::vector<ConditionDefinition>& conditions) {
  ObserverDefinition observer;
  observer.midpoint = usual_midpoints(level);
  observer.direction = level.noticeability;
  read_settings(table, observer);
  if (level.axis() == Axis::linear) read_linear_scales(table, level, observer);
  const bool widths = level.quantity == Quantity::depth_width_px;
  if (const auto midpoints = table.table(widths ? "midpoint_width_px" : "midpoint"))
    read_midpoints(*midpoints, observer.midpoint, level);
  if (const auto by_condition = table.table("condition_midpoint")) {
    for (const ConditionDefinition& condition : conditions)
      if (const auto midpoints = by_condition->table(condition.name)) {
        observer.condition_midpoint[condition.name] = observer.midpoint;
        read_midpoints(*midpoints, observer.condition_midpoint[condition.name], level);
      }
    by_condition->finish();
  }
  table.finish();
  return observer;
}

ObserverDefinition usual_observer(const LevelDefinition& level) {
  ObserverDefinition observer;
  observer.midpoint = usual_midpoints(level);
  observer.direction = level.noticeability;
  if (level.axis() == Axis::linear && level.values.back() > level.values.front())
    observer.scale_linear = observer.people_sd_linear = (level.values.back() - level.values.front()) / 12;
  return observer;
}

/// A level that changes nothing in a scene would be asked about in vain.
void check_level_is_seen(const TomlTable& table, const StudyDefinition& study) {
  if (study.level.quantity != Quantity::sun_radius_deg) return;
  for (const ConditionDefinition& condition : list_conditions(study))
    for (const SceneDefinition& scene : condition.scenes)
      if (scene.ambient_occlusion)
        throw table.complaint("level.quantity", "a sun in every scene",
                              "ambient_occlusion in the scene \"" + scene.name + "\"");
}

/// Whether anything in these scenes looks at what the depth mesh is made of.
bool asks_for_mesh_albedo(const ConditionDefinition& condition) {
  if (condition.isolation == Isolation::mask) return true;
  return std::any_of(condition.scenes.begin(), condition.scenes.end(), [](const SceneDefinition& scene) {
    return std::any_of(scene.artifacts.begin(), scene.artifacts.end(), [](Artifact artifact) {
      return artifact == Artifact::bounce || artifact == Artifact::reflection || artifact == Artifact::all;
    });
  });
}

void check_mesh_albedo_is_seen(const TomlTable& table, const StudyDefinition& study) {
  for (const ConditionDefinition& condition : list_conditions(study))
    if (condition.depth.albedo != MeshAlbedo::constant && !asks_for_mesh_albedo(condition))
      throw table.complaint(
          "mesh_albedo",
          "an artifact bounce, reflection or all, or isolation = \"mask\": no other looks at "
          "what the depth mesh is made of",
          "\"" + std::string(word(condition.depth.albedo)) + "\"");
}

/// A set of more could be rendered, and its manifest never be read.
void require_a_set_that_can_be_read(const TomlTable& table, const StudyDefinition& study) {
  const std::size_t shown = study.level.values.size() * std::max<std::size_t>(1, study.conditions.size());
  std::size_t stimuli = 0;
  for (const SceneDefinition& scene : study.scenes)
    stimuli += scene.artifacts.size() * scene.objects.size() * shown;
  if (stimuli > static_cast<std::size_t>(limits::most_stimuli))
    throw table.complaint("scene",
                          fmt::format("at most {} stimuli (artifacts x objects x levels x conditions), or "
                                      "several studies",
                                      limits::most_stimuli),
                          fmt::format("{}", stimuli));
}

StudyDefinition read_study_table(const TomlTable& table, const AssetFolders& folders, AssetCheck check,
                                 IdleSettings idle) {
  const AssetCheck assets = check == AssetCheck::all_but_depth ? AssetCheck::must_exist : check;
  const std::filesystem::path& path = folders.study_file;
  check_format(table);
  StudyDefinition study;
  study.file = path;
  read_settings(table, study);
  study.level = read_level(table);
  std::shared_ptr<ClipDefinition> clip;
  if (const auto given = table.table("clip")) clip = std::make_shared<ClipDefinition>(read_clip(*given));
  study.depth = read_depth(table, study.level, study.seed, clip ? &clip->clocks[""] : nullptr);
  if (const auto session = table.table("session")) study.session = read_session(*session);
  study.procedure = read_procedure(table, study.level);
  if (const auto catches = table.table("catch")) study.catches = read_catches(*catches);
  read_people(table, study);
  read_task(table, study);
  std::set<std::string> names;
  const int objects = objects_of(study);
  for (const TomlTable& scene : table.tables("scene")) {
    study.scenes.push_back(read_scene(scene, folders, assets, study.level.quantity, clip.get(), objects));
    if (!names.insert(study.scenes.back().name).second)
      throw scene.complaint("name", "a name that no other scene has", "\"" + study.scenes.back().name + "\"");
  }
  study.look = read_look(table, nullptr);
  const View view = read_view(table, {}, false);
  for (SceneDefinition& scene : study.scenes) scene.view = view;
  study.conditions = read_conditions(table, study, folders, assets, clip.get());
  study.clip = clip;
  if (study.conditions.empty())
    require_level_in_chain(table, study.depth.chain, study.depth.width_px, study.level,
                           study.clip != nullptr);
  if (check == AssetCheck::must_exist) find_depth_files(study, folders);
  check_level_is_seen(table, study);
  check_mesh_albedo_is_seen(table, study);
  check_mitigations_are_seen(table, study);
  check_pipelines_are_seen(table, study);
  check_views(table, study);
  check_looks(table, study);
  check_clip(table, study);
  check_task_alone(table, study);
  set_up_own_tasks(table, study);
  if (const auto analysis = table.table("analysis")) {
    check_late_frames(*analysis, study);
    static_cast<void>(read_analysis(*analysis));
  }
  const auto observer = table.table("observer");
  study.observer =
      observer ? read_observer(*observer, study.level, study.conditions) : usual_observer(study.level);
  table.finish();
  const std::filesystem::path folder = path.parent_path();
  check_carried_files(study, assets == AssetCheck::must_exist ? &folder : nullptr);
  if (study.scenes.empty()) throw table.complaint("scene", "at least one [[scene]]", "none");
  if (assets == AssetCheck::must_exist) check_carried_texts(table, study);
  if (assets == AssetCheck::must_exist && study.languages)
    for (const LanguageDefinition& language : study.languages->languages)
      static_cast<void>(read_study_texts(study, language));
  require_a_set_that_can_be_read(table, study);
  if (idle == IdleSettings::refused) refuse_idle_settings(table, study);
  return study;
}

}  // namespace

StudyDefinition read_study(const std::filesystem::path& path, AssetCheck assets,
                           const std::filesystem::path& asset_root, IdleSettings idle) {
  std::error_code error;
  if (!asset_root.empty() && !std::filesystem::is_directory(asset_root, error))
    throw input_error({.field = request_name("asset_root"),
                       .wanted = "a folder",
                       .found = "no folder at " + asset_root.string()});
  return read_study_table(TomlTable::read(path), {.study_file = path, .asset_root = asset_root}, assets,
                          idle);
}

StudyDefinition read_study_text(const std::string& text, const std::filesystem::path& said_to_be,
                                IdleSettings idle) {
  return read_study_table(TomlTable::parse(text, said_to_be), {.study_file = said_to_be},
                          AssetCheck::not_needed, idle);
}

AnalysisDefinition read_analysis_text(const std::string& text, const std::filesystem::path& said_to_be) {
  const auto analysis = TomlTable::parse(text, said_to_be).table("analysis");
  return analysis ? read_analysis(*analysis) : AnalysisDefinition{};
}

}  // namespace seamline::inline stimuli
