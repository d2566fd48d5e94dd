#include "stimuli/set/level_notes.h"

#include <fmt/core.h>

#include <algorithm>

namespace seamline::inline stimuli {
namespace {

constexpr double most_difference = 0.01;  ///< of the shares of two levels that count as equal

/// All levels of one scene in one condition, rising.
using HolesOfScene = std::vector<LevelHoles>;

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

std::string sentence(const HolesOfScene& levels) {
  const LevelHoles& first = levels.front();
  const std::string where = first.condition.empty() ? first.scene : first.scene + ", " + first.condition;
  const auto [least, most] =
      std::minmax_element(levels.begin(), levels.end(),
                          [](const LevelHoles& a, const LevelHoles& b) { return a.share() < b.share(); });
  if (least->holes * most->pixels == most->holes * least->pixels)
    return fmt::format("{}: holes in the depth pictures: {} at every level.", where, percent(first.share()));
  std::string out = where + ": holes in the depth pictures: ";
  for (const LevelHoles& one : levels)
    out += fmt::format("{}{} at {}", &one == &first ? "" : ", ", percent(one.share()),
                       level_text(one.quantity, one.level));
  if (most->share() - least->share() <= most_difference) return out + ".";
  return out +
         fmt::format(". The levels differ in holes: a threshold of the {} over them is one of holes too.",
                     facts(first.quantity).name);
}

}  // namespace

std::vector<std::string> notes_on_levels(const StudyDefinition& study) {
  std::vector<std::string> notes;
  if (study.level.quantity != Quantity::mesh_tolerance) return notes;
  for (const ConditionDefinition& condition : list_conditions(study)) {
    const std::optional<DepthChain>& chain = condition.depth.chain;
    if (!chain || !has_noise(*chain) || chain->noise_sigmas == 0) continue;
    notes.push_back(
        (condition.name.empty() ? std::string() : condition.name + ": ") +
        fmt::format("below {} standard deviations of the depth noise (noise_sigmas) every mesh tolerance is "
                    "the same mesh, and 0 is a full mesh that follows the noise; with noise_sigmas = 0 each "
                    "level is what it says.",
                    chain->noise_sigmas));
  }
  return notes;
}

void add_holes(std::vector<LevelHoles>& holes, const Stimulus& stimulus, const SensorCounts& counts) {
  auto found = std::find_if(holes.begin(), holes.end(), [&](const LevelHoles& one) {
    return one.scene == stimulus.scene && one.condition == stimulus.condition && one.level == stimulus.level;
  });
  if (found == holes.end())
    found = holes.insert(holes.end(), {.scene = stimulus.scene,
                                       .condition = stimulus.condition,
                                       .quantity = stimulus.quantity,
                                       .level = stimulus.level});
  found->holes += counts.holes;
  found->pixels += counts.measured + counts.holes + counts.outliers;
}

std::vector<LevelHoles> holes_of_set(const Manifest& manifest) {
  std::vector<LevelHoles> holes;
  for (const ManifestStimulus& record : manifest.stimuli)
    if (record.mesh.sensor) add_holes(holes, record.stimulus, *record.mesh.sensor);
  return holes;
}

std::vector<std::string> sentences(const std::vector<LevelHoles>& holes) {
  std::vector<HolesOfScene> scenes;
  for (const LevelHoles& one : holes) {
    if (one.pixels == 0) continue;
    auto found = std::find_if(scenes.begin(), scenes.end(), [&](const HolesOfScene& levels) {
      return levels.front().scene == one.scene && levels.front().condition == one.condition;
    });
    if (found == scenes.end()) found = scenes.insert(scenes.end(), HolesOfScene{});
    found->push_back(one);
  }
  std::vector<std::string> out;
  for (HolesOfScene& levels : scenes) {
    std::sort(levels.begin(), levels.end(),
              [](const LevelHoles& a, const LevelHoles& b) { return a.level < b.level; });
    out.push_back(sentence(levels));
  }
  return out;
}

}  // namespace seamline::inline stimuli
