#include "stimuli/study_file/study_file_mitigation.h"

#include <algorithm>

#include "stimuli/study_file/study_file_words.h"

namespace seamline::inline stimuli {
namespace {

constexpr Range mask_widths{16, 16384, "px"};

int read_even_width(const TomlTable& table, const char* key, int usual, bool is_used, const char* wanted) {
  if (!table.has(key)) return usual;
  if (!is_used) throw table.complaint(key, wanted, "none");
  const int width_px = table.integer(key, usual, mask_widths);
  if (width_px % 2 != 0) throw table.complaint(key, "an even width", std::to_string(width_px));
  return width_px;
}

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
  out.occlusion = one_of<OcclusionMitigation>(*table, "occlusion", out.occlusion,
                                              {{"none", OcclusionMitigation::none},
                                               {"mask", OcclusionMitigation::mask},
                                               {"edges", OcclusionMitigation::edges}});
  out.shadow = one_of<ShadowMitigation>(*table, "shadow", out.shadow,
                                        {{"none", ShadowMitigation::none},
                                         {"matte", ShadowMitigation::matte},
                                         {"detected", ShadowMitigation::detected}});
  out.blockers = one_of<Blockers>(*table, "blockers", out.blockers,
                                  {{"sheets", Blockers::sheets}, {"layers", Blockers::layers}});
  out.mask_width_px =
      read_even_width(*table, "mask_width_px", out.mask_width_px, out.occlusion != OcclusionMitigation::none,
                      "occlusion = \"mask\" or \"edges\" beside it");
  out.matte_width_px =
      read_even_width(*table, "matte_width_px", out.matte_width_px, out.shadow != ShadowMitigation::none,
                      "shadow = \"matte\" or \"detected\" beside it");
  table->finish();
  // What has no meaning has its default, so that equal means the same.
  if (out.occlusion == OcclusionMitigation::none) out.mask_width_px = Mitigation{}.mask_width_px;
  if (out.shadow == ShadowMitigation::none) out.matte_width_px = Mitigation{}.matte_width_px;
  return out;
}

void check_mitigations_are_seen(const TomlTable& study_table, const StudyDefinition& study) {
  for (const ConditionDefinition& condition : list_conditions(study)) {
    const Mitigation& one = condition.depth.mitigation;
    const std::string where = condition.name.empty() ? "the study" : "the condition " + condition.name;
    if (one.occlusion != OcclusionMitigation::none && !asks(condition, Artifact::occlusion))
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
    if (one.occlusion != OcclusionMitigation::none && condition.depth.chain &&
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
