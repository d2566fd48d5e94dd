#include "stimuli/study_file/study_file_level.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/settings/people/observer_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/settings/scene_settings.h"
#include "stimuli/settings/study_settings.h"
#include "stimuli/study_file/parts/study_file_condition_task.h"
#include "stimuli/study_file/parts/study_file_look.h"
#include "stimuli/study_file/study_file_depth.h"
#include "stimuli/study_file/study_file_light.h"
#include "stimuli/study_file/study_file_mitigation.h"
#include "stimuli/study_file/study_file_pipeline.h"
#include "stimuli/study_file/study_file_view.h"

namespace seamline::inline stimuli {
namespace {

constexpr NumberRange width_range{2, 16384, "px"};
constexpr std::size_t most_levels = 10000, most_conditions = 100;

Quantity read_quantity(const TomlTable& table) {
  std::vector<std::string_view> keys;
  for (const Quantity quantity : every_quantity) keys.push_back(facts(quantity).key);
  return *quantity_from_key(keys[read_word(table, "quantity", keys)]);
}

/// The depth maps of such a study have whole, even widths.
void check_texels(const TomlTable& table, double texels_per_degree) {
  const double width_px = 360 * texels_per_degree;
  const double whole_px = 2 * std::round(width_px / 2);
  if (std::abs(width_px - whole_px) > 0.02)
    throw table.complaint("values",
                          "360 times a value to be an even number of texels, such as " +
                              fmt::format("{:.4f} ({:.0f} texels)", whole_px / 360, whole_px),
                          fmt::format("{} ({:.2f} texels)", texels_per_degree, width_px));
}

/// As many as a uniform map has, so that every number of them has one to be compared with.
void check_samples(const TomlTable& table, double samples) {
  const auto samples_of = [](double width_px) { return width_px * width_px / 2; };
  const double width_px = 2 * std::round(std::sqrt(2 * samples) / 2);
  if (samples_of(width_px) == samples) return;
  throw table.complaint("values",
                        fmt::format("W x W / 2 samples of an even width W, such as {} ({} x {})",
                                    samples_of(width_px), width_px, width_px / 2),
                        fmt::format("{}", samples));
}

/// What a quantity asks of its levels beyond its range; most ask nothing.
void check_level(const TomlTable& table, const char* key, Quantity quantity, double level) {
  const auto require = [&](bool fine, const char* wanted) {
    if (!fine) throw table.complaint(key, wanted, fmt::format("{}", level));
  };
  require(!facts(quantity).whole || level == std::floor(level), "whole numbers");
  if (quantity == Quantity::depth_width_px) require(std::fmod(level, 2) == 0, "even widths");
  if (quantity == Quantity::texels_per_degree) check_texels(table, level);
  if (quantity == Quantity::depth_samples) check_samples(table, level);
  if (quantity == Quantity::mesh_tolerance) require(level == 0 || level >= 1e-9, "0 or at least 1e-09");
  if (quantity == Quantity::light_count)
    require(std::exp2(std::round(std::log2(level))) == level, "powers of two, because median cut halves");
}

/// Sorts levels, and finds those that are or would be named alike.
std::vector<double> sorted_levels(const TomlTable& table, const char* key, Quantity quantity,
                                  std::vector<double> levels) {
  const bool widths = quantity == Quantity::depth_width_px;
  if (levels.size() > most_levels)
    throw table.complaint(key, fmt::format("at most {} levels", most_levels),
                          fmt::format("{}", levels.size()));
  for (const double level : levels) check_level(table, key, quantity, level);
  std::sort(levels.begin(), levels.end());
  std::map<std::string, double> named;
  for (const double level : levels) {
    const auto [before, added] = named.emplace(level_in_id(quantity, level), level);
    if (!added && before->second == level)
      throw table.complaint(key, widths ? "widths that differ" : "levels that differ",
                            widths ? "a width given twice" : fmt::format("{} twice", level));
    if (!added)
      throw table.complaint(key, fmt::format("levels that differ in {} decimals", facts(quantity).decimals),
                            fmt::format("{} and {}", before->second, level));
  }
  return levels;
}

bool width_is_level(Quantity quantity) {
  return quantity == Quantity::depth_width_px || quantity == Quantity::texels_per_degree ||
         quantity == Quantity::depth_samples;
}

int read_width(const TomlTable& table, int fallback) {
  const int width_px = table.integer("depth_width_px", fallback, width_range);
  if (width_px % 2 != 0) throw table.complaint("depth_width_px", "an even width", std::to_string(width_px));
  return width_px;
}

void refuse_level_keys(const TomlTable& table, const LevelDefinition& level) {
  if (width_is_level(level.quantity) && table.has("depth_width_px"))
    throw level_complaint(table, "depth_width_px", level.quantity);
  refuse_level<DepthSettings>(table, level.quantity);
  refuse_level<SceneDefinition>(table, level.quantity);
}

bool has_sensor(const DepthSettings& depth) {
  return depth.chain && !is_panorama(*depth.chain);
}

/// The mesh of samples that are spent unevenly is the one that they make.
void refuse_mesh_beside_budget(const TomlTable& table, const DepthSettings& depth) {
  if (!depth.chain || !is_budgeted(*depth.chain)) return;
  const auto& source = std::get<PanoramaSource>(depth.chain->sources.front());
  if (table.has("mesh_tolerance") || depth.mesh == MeshDensity::full)
    throw table.complaint(
        depth.mesh == MeshDensity::full ? "mesh" : "mesh_tolerance",
        fmt::format("nothing beside depth.reduction = \"{}\", whose mesh is made of its samples",
                    word(source.reduction)),
        "a setting of its own");
}

void read_depth_keys(const TomlTable& table, const LevelDefinition& level, DepthSettings& depth) {
  read_settings(table, depth);
  refuse_mesh_beside_budget(table, depth);
  depth.mitigation = read_mitigation(table, depth.mitigation);
  depth.pipeline = read_pipeline(table, level, depth.pipeline);
  if (has_sensor(depth)) {
    for (const char* key : {"depth_width_px", "yaw_texels"})
      if (table.has(key) && !width_is_level(level.quantity))
        throw table.complaint(key, "a panorama: a sensor has a size and a pose of its own",
                              fmt::format("depth.source = \"{}\"", kind_of(depth.chain->sources.front())));
    depth.width_px = camera_of(depth.chain->sources.front())->width_px;
    depth.yaw_texels = 0;
    return;
  }
  if (!width_is_level(level.quantity)) depth.width_px = read_width(table, depth.width_px);
  read_setting(table, "yaw_texels", depth);
  if (depth.yaw_texels != 0 && depth.chain && is_estimated(*depth.chain))
    throw table.complaint("yaw_texels", "0 beside a panorama in a file, whose grid is the file's",
                          fmt::format("{}", depth.yaw_texels));
}

ConditionDefinition read_condition(const TomlTable& table, const StudyDefinition& study,
                                   const AssetFolders& folders, AssetCheck assets, DepthClock* clock) {
  ConditionDefinition condition{
      .name = {}, .isolation = study.isolation, .depth = study.depth, .scenes = study.scenes};
  read_settings(table, condition);
  condition.look = read_look(table, study.look);
  condition.task = read_task_of_condition(table, study);
  refuse_level_keys(table, study.level);
  condition.depth.chain = read_depth_chain(table, study.depth.chain, study.level, study.seed, clock);
  if (has_sensor(study.depth) && !has_sensor(condition.depth) && !table.has("depth_width_px"))
    throw table.missing("depth_width_px", "the width of the condition's panorama");
  read_depth_keys(table, study.level, condition.depth);
  require_level_in_chain(table, condition.depth.chain,
                         width_is_level(study.level.quantity) ? 0 : condition.depth.width_px, study.level,
                         clock != nullptr);
  if (condition.depth.mesh == MeshDensity::full && table.has("mesh_tolerance"))
    throw table.complaint("mesh_tolerance", "mesh = \"adaptive\" beside it: the full mesh has no tolerance",
                          "mesh = \"full\"");
  for (SceneDefinition& scene : condition.scenes) {
    read_light(table, folders, assets, scene);
    scene.view = read_view(table, scene.view, true);
  }
  table.finish();
  return condition;
}

}  // namespace

LevelDefinition read_level(const TomlTable& study) {
  const std::optional<TomlTable> table = study.table("level");
  LevelDefinition level;
  if (!table) {
    std::vector<double> widths;
    for (const int width_px : study.integers("depth_width_px", width_range)) widths.push_back(width_px);
    level.values = sorted_levels(study, "depth_width_px", level.quantity, std::move(widths));
    return level;
  }
  level.quantity = read_quantity(*table);
  const QuantityFacts& about = facts(level.quantity);
  level.values = sorted_levels(*table, "values", level.quantity,
                               table->numbers("values", {about.least, about.most, about.unit}));
  level.noticeability = about.noticeability;
  read_settings(*table, level);
  table->finish();
  refuse_level_keys(study, level);
  return level;
}

DepthSettings read_depth(const TomlTable& study, const LevelDefinition& level, std::uint64_t seed,
                         DepthClock* clock) {
  DepthSettings depth;
  depth.chain = read_depth_chain(study, std::nullopt, level, seed, clock);
  if (!has_sensor(depth) && !width_is_level(level.quantity) && !study.has("depth_width_px"))
    throw study.missing("depth_width_px", fmt::format("the width of all depth maps, because the level is {}",
                                                      facts(level.quantity).key));
  read_depth_keys(study, level, depth);
  return depth;
}

std::vector<ConditionDefinition> read_conditions(const TomlTable& table, const StudyDefinition& study,
                                                 const AssetFolders& folders, AssetCheck assets,
                                                 ClipDefinition* clip) {
  std::vector<ConditionDefinition> conditions;
  std::set<std::string> used;
  for (const TomlTable& one : table.tables("condition")) {
    DepthClock clock = clip != nullptr ? clip->clocks.at("") : DepthClock{};
    conditions.push_back(read_condition(one, study, folders, assets, clip != nullptr ? &clock : nullptr));
    const ConditionDefinition& condition = conditions.back();
    if (!used.insert(condition.name).second)
      throw one.complaint("name", "a name that no other condition has", "\"" + condition.name + "\"");
    if (clip != nullptr) clip->clocks[condition.name] = clock;
  }
  if (conditions.size() > most_conditions)
    throw table.complaint("condition", fmt::format("at most {} conditions", most_conditions),
                          fmt::format("{}", conditions.size()));
  return conditions;
}

}  // namespace seamline::inline stimuli
