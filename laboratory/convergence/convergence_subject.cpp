#include "laboratory/convergence/convergence_subject.h"

#include <fmt/core.h>

#include "raytracer/common/parallel.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

Stimulus the_one_stimulus(const StudyDefinition& study, const std::string& only) {
  std::vector<Stimulus> matching;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (matches_pattern(stimulus_id(stimulus), only)) matching.push_back(stimulus);
  if (matching.size() != 1)
    throw input_error({.file = study.file.string(),
                       .field = request_name("only"),
                       .wanted = "a pattern that matches one stimulus id (render " + request_name("dry_run") +
                                 " lists them)",
                       .found = fmt::format("\"{}\", which matches {}", only, matching.size())});
  return matching.front();
}

SceneDefinition scene_of(const StudyDefinition& study, const Stimulus& stimulus) {
  for (const SceneDefinition& truth : list_truths(study))
    if (truth.truth == truth_of(stimulus)) return truth;
  throw std::logic_error("a stimulus of no scene");
}

}  // namespace

std::string_view word(ConvergencePart part) {
  switch (part) {
    case ConvergencePart::samples:
      return "samples";
    case ConvergencePart::mesh:
      return "mesh";
    case ConvergencePart::width:
      return "width";
    case ConvergencePart::compositing:
      return "compositing";
    case ConvergencePart::links:
      return "links";
    case ConvergencePart::realtime:
      return "realtime";
    case ConvergencePart::light:
      return "light";
    case ConvergencePart::mitigation:
      return "mitigation";
    case ConvergencePart::filter:
      return "filter";
    case ConvergencePart::sensor:
      return "sensor";
    case ConvergencePart::repair:
      return "repair";
    case ConvergencePart::registration:
      return "registration";
    case ConvergencePart::joint:
      return "joint";
    case ConvergencePart::plan:
      return "plan";
    case ConvergencePart::fit:
      return "fit";
    case ConvergencePart::interval:
      return "interval";
  }
  throw std::logic_error("a part that is none of these");
}

ConvergenceSubject load_subject(StudyDefinition study, const ConvergenceRequest& request) {
  study.width_px = request.width_px.value_or(study.width_px);
  study.height_px = request.height_px.value_or(study.height_px);
  if (study.clip)
    throw input_error(
        {.file = study.file.string(), .field = "clip", .wanted = "a study of stills", .found = "clips"});
  const Stimulus stimulus = the_one_stimulus(study, request.only);
  const Recipe how = recipe(stimulus.artifact, study.isolation);
  if (!how.answers.needs_depth())
    throw input_error({.file = study.file.string(),
                       .field = request_name("only"),
                       .wanted = "a stimulus that asks something of the depth mesh",
                       .found = stimulus_id(stimulus)});
  if (stimulus.depth.albedo != MeshAlbedo::constant)
    throw input_error({.file = study.file.string(),
                       .field = "mesh_albedo",
                       .wanted = "\"constant\", which is measured here",
                       .found = "\"" + std::string(word(stimulus.depth.albedo)) + "\""});
  if (stimulus.depth.mitigation != Mitigation{})
    throw input_error({.file = study.file.string(),
                       .field = "mitigation",
                       .wanted = "none: bare depth is measured here",
                       .found = canonical_text(stimulus.depth.mitigation)});
  if (stimulus.depth.pipeline != Pipeline{})
    throw input_error({.file = study.file.string(),
                       .field = "pipeline",
                       .wanted = "the traced one (the part `realtime` measures the others beside it)",
                       .found = canonical_text(stimulus.depth.pipeline)});
  if (stimulus.depth.chain)
    throw input_error({.file = study.file.string(),
                       .field = "depth",
                       .wanted = "exact panoramas, whose errors are measured here",
                       .found = "a " + std::string(kind_of(stimulus.depth.chain->sources.front()))});
  const SceneDefinition definition = scene_of(study, stimulus);
  if (!definition.view.is_mono())
    throw input_error({.file = study.file.string(),
                       .field = "view.kind",
                       .wanted = "\"mono\": pictures of one eye are measured here",
                       .found = "\"" + std::string(word(definition.view.kind)) + "\""});
  TruthScene scene = load_truth_scene(definition, study.width_px, study.height_px);
  ObjectGeometry geometry = object_geometry(scene, stimulus.object_index);
  const int threads = request.threads > 0 ? request.threads : default_thread_count();
  DepthMap map = capture_depth(geometry.truth, stimulus.depth.width_px, stimulus.depth.yaw_texels, threads);
  const int spp = request.spp.value_or(study.samples_per_pixel);
  return {.study = std::move(study),
          .stimulus = stimulus,
          .threads = threads,
          .spp = spp,
          .recipe = how,
          .scene = std::move(scene),
          .geometry = std::move(geometry),
          .map = std::move(map)};
}

DepthMesh subject_mesh(const ConvergenceSubject& subject, const DepthMap& map, MeshDensity density,
                       double tolerance) {
  return build_depth_mesh(map, {.density = density,
                                .tolerance = tolerance,
                                .yaw_texels = subject.stimulus.depth.yaw_texels,
                                .threads = subject.threads});
}

Geometry subject_geometry(const ConvergenceSubject& subject, const DepthMesh& mesh) {
  return {mesh, Rgb::Constant(static_cast<float>(subject.scene.definition.albedo))};
}

}  // namespace seamline::renderer
