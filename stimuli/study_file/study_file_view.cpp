#include "stimuli/study_file/study_file_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "stimuli/settings/read_settings.h"
#include "stimuli/settings/view_settings.h"
#include "support/text/limits.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::array view_keys = {
    "separation_m",     "zero_parallax_m", "views",       "preset",   "pitch_subpixels", "slant_deg",
    "offset_subpixels", "matrix",          "max_depth_m", "panel_px", "parallax"};

std::array<int, 2> read_panel(const TomlTable& table, const std::array<int, 2>& usual) {
  if (!table.has("panel_px")) return usual;
  const std::vector<int> sides = table.integers("panel_px", {8, 65536, "px"});
  if (sides.size() != 2)
    throw table.complaint("panel_px", "width and height of the screen, as [1920, 1080]",
                          fmt::format("{} numbers", sides.size()));
  return {sides[0], sides[1]};
}

/// One condition's view against the picture and against its other settings.
class SoundView {
 public:
  SoundView(const TomlTable& table, const StudyDefinition& study, const ConditionDefinition& condition,
            const View& view)
      : table_(table), study_(study), condition_(condition), view_(view) {}

  void check() const {
    if (view_.is_mono()) return;
    if (view_.kind == ViewKind::depth_image && !(view_.max_depth_m > 0))
      complain("view.max_depth_m", "the depth in metres that 1 stands for", "none");
    if (uses(view_.kind, "zero_parallax_m") && !(view_.zero_parallax_m > 0))
      complain("view.zero_parallax_m", "the distance in metres at which the screen seems to be", "none");
    if (view_.kind == ViewKind::interleaved && !view_.names_panel())
      complain("view.panel_px",
               "width and height of the screen under the lens sheet: which view a sub-pixel belongs to "
               "depends on where on it the picture stands",
               "none");
    if (study_.width_px % view_.squeeze() != 0)
      complain("width_px", fmt::format("an even width for view.kind = \"{}\"", word(view_.kind)),
               std::to_string(study_.width_px));
    if (view_.names_panel() && (view_.panel_px[0] < study_.width_px || view_.panel_px[1] < study_.height_px))
      complain("view.panel_px",
               fmt::format("at least the picture's {} x {}", study_.width_px, study_.height_px),
               fmt::format("{} x {}", view_.panel_px[0], view_.panel_px[1]));
    if (view_.kind == ViewKind::omnidirectional) {
      if (view_.panoramas() * study_.height_px > limits::largest_picture_side_px)
        complain(
            "view.views",
            fmt::format("at most {} rows in all eyes' panoramas together, which stand one above the other",
                        limits::largest_picture_side_px),
            fmt::format("{} panoramas of {}", view_.panoramas(), study_.height_px));
    } else if (view_.eyes() * (study_.width_px / view_.squeeze()) > limits::largest_picture_side_px)
      complain(
          "view.views",
          fmt::format("at most {} columns in all eyes' pictures together", limits::largest_picture_side_px),
          fmt::format("{} views of {}", view_.eyes(), study_.width_px));
    check_pixels();
  }

 private:
  /// What is found in the photograph's own pixels or from its own place says nothing to another eye.
  void check_pixels() const {
    const DepthSettings& depth = condition_.depth;
    const auto refuse = [&](const char* key, const std::string& found) {
      complain(key,
               fmt::format("nothing that is bound to the photograph's own place and pixels beside "
                           "view.kind = \"{}\"",
                           word(view_.kind)),
               "\"" + found + "\"");
    };
    if (depth.albedo == MeshAlbedo::photograph) refuse("mesh_albedo", "photograph");
    if (depth.mitigation.occlusion != Occlusion::mesh)
      refuse("mitigation.occlusion", std::string(word(depth.mitigation.occlusion)));
    if (depth.mitigation.shadow != ShadowMitigation::none)
      refuse("mitigation.shadow", std::string(word(depth.mitigation.shadow)));
    if (depth.pipeline.occlusion != Occlusion::mesh)
      refuse("pipeline.occlusion", std::string(word(depth.pipeline.occlusion)));
    if (depth.pipeline.normals == PipelineNormals::cross_products)
      refuse("pipeline.normals", std::string(word(depth.pipeline.normals)));
    if (depth.chain && tests_pixels(depth.chain->occlusion)) refuse("depth.occlusion", "a depth test");
    if (depth.chain && guided_by_photograph(*depth.chain))
      refuse("depth.repair", "a repair guided by the photograph");
  }

  [[noreturn]] void complain(const char* key, const std::string& wanted, const std::string& found) const {
    throw table_.complaint(key, wanted,
                           found + (condition_.name.empty() ? "" : " in the condition " + condition_.name));
  }

  const TomlTable& table_;
  const StudyDefinition& study_;
  const ConditionDefinition& condition_;
  const View& view_;
};

}  // namespace

View read_view(const TomlTable& settings, const View& usual, bool is_condition) {
  const std::optional<TomlTable> table = settings.table("view");
  if (!table) return usual;
  View out = usual;
  read_setting(*table, "kind", out);
  if (is_condition)
    for (const char* key : view_keys)
      if (table->has(key) && !uses(out.kind, key))
        throw table->complaint(key, "kind = " + kinds_that_use(key) + " beside it",
                               fmt::format("kind = \"{}\"", word(out.kind)));
  if (table->has("preset")) {
    constexpr std::array<std::string_view, 1> presets = {"five_views"};
    static_cast<void>(read_word(*table, "preset", presets));
    out.views = 5;
    out.sheet = five_views_sheet;
  }
  read_settings(*table, out);
  read_settings(*table, out.sheet);
  out.panel_px = read_panel(*table, out.panel_px);
  table->finish();
  return out;
}

void check_views(const TomlTable& study_table, const StudyDefinition& study) {
  const std::vector<ConditionDefinition> conditions = list_conditions(study);
  for (const ConditionDefinition& condition : conditions)
    for (const SceneDefinition& scene : condition.scenes)
      SoundView(study_table, study, condition, scene.view).check();
  const std::optional<View> panel = panel_view(study);
  for (const ConditionDefinition& condition : conditions)
    for (const SceneDefinition& scene : condition.scenes)
      if (panel && !scene.view.is_mono() && scene.view.names_panel() &&
          scene.view.panel_px != panel->panel_px)
        throw study_table.complaint("view.panel_px", "one screen for all conditions",
                                    "another in the condition " + condition.name);
  const std::optional<TomlTable> table = study_table.table("view");
  if (!table) return;
  for (const char* key : view_keys) {
    const bool is_used = std::any_of(conditions.begin(), conditions.end(), [&](const auto& condition) {
      return std::any_of(condition.scenes.begin(), condition.scenes.end(),
                         [&](const SceneDefinition& scene) { return uses(scene.view.kind, key); });
    });
    if (table->has(key) && !is_used)
      throw table->complaint(key, "view.kind = " + kinds_that_use(key) + " in the study or a condition",
                             "none");
  }
}

}  // namespace seamline::inline stimuli
