#include "stimuli/study_file/study_file_mitigation.h"

#include <algorithm>

#include "stimuli/settings/mitigation_settings.h"
#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {
namespace {

/// Whether some scene of a condition has an artifact in which the depth mesh answers what `alone` shows.
bool asks(const ConditionDefinition& condition, Artifact alone) {
  if (condition.isolation == Isolation::mask) return true;
  return std::any_of(condition.scenes.begin(), condition.scenes.end(), [&](const SceneDefinition& scene) {
    return std::any_of(scene.artifacts.begin(), scene.artifacts.end(),
                       [&](Artifact artifact) { return artifact == alone || artifact == Artifact::all; });
  });
}

}  // namespace

Mitigation read_mitigation(const TomlTable& settings, const Mitigation& usual) {
  const std::optional<TomlTable> table = settings.table("mitigation");
  if (!table) return usual;
  Mitigation out = usual;
  read_settings(*table, out);
  table->finish();
  drop_idle(out);
  return out;
}

void check_mitigations_are_seen(const TomlTable& study_table, const StudyDefinition& study) {
  for (const ConditionDefinition& condition : list_conditions(study)) {
    const Mitigation& one = condition.depth.mitigation;
    const std::string where = condition.name.empty() ? "the study" : "the condition " + condition.name;
    if (one.occlusion != Occlusion::mesh && !asks(condition, Artifact::occlusion))
      throw study_table.complaint("mitigation.occlusion",
                                  "an artifact occlusion or all, or isolation = \"mask\": no other asks the "
                                  "depth mesh who is in front",
                                  "none in " + where);
    if (one.shadow != ShadowMitigation::none && !asks(condition, Artifact::overlap))
      throw study_table.complaint(
          "mitigation.shadow",
          "an artifact overlap or all, or isolation = \"mask\": no other asks the depth mesh whether real "
          "surfaces are lit",
          "none in " + where);
    if (one.occlusion != Occlusion::mesh && condition.depth.chain &&
        tests_pixels(condition.depth.chain->occlusion))
      throw study_table.complaint("mitigation.occlusion", "depth.occlusion = \"mesh\" beside it",
                                  "a depth test in " + where);
    if (one.blockers == Blockers::layers && condition.depth.chain)
      throw study_table.complaint(
          "mitigation.blockers",
          "exact panoramas for \"layers\" (a depth camera has depth.jumps = \"layer\")",
          "a table [depth] in " + where);
  }
}

}  // namespace seamline::inline stimuli
