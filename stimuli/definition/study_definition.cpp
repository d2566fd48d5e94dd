#include "stimuli/definition/study_definition.h"

#include <fmt/core.h>

#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/views/look_definition.h"
#include "support/files/hash.h"

namespace seamline::inline stimuli {
namespace {

std::string session_text(const SessionDefinition& session, const ObserverDefinition& observer) {
  std::string out = fmt::format("session {} | {} | {}\n", session.question, session.rating_question,
                                session.break_every_trials);
  for (const std::string& label : session.rating_labels) out += "label " + label + "\n";
  out += fmt::format("observer {} {}\n", observer.scale_octaves, observer.people_sd_octaves);
  for (const auto& [artifact, level] : observer.midpoint)
    out += fmt::format("midpoint {} {}\n", word(artifact), level);
  for (const auto& [condition, midpoint] : observer.condition_midpoint)
    for (const auto& [artifact, level] : midpoint)
      out += fmt::format("midpoint {} {} {}\n", condition, word(artifact), level);
  // Only where they differ, so that studies that were rendered before keep their hash.
  if (observer.image_gain) out += fmt::format("image gain {}\n", *observer.image_gain);
  if (observer.direction == Direction::increasing) out += "noticeability rises\n";
  if (observer.pixels_per_degree != default_pixels_per_degree)
    out += fmt::format("pixels per degree {}\n", observer.pixels_per_degree);
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

int DepthSettings::height_px() const {
  const sensors::PinholeCamera* camera = chain ? camera_of(chain->sources.front()) : nullptr;
  return camera != nullptr ? camera->height_px : width_px / 2;
}

std::string_view word(Estimator estimator) {
  switch (estimator) {
    case Estimator::fast:
      return "fast";
    case Estimator::path:
      return "path";
  }
  return {};
}

std::vector<ConditionDefinition> list_conditions(const StudyDefinition& study) {
  if (!study.conditions.empty()) return study.conditions;
  return {{.name = "", .isolation = study.isolation, .depth = study.depth, .scenes = study.scenes}};
}

std::optional<View> panel_view(const StudyDefinition& study) {
  std::optional<View> found;
  const auto look = [&](const std::vector<SceneDefinition>& scenes) {
    for (const SceneDefinition& scene : scenes) {
      const View& view = scene.view;
      if (view.is_mono() || !view.names_panel()) continue;
      if (!found || view.kind == ViewKind::interleaved) found = view;
    }
  };
  if (study.conditions.empty()) look(study.scenes);
  for (const ConditionDefinition& condition : study.conditions) look(condition.scenes);
  return found;
}

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
  return out + session_text(study.session, study.observer) + canonical_text(study.procedure) +
         shown_text(study) + varied_text(study) + canonical_text(study.task.get());
}

int objects_of(const StudyDefinition& study) {
  return facts_of(study.task.get()).objects;
}

std::string study_hash(const StudyDefinition& study) {
  return sha256(canonical_text(study));
}

}  // namespace seamline::inline stimuli
