#include "stimuli/definition/stimulus.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "stimuli/definition/at_level.h"
#include "stimuli/definition/clip_frames.h"
#include "stimuli/definition/methods/depth_file_names.h"

namespace seamline::inline stimuli {
namespace {

std::optional<DepthChain> chain_at(DepthChain chain, Quantity quantity, double level) {
  for (DepthSource& source : chain.sources) {
    auto* pinhole = std::get_if<PinholeSource>(&source);
    if (pinhole != nullptr && quantity == Quantity::depth_field_of_view_deg)
      pinhole->camera = with_field_of_view(pinhole->camera, level);
    if (pinhole != nullptr && quantity == Quantity::texels_per_degree)
      pinhole->camera = with_texels_per_degree(pinhole->camera, level);
  }
  set_level(chain, quantity, level);
  return meaningful(std::move(chain));
}

DepthSettings depth_in_chain_at(DepthSettings depth, Quantity quantity, double level) {
  if (depth.chain) depth.chain = chain_at(std::move(*depth.chain), quantity, level);
  if (depth.chain)
    if (const auto* camera = camera_of(depth.chain->sources.front())) depth.width_px = camera->width_px;
  return depth;
}

DepthSettings depth_at(DepthSettings depth, Quantity quantity, double level) {
  switch (quantity) {
    case Quantity::depth_width_px:
      depth.width_px = static_cast<int>(level);
      break;
    case Quantity::depth_samples:
      depth.width_px = static_cast<int>(std::lround(std::sqrt(2 * level)));
      break;
    case Quantity::texels_per_degree:
      if (depth.chain && !is_panorama(*depth.chain))
        return depth_in_chain_at(std::move(depth), quantity, level);
      depth.width_px = static_cast<int>(std::lround(level * 360));
      break;
    case Quantity::mesh_tolerance:
      depth.mesh_tolerance = level;
      if (level == 0) depth.mesh = MeshDensity::full;
      break;
    case Quantity::sun_radius_deg:
    case Quantity::object_speed_m_s:
    case Quantity::depth_frames_per_s:  // of a clip's clock
      break;
    case Quantity::shadow_map_px:
    case Quantity::shadow_bias_texels:
    case Quantity::light_count:
    case Quantity::field_bands:
    case Quantity::field_shells:
      set_level(depth.pipeline, quantity, level);
      break;
    case Quantity::depth_noise:
    case Quantity::outlier_share:
    case Quantity::calibration_error_deg:
    case Quantity::calibration_error_m:
    case Quantity::depth_field_of_view_deg:
    case Quantity::depth_delay_ms:
    case Quantity::estimate_share:
      return depth_in_chain_at(std::move(depth), quantity, level);
  }
  return depth;
}

/// Files that a stimulus names have its name.
DepthSettings with_named_files(DepthSettings depth, const std::string& scene, const std::string& object) {
  if (!depth.chain) return depth;
  const auto name = [&](auto& file) {
    file.file = depth_file_name(file.file, scene, object);
    file.path = depth_file_name(file.path.string(), scene, object);
  };
  for (DepthSource& source : depth.chain->sources) {
    if (auto* panorama = std::get_if<PanoramaSource>(&source); panorama != nullptr && panorama->file)
      name(*panorama->file);
    if (auto* file = std::get_if<FileSource>(&source)) name(*file);
  }
  return depth;
}

SceneDefinition scene_of_level(const StudyDefinition& study, const std::string& condition,
                               SceneDefinition scene, double level) {
  if (study.level.quantity == Quantity::sun_radius_deg) scene.sun_radius_deg = level;
  return is_of_frames(study) ? scene_of_frame(study, condition, std::move(scene), level) : scene;
}

/// Clips whose objects move at different speeds have different truths, though they begin alike.
std::string motion_of_level(const StudyDefinition& study, double level) {
  const bool differs = study.level.quantity == Quantity::object_speed_m_s && !is_of_frames(study);
  return differs ? fmt::format("speed {}", level) : std::string();
}

/// `-soft` of a condition; a frame's number stands without a dash.
std::string condition_in_name(const std::string& condition) {
  return condition.starts_with('@') ? condition : "-" + condition;
}

/// The truths of one scene of a study: what each condition and level is compared with, each once.
class TruthsOfScene {
 public:
  /// `conditions` are all of the study's, listed once, because each holds every scene.
  TruthsOfScene(const StudyDefinition& study, const std::vector<ConditionDefinition>& conditions,
                std::size_t scene)
      : quantity_(study.level.quantity), levels_(study.level.values) {
    const std::size_t levels = facts(quantity_).changes_truth ? levels_.size() : 1;
    for (const ConditionDefinition& condition : conditions)
      for (std::size_t level = 0; level < levels; ++level) {
        SceneDefinition truth =
            scene_of_level(study, condition.name, condition.scenes.at(scene), levels_.at(level));
        truth.truth.clear();
        const std::string meaning = canonical_text(truth) + motion_of_level(study, levels_.at(level));
        auto [found, added] = names_.emplace(meaning, std::string());
        if (added) {
          found->second = name_of(truth.name, condition.name, level, conditions.size() > 1, levels > 1);
          scenes_.push_back(truth);
          meanings_.push_back(meaning);
        }
        by_place_[{condition.name, level}] = meaning;
      }
    // One light for everything: the scene's name alone, as in studies without conditions.
    if (scenes_.size() == 1) names_.begin()->second = scenes_.front().name;
    for (std::size_t i = 0; i < scenes_.size(); ++i) scenes_[i].truth = names_.at(meanings_[i]);
  }

  [[nodiscard]] const std::vector<SceneDefinition>& scenes() const { return scenes_; }
  [[nodiscard]] const std::string& name(const std::string& condition, std::size_t level) const {
    return names_.at(by_place_.at({condition, facts(quantity_).changes_truth ? level : 0}));
  }

 private:
  [[nodiscard]] std::string name_of(const std::string& scene, const std::string& condition, std::size_t level,
                                    bool many_conditions, bool many_levels) const {
    std::string name = scene;
    if (many_conditions) name += condition_in_name(condition);
    if (many_levels) name += "-" + level_in_id(quantity_, levels_[level]);
    return name;
  }

  Quantity quantity_;
  const std::vector<double>& levels_;
  std::vector<SceneDefinition> scenes_;
  std::vector<std::string> meanings_;                                    ///< of each scene
  std::map<std::string, std::string> names_;                             ///< by meaning
  std::map<std::pair<std::string, std::size_t>, std::string> by_place_;  ///< meaning of a condition and level
};

}  // namespace

std::string stimulus_id(const Stimulus& stimulus) {
  std::string id = fmt::format("{}-{}-{}", stimulus.scene, word(stimulus.artifact), stimulus.object);
  if (!stimulus.condition.empty()) id += condition_in_name(stimulus.condition);
  id += "-" + level_in_id(stimulus.quantity, stimulus.level);
  if (stimulus.depth.yaw_texels == 0) return id;
  std::string yaw = fmt::format("{}", stimulus.depth.yaw_texels);
  std::replace(yaw.begin(), yaw.end(), '.', 'p');
  return id + "-yaw" + yaw;
}

std::vector<Stimulus> list_every_stimulus(const StudyDefinition& study) {
  const std::vector<ConditionDefinition> conditions = list_conditions(study);
  std::vector<Stimulus> stimuli;
  for (std::size_t s = 0; s < study.scenes.size(); ++s) {
    const SceneDefinition& scene = study.scenes[s];
    const TruthsOfScene truths(study, conditions, s);
    for (const Artifact artifact : scene.artifacts)
      for (std::size_t object = 0; object < scene.objects.size(); ++object)
        for (const ConditionDefinition& condition : conditions)
          for (std::size_t level = 0; level < study.level.values.size(); ++level)
            stimuli.push_back(
                {.scene = scene.name,
                 .artifact = artifact,
                 .object = scene.objects[object].name,
                 .object_index = static_cast<int>(object) + 1,
                 .condition = conditions.size() > 1 ? condition.name : std::string(),
                 .quantity = study.level.quantity,
                 .level = study.level.values[level],
                 .depth = depth_of_frame(study, condition.name,
                                         with_named_files(depth_at(condition.depth, study.level.quantity,
                                                                   study.level.values[level]),
                                                          scene.name, scene.objects[object].name),
                                         study.level.values[level]),
                 .isolation = condition.isolation,
                 .truth = truths.name(condition.name, level)});
  }
  return stimuli;
}

std::vector<Stimulus> list_stimuli(const StudyDefinition& study) {
  std::vector<Stimulus> stimuli = list_every_stimulus(study);
  return is_of_frames(study) ? without_twins(study, std::move(stimuli)) : stimuli;
}

std::vector<SceneDefinition> list_truths(const StudyDefinition& study) {
  const std::vector<ConditionDefinition> conditions = list_conditions(study);
  std::vector<SceneDefinition> truths;
  for (std::size_t s = 0; s < study.scenes.size(); ++s) {
    const TruthsOfScene of_scene(study, conditions, s);
    truths.insert(truths.end(), of_scene.scenes().begin(), of_scene.scenes().end());
  }
  return truths;
}

std::vector<int> depth_widths_px(const StudyDefinition& study) {
  std::set<int> widths;
  for (const ConditionDefinition& condition : list_conditions(study))
    for (const double level : study.level.values)
      widths.insert(depth_at(condition.depth, study.level.quantity, level).width_px);
  return {widths.begin(), widths.end()};
}

bool matches_pattern(std::string_view id, std::string_view pattern) {
  if (pattern.empty()) return true;
  std::size_t i = 0, p = 0, star = std::string_view::npos, resume = 0;
  while (i < id.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = i;
    } else if (p < pattern.size() && pattern[p] == id[i]) {
      ++p;
      ++i;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      i = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace seamline::inline stimuli
