#include "stimuli/study_file/study_file_pipeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>

#include "stimuli/study_file/study_file_words.h"

namespace seamline::inline stimuli {
namespace {

void refuse_beside(const TomlTable& table, const char* key, bool is_used, const char* wanted) {
  if (table.has(key) && !is_used) throw table.complaint(key, wanted, "none");
}

bool is_power_of_two(int number) {
  return number > 0 && (number & (number - 1)) == 0;
}

void read_shadows(const TomlTable& table, Pipeline& out) {
  out.shadows = one_of<PipelineShadows>(table, "shadows", out.shadows,
                                        {{"traced", PipelineShadows::traced},
                                         {"shadow_map", PipelineShadows::shadow_map},
                                         {"occlusion_field", PipelineShadows::occlusion_field}});
  const bool maps = out.shadows == PipelineShadows::shadow_map;
  for (const char* key : {"shadow_filter", "shadow_map_px", "shadow_bias_texels"})
    refuse_beside(table, key, maps, "shadows = \"shadow_map\" beside it");
  out.shadow_filter = one_of<ShadowFilter>(
      table, "shadow_filter", out.shadow_filter,
      {{"none", ShadowFilter::none}, {"pcf", ShadowFilter::pcf}, {"pcss", ShadowFilter::pcss}});
  out.shadow_map_px = table.integer("shadow_map_px", out.shadow_map_px, {8, 8192, "px"});
  out.shadow_bias_texels = table.number("shadow_bias_texels", out.shadow_bias_texels, {0, 100, "texels"});
  for (const char* key : {"field_bands", "field_shells"})
    refuse_beside(table, key, out.shadows == PipelineShadows::occlusion_field,
                  "shadows = \"occlusion_field\" beside it");
  out.field_bands = table.integer("field_bands", out.field_bands, {1, 8, "bands"});
  out.field_shells = table.integer("field_shells", out.field_shells, {1, 64, "shells"});
}

void read_lights(const TomlTable& table, Pipeline& out) {
  out.lights = one_of<PipelineLights>(
      table, "lights", out.lights,
      {{"as_given", PipelineLights::as_given}, {"median_cut", PipelineLights::median_cut}});
  refuse_beside(table, "light_count", out.lights == PipelineLights::median_cut,
                "lights = \"median_cut\" beside it");
  out.light_count = table.integer("light_count", out.light_count, {1, 1024, "lights"});
  if (!is_power_of_two(out.light_count))
    throw table.complaint("light_count", "a power of two, because median cut halves",
                          std::to_string(out.light_count));
}

void read_compositing(const TomlTable& table, Pipeline& out) {
  out.compositing = one_of<PipelineCompositing>(table, "compositing", out.compositing,
                                                {{"ratio", PipelineCompositing::ratio},
                                                 {"additive", PipelineCompositing::additive},
                                                 {"dark_layer", PipelineCompositing::dark_layer}});
  refuse_beside(table, "shadow_opacity", out.compositing == PipelineCompositing::dark_layer,
                "compositing = \"dark_layer\" beside it");
  out.shadow_opacity = table.number("shadow_opacity", out.shadow_opacity, {0, 1});
}

/// What has no meaning has its default, so that equal means the same.
Pipeline meaningful(Pipeline pipeline) {
  const Pipeline usual;
  if (pipeline.shadows != PipelineShadows::shadow_map) {
    pipeline.shadow_filter = usual.shadow_filter;
    pipeline.shadow_map_px = usual.shadow_map_px;
    pipeline.shadow_bias_texels = usual.shadow_bias_texels;
  }
  if (pipeline.shadows != PipelineShadows::occlusion_field) {
    pipeline.field_bands = usual.field_bands;
    pipeline.field_shells = usual.field_shells;
  }
  if (pipeline.lights != PipelineLights::median_cut) pipeline.light_count = usual.light_count;
  if (pipeline.compositing != PipelineCompositing::dark_layer) pipeline.shadow_opacity = usual.shadow_opacity;
  return pipeline;
}

/// Whether some scene of a condition has one of these artifacts, or all of its answers are the depth mesh's.
bool asks(const ConditionDefinition& condition, std::initializer_list<Artifact> artifacts) {
  if (condition.isolation == Isolation::mask) return true;
  return std::any_of(condition.scenes.begin(), condition.scenes.end(), [&](const SceneDefinition& scene) {
    return std::any_of(scene.artifacts.begin(), scene.artifacts.end(), [&](Artifact artifact) {
      return artifact == Artifact::all ||
             std::find(artifacts.begin(), artifacts.end(), artifact) != artifacts.end();
    });
  });
}

/// One condition's methods against its artifacts and other settings.
class SeenMethods {
 public:
  SeenMethods(const TomlTable& table, const ConditionDefinition& condition)
      : table_(table),
        condition_(condition),
        pipeline_(condition.depth.pipeline),
        where_(condition.name.empty() ? "the study" : "the condition " + condition.name) {}

  void check() const {
    using enum Artifact;
    if (pipeline_.occlusion != PipelineOcclusion::mesh) check_occlusion();
    if (pipeline_.shadows != PipelineShadows::traced) check_shadows();
    if (pipeline_.normals != PipelineNormals::mesh)
      require("normals", {receiver, bounce}, "receiver, bounce or all",
              "no other lights the depth mesh's surfaces");
    if (pipeline_.lights != PipelineLights::as_given)
      require("lights", {receiver, shadow, overlap}, "receiver, shadow, overlap or all",
              "no other asks the depth mesh for light");
    if (pipeline_.compositing == PipelineCompositing::additive)
      require("compositing", {receiver, overlap, bounce}, "receiver, overlap, bounce or all",
              "with any other both pictures are the truth's, and nothing is put onto another");
    if (pipeline_.compositing == PipelineCompositing::dark_layer)
      require("compositing", {receiver, overlap}, "receiver, overlap or all",
              "no other casts the object's shadow by the depth mesh");
  }

 private:
  void require(const char* key, std::initializer_list<Artifact> artifacts, const char* wanted,
               const char* because) const {
    if (!asks(condition_, artifacts))
      complain(key, fmt::format("an artifact {}, or isolation = \"mask\": {}", wanted, because), "none");
  }

  void check_occlusion() const {
    require("occlusion", {Artifact::occlusion}, "occlusion or all",
            "no other asks the depth mesh who is in front");
    if (condition_.depth.mitigation.occlusion != OcclusionMitigation::none)
      complain("occlusion", "\"mesh\" beside a mitigation of occlusion, which answers instead", "another");
    if (!condition_.depth.chain) return;
    if (tests_pixels(condition_.depth.chain->occlusion))
      complain("occlusion", "\"mesh\" beside a depth test of [depth], which answers instead", "another");
    if (pipeline_.occlusion == PipelineOcclusion::depth_test &&
        !is_in_photographs_place(*condition_.depth.chain))
      complain("occlusion",
               "\"mesh\" or \"ghosts\", or depth.registration = \"points\" or \"mesh\": a pixel's depth is "
               "compared in the photograph",
               "a sensor elsewhere and no registration");
  }

  void check_shadows() const {
    if (pipeline_.shadows == PipelineShadows::occlusion_field) {
      require("shadows", {Artifact::receiver, Artifact::shadow}, "receiver, shadow or all",
              "occlusion fields know nothing of shadows of the real on the real");
      if (pipeline_.compositing == PipelineCompositing::dark_layer)
        complain("compositing", "\"ratio\" or \"additive\" beside occlusion fields, whose shadow is a factor",
                 "\"dark_layer\"");
    } else {
      require("shadows", {Artifact::receiver, Artifact::shadow, Artifact::overlap},
              "receiver, shadow, overlap or all", "no other asks the depth mesh where light of suns arrives");
    }
    if (condition_.depth.mitigation.shadow != ShadowMitigation::none)
      complain("shadows", "\"traced\" beside a mitigation of shadow, which answers instead", "another");
    for (const SceneDefinition& scene : condition_.scenes)
      if (scene.ambient_occlusion && pipeline_.shadows == PipelineShadows::shadow_map &&
          pipeline_.lights == PipelineLights::as_given)
        complain("shadows", "a sun or a lamp in every scene",
                 "ambient_occlusion in the scene \"" + scene.name + "\"");
  }

  [[noreturn]] void complain(const char* key, const std::string& wanted, const std::string& found) const {
    throw table_.complaint(std::string("pipeline.") + key, wanted, found + " in " + where_);
  }

  const TomlTable& table_;
  const ConditionDefinition& condition_;
  const Pipeline& pipeline_;
  std::string where_;
};

bool uses(const Pipeline& pipeline, Quantity level) {
  switch (level) {
    case Quantity::shadow_map_px:
    case Quantity::shadow_bias_texels:
      return pipeline.shadows == PipelineShadows::shadow_map;
    case Quantity::light_count:
      return pipeline.lights == PipelineLights::median_cut;
    case Quantity::field_bands:
    case Quantity::field_shells:
      return pipeline.shadows == PipelineShadows::occlusion_field;
    case Quantity::depth_width_px:
    case Quantity::texels_per_degree:
    case Quantity::mesh_tolerance:
    case Quantity::sun_radius_deg:
    case Quantity::depth_noise:
    case Quantity::outlier_share:
    case Quantity::calibration_error_deg:
    case Quantity::calibration_error_m:
    case Quantity::depth_field_of_view_deg:
    case Quantity::depth_delay_ms:
      return true;
  }
  return true;
}

std::string_view method_of(Quantity level) {
  if (level == Quantity::light_count) return "pipeline.lights = \"median_cut\"";
  if (level == Quantity::field_bands || level == Quantity::field_shells)
    return "pipeline.shadows = \"occlusion_field\"";
  return "pipeline.shadows = \"shadow_map\"";
}

}  // namespace

Pipeline read_pipeline(const TomlTable& settings, const LevelDefinition& level, const Pipeline& usual) {
  const std::optional<TomlTable> table = settings.table("pipeline");
  if (!table) return usual;
  const std::string_view key = facts(level.quantity).key;
  for (const char* level_key :
       {"shadow_map_px", "shadow_bias_texels", "light_count", "field_bands", "field_shells"})
    if (key == level_key && table->has(level_key))
      throw table->complaint(level_key, fmt::format("nothing, because {} is the level", key),
                             "a setting of its own");
  Pipeline out = usual;
  out.occlusion = one_of<PipelineOcclusion>(*table, "occlusion", out.occlusion,
                                            {{"mesh", PipelineOcclusion::mesh},
                                             {"depth_test", PipelineOcclusion::depth_test},
                                             {"ghosts", PipelineOcclusion::ghosts}});
  read_shadows(*table, out);
  out.normals = one_of<PipelineNormals>(*table, "normals", out.normals,
                                        {{"mesh", PipelineNormals::mesh},
                                         {"truth", PipelineNormals::truth},
                                         {"cross_products", PipelineNormals::cross_products},
                                         {"triangle_mean", PipelineNormals::triangle_mean}});
  read_lights(*table, out);
  read_compositing(*table, out);
  table->finish();
  return meaningful(out);
}

void check_pipelines_are_seen(const TomlTable& study_table, const StudyDefinition& study) {
  for (const ConditionDefinition& condition : list_conditions(study)) {
    SeenMethods(study_table, condition).check();
    if (!uses(condition.depth.pipeline, study.level.quantity))
      throw study_table.complaint(
          "level.quantity",
          std::string(method_of(study.level.quantity)) + " in the study and every condition",
          condition.name.empty() ? "another" : "another in the condition " + condition.name);
  }
}

}  // namespace seamline::inline stimuli
