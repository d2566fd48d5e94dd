#include "stimuli/study_file/study_file_pipeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>

#include "stimuli/settings/pipeline_settings.h"
#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {
namespace {

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
    if (pipeline_.occlusion != Occlusion::mesh) check_occlusion();
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
    if (condition_.depth.mitigation.occlusion != Occlusion::mesh)
      complain("occlusion", "\"mesh\" beside a mitigation of occlusion, which answers instead", "another");
    if (!condition_.depth.chain) return;
    if (tests_pixels(condition_.depth.chain->occlusion))
      complain("occlusion", "\"mesh\" beside a depth test of [depth], which answers instead", "another");
    if (pipeline_.occlusion == Occlusion::depth_test && !is_in_photographs_place(*condition_.depth.chain))
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

}  // namespace

Pipeline read_pipeline(const TomlTable& settings, const LevelDefinition& level, const Pipeline& usual) {
  const std::optional<TomlTable> table = settings.table("pipeline");
  if (!table) return usual;
  refuse_level<Pipeline>(*table, level.quantity);
  Pipeline pipeline = usual;
  read_settings(*table, pipeline);
  table->finish();
  drop_idle(pipeline);
  return pipeline;
}

void check_pipelines_are_seen(const TomlTable& study_table, const StudyDefinition& study) {
  const Setting<Pipeline>* level = setting_of_level<Pipeline>(study.level.quantity);
  for (const ConditionDefinition& condition : list_conditions(study)) {
    SeenMethods(study_table, condition).check();
    if (level != nullptr && !is_used(*level, condition.depth.pipeline))
      throw study_table.complaint(
          "level.quantity", "pipeline." + beside_text(level->beside) + " in the study and every condition",
          condition.name.empty() ? "another" : "another in the condition " + condition.name);
  }
}

}  // namespace seamline::inline stimuli
