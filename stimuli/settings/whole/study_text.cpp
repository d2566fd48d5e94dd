#include <fmt/core.h>

#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/views/look_definition.h"
#include "stimuli/settings/people/observer_settings.h"
#include "support/files/hash.h"

// The meaning of a whole study as text: rows in their wording, and what is no row between them.
namespace seamline::inline stimuli {
namespace {

std::string session_text(const SessionDefinition& session) {
  std::string out = fmt::format("session {} | {} | {}\n", session.question, session.rating_question,
                                session.break_every_trials);
  for (const std::string& label : session.rating_labels) out += "label " + label + "\n";
  return out;
}

/// What else decides what people are shown, only where it differs from what it was before it could be said.
/// Texts, form, consent and what becomes of those who come again are not part of it: they can be edited in a
/// rendered set.
std::string shown_text(const StudyDefinition& study) {
  const SessionDefinition usual;
  std::string out;
  if (study.catches != CatchDefinition{})
    out += fmt::format("catch attention {} reference {}\n", study.catches.attention, study.catches.reference);
  if (study.training.trials != TrainingDefinition{}.trials || !study.training.stimuli.empty())
    out += fmt::format("training {}\n", study.training.trials);
  for (const std::string& id : study.training.stimuli) out += "training stimulus " + id + "\n";
  if (study.session.minimum_viewing_s != usual.minimum_viewing_s)
    out += fmt::format("minimum viewing {}\n", study.session.minimum_viewing_s);
  if (study.session.inter_trial_s != usual.inter_trial_s)
    out += fmt::format("inter-trial {}\n", study.session.inter_trial_s);
  if (study.session.orders != usual.orders) out += fmt::format("orders {}\n", study.session.orders);
  return out;
}

/// What is said of the depth mesh beside its width, and only where it is not the paper's.
std::string chain_line(const DepthSettings& depth) {
  std::string out = depth.chain ? "depth " + canonical_text(depth.chain) + "\n" : std::string();
  if (depth.albedo != MeshAlbedo::constant) out += fmt::format("mesh albedo {}\n", word(depth.albedo));
  if (depth.mitigation != Mitigation{}) out += "mitigation " + canonical_text(depth.mitigation) + "\n";
  if (depth.pipeline != Pipeline{}) out += "pipeline " + canonical_text(depth.pipeline) + "\n";
  return out;
}

/// Levels that are no widths, and conditions; nothing for studies without, which keep their hash.
std::string varied_text(const StudyDefinition& study) {
  std::string out;
  if (study.level.quantity != Quantity::depth_width_px && study.depth.width_px != 0)
    out += fmt::format("depth width {}\n", study.depth.width_px);
  if (study.level.axis() == Axis::linear)
    out += fmt::format("observer on the level's axis {} {}\n", study.observer.scale_linear,
                       study.observer.people_sd_linear);
  if (study.level.noticeability != facts(study.level.quantity).noticeability)
    out += fmt::format("level {}\n", noticeability_word(study.level.noticeability));
  if (study.clip) out += canonical_text(*study.clip);
  out += chain_line(study.depth);
  if (study.look) out += "look " + canonical_text(*study.look) + "\n";
  for (const ConditionDefinition& condition : study.conditions) {
    out += fmt::format("condition {} {} {} {} {} {}\n", condition.name, word(condition.isolation),
                       condition.depth.width_px, condition.depth.yaw_texels, word(condition.depth.mesh),
                       condition.depth.mesh_tolerance) +
           chain_line(condition.depth);
    if (condition.look && condition.look != study.look)
      out += "look " + canonical_text(*condition.look) + "\n";
    if (condition.task) out += "own " + canonical_text(condition.task.get());
    for (const SceneDefinition& scene : condition.scenes) out += canonical_text(scene);
  }
  return out;
}

}  // namespace

std::string canonical_text(const StudyDefinition& study) {
  std::string out =
      fmt::format("seamline study 1\nname {}\nisolation {}\nimage {} {} spp {} seed {} mesh {} {} yaw {}\n",
                  study.name, word(study.isolation), study.width_px, study.height_px, study.samples_per_pixel,
                  study.seed, word(study.depth.mesh), study.depth.mesh_tolerance, study.depth.yaw_texels);
  for (const double value : study.level.values)
    out += fmt::format("{} {}\n", facts(study.level.quantity).key, value);
  for (const SceneDefinition& scene : study.scenes) {
    out += canonical_text(scene);
    for (const Artifact artifact : scene.artifacts) out += fmt::format("artifact {}\n", word(artifact));
  }
  return out + session_text(study.session) + settings_text(study.observer) + canonical_text(study.procedure) +
         shown_text(study) + varied_text(study) + canonical_text(study.task.get());
}

std::string study_hash(const StudyDefinition& study) {
  return sha256(canonical_text(study));
}

}  // namespace seamline::inline stimuli
