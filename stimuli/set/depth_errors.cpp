#include "stimuli/set/depth_errors.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace seamline::inline stimuli {
namespace {

DepthErrorRecord between(const DepthErrorRecord& a, const DepthErrorRecord& b, double share_of_b) {
  return {.compared = std::min(a.compared, b.compared),
          .abs_rel = std::lerp(a.abs_rel, b.abs_rel, share_of_b),
          .rmse_m = std::lerp(a.rmse_m, b.rmse_m, share_of_b),
          .within_quarter = std::lerp(a.within_quarter, b.within_quarter, share_of_b)};
}

/// The mean of as many as `count` and one more.
DepthErrorRecord with_one_more(const DepthErrorRecord& mean, int count, const DepthErrorRecord& one) {
  DepthErrorRecord out = between(mean, one, 1.0 / (count + 1));
  out.compared = mean.compared + one.compared;
  return out;
}

}  // namespace

std::vector<LevelDepthError> depth_errors_of_set(const Manifest& manifest) {
  std::vector<LevelDepthError> errors;
  for (const ManifestStimulus& record : manifest.stimuli) {
    if (!record.mesh.depth_error) continue;
    const Stimulus& stimulus = record.stimulus;
    auto found = std::find_if(errors.begin(), errors.end(), [&](const LevelDepthError& one) {
      return one.scene == stimulus.scene && one.condition == stimulus.condition &&
             one.level == stimulus.level;
    });
    if (found == errors.end())
      found = errors.insert(errors.end(), {.scene = stimulus.scene,
                                           .condition = stimulus.condition,
                                           .quantity = stimulus.quantity,
                                           .level = stimulus.level,
                                           .error = {}});
    found->error = with_one_more(found->error, found->stimuli++, *record.mesh.depth_error);
  }
  return errors;
}

std::string depth_error_text(const DepthErrorRecord& error) {
  return fmt::format("AbsRel {:.3g}, RMSE {:.3g} m, delta < 1.25 {:.1f} %", error.abs_rel, error.rmse_m,
                     100 * error.within_quarter);
}

std::vector<std::string> sentences(const std::vector<LevelDepthError>& errors) {
  std::map<std::pair<std::string, std::string>, std::vector<const LevelDepthError*>> scenes;
  for (const LevelDepthError& one : errors) scenes[{one.scene, one.condition}].push_back(&one);
  std::vector<std::string> out;
  for (auto& [where, levels] : scenes) {
    std::sort(levels.begin(), levels.end(),
              [](const LevelDepthError* a, const LevelDepthError* b) { return a->level < b->level; });
    std::string text = where.second.empty() ? where.first : where.first + ", " + where.second;
    text += ": depth against the truth: ";
    for (const LevelDepthError* one : levels)
      text += fmt::format("{}{} at {}", one == levels.front() ? "" : "; ", depth_error_text(one->error),
                          level_text(one->quantity, one->level));
    out.push_back(text + ".");
  }
  return out;
}

std::optional<DepthErrorRecord> depth_error_at(const std::vector<LevelDepthError>& errors,
                                               const std::string& condition, double level) {
  std::map<double, std::pair<DepthErrorRecord, int>> means;  // by level
  for (const LevelDepthError& one : errors) {
    if (one.condition != condition || one.quantity != Quantity::estimate_share) continue;
    auto& [mean, count] = means[one.level];
    mean = with_one_more(mean, count++, one.error);
  }
  if (means.empty() || level < 0) return std::nullopt;
  const auto above = means.lower_bound(level);
  if (above == means.end()) return std::nullopt;
  const DepthErrorRecord exact{.compared = above->second.first.compared, .within_quarter = 1};
  const bool is_first = above == means.begin();
  const double below_level = is_first ? 0 : std::prev(above)->first;
  const DepthErrorRecord& below = is_first ? exact : std::prev(above)->second.first;
  const double share = above->first == below_level ? 1 : (level - below_level) / (above->first - below_level);
  return between(below, above->second.first, share);
}

}  // namespace seamline::inline stimuli
