#include "x3d/x3d_subject.h"

#include <fmt/core.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "raytracer/scene/scene_moment.h"
#include "raytracer/scene/scene_surfaces.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/local_scene.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/estimators/rig_photograph.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"
#include "x3d/hanim_names.h"
#include "x3d/x3d_figure.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

int threads_of(const X3dRequest& request) {
  return request.threads > 0 ? request.threads : default_thread_count();
}

Image photograph(const Geometry& scene, const Light& light, const Camera& camera, const X3dRequest& request) {
  Progress progress("photograph", 1.0);
  return photograph_scene(scene, light, camera,
                          {.spp = request.spp,
                           .seed = request.seed,
                           .threads = threads_of(request),
                           .progress = [&, last = 0.0](double share) mutable {
                             progress.advance(share - last, "");
                             last = share;
                           }});
}

/// The study, whose scene files are needed again.
StudyDefinition study_of(const X3dRequest& request, const Manifest& manifest) {
  refuse_clips(request.source, "X3D");
  (void)study_of_set(request.source, manifest);  // the hash is the manifest's
  return read_study(study_file_of_set(request.source, manifest), AssetCheck::must_exist, request.asset_root,
                    IdleSettings::kept);
}

const ManifestStimulus& chosen_stimulus(const X3dRequest& request, const Manifest& manifest) {
  const std::string file = (fs::path(request.source) / "manifest.json").string();
  if (manifest.stimuli.empty())
    throw input_error({.file = file, .wanted = "a set with stimuli", .found = "none"});
  if (request.stimulus.empty()) return manifest.stimuli.front();
  for (const ManifestStimulus& one : manifest.stimuli)
    if (one.id == request.stimulus) return one;
  throw input_error({.file = file,
                     .field = request_name("stimulus"),
                     .wanted = "one of the set, like " + manifest.stimuli.front().id,
                     .found = request.stimulus});
}

SceneDefinition truth_definition(const StudyDefinition& study, const Stimulus& stimulus) {
  for (const SceneDefinition& scene : list_truths(study))
    if (truth_of(scene) == truth_of(stimulus)) return scene;
  throw input_error({.file = study.file.string(),
                     .field = "scene",
                     .wanted = "the scene " + truth_of(stimulus),
                     .found = "none of that name"});
}

void require_light(const Light& light, const std::string& source) {
  const bool shines = !light.suns.empty() || !light.lamps.empty() || light.environment != nullptr ||
                      light.emitters != nullptr || (light.environment_radiance > 0.0F).any();
  if (!shines)
    throw input_error({.file = source,
                       .wanted = "a light, a lamp or a surface that emits, or " +
                                 request_name("environment") + " or " + request_name("to_sun") + " with " +
                                 request_name("sun_irradiance"),
                       .found = "none"});
}

/// A note without the word that animations were left out; empty where it says nothing else.
std::string without_rest(std::string note) {
  constexpr std::string_view words = " (everything is shown at rest)", left_out = ": left out: ";
  const std::size_t at = note.rfind(words), list = note.rfind(left_out);
  if (at == std::string::npos || list == std::string::npos || at < list) return note;
  const std::size_t first = list + left_out.size(), semicolon = note.rfind("; ", at);
  std::size_t from = semicolon == std::string::npos || semicolon < first ? first : semicolon + 2,
              to = at + words.size();
  if (to < note.size())
    to += 2;
  else if (from > first)
    from -= 2;
  note.erase(from, to - from);
  return note.size() == first ? std::string() : note;
}

/// The figure of the object's file, where it is one. `placement`: from the file to the scene's world.
void take_figure(const FigureRequest& request, const std::function<Eigen::Affine3d()>& placement,
                 X3dSubject& subject) {
  FigureRead read = read_figure(request);
  if (!read.figure && read.why_not.empty()) return;
  if (read.figure) {
    Eigen::Affine3d x3d_from_world = Eigen::Affine3d::Identity();
    x3d_from_world.linear() = subject.camera.axes.transpose().cast<double>();
    x3d_from_world.translate(-subject.camera_position_m);
    subject.x3d_from_figure = x3d_from_world * placement();
    read.why_not = why_no_x3d_figure(*read.figure, subject.x3d_from_figure);
  }
  if (!read.why_not.empty()) {
    subject.notes.push_back("the figure stands still: " + read.why_not);
    return;
  }
  subject.figure = std::move(read.figure);
  if (subject.figure->times_s.empty()) return;
  for (std::string& note : subject.notes) note = without_rest(std::move(note));
  std::erase_if(subject.notes, [](const std::string& note) { return note.empty(); });
}

bool names_joint(std::string_view node) {
  return !hanim_joint(node).empty();
}

}  // namespace

X3dSubject subject_of_set(const X3dRequest& request) {
  const Manifest manifest = read_manifest(request.source);
  const ManifestStimulus& record = chosen_stimulus(request, manifest);
  const StudyDefinition study = study_of(request, manifest);
  const Stimulus& stimulus = record.stimulus;
  TruthScene scene =
      load_truth_scene(truth_definition(study, stimulus), manifest.width_px, manifest.height_px);
  const int threads = threads_of(request);
  const Geometry truth = scene.geometry_without(stimulus.object_index);

  X3dSubject subject;
  subject.title = record.id;
  subject.camera = scene.camera;
  subject.camera_position_m = scene.camera_position_m;
  subject.exposure_ev = scene.definition.exposure_ev;
  subject.albedo = scene.definition.albedo;
  subject.light = scene.light;
  subject.objects = scene.objects.at(stimulus.object_index - 1);
  const ObjectDefinition& object = scene.definition.objects.at(stimulus.object_index - 1);
  take_figure(
      {.path = object.path,
       .materials = scene.definition.materials,
       .moment = split_moment(object.file).moment,
       .is_joint = names_joint},
      [&] {
        std::vector<std::string> rests;
        return standing_placement(object, read_object_file(object, scene.definition), scene, rests);
      },
      subject);
  subject.photograph = photograph(truth, subject.light, subject.camera, request);
  DepthSettings settings = stimulus.depth;
  if (settings.mitigation != Mitigation{} || settings.pipeline != Pipeline{})
    subject.notes.push_back("the stimulus' mitigation and pipeline are not shown: the page has its own");
  settings.mitigation = {};
  settings.pipeline = {};
  LocalScene local = make_local_scene(truth, settings,
                                      {.albedo = subject.albedo,
                                       .threads = threads,
                                       .photograph = subject.camera,
                                       .picture = &subject.photograph});
  subject.depth = std::make_shared<const Geometry>(std::move(local.geometry));
  return subject;
}

X3dSubject subject_of_scene(const X3dRequest& request) {
  if (std::error_code error;
      !request.source.starts_with("builtin:") && !std::filesystem::exists(request.source, error))
    throw input_error({.file = request.source,
                       .wanted = "a rendered set, or a scene: .glb, .gltf or builtin:NAME",
                       .found = "nothing of that name"});
  if (!request.object)
    throw input_error({.field = request_name("object"),
                       .wanted = "what is put into the scene: .glb, .gltf or builtin:NAME",
                       .found = "none"});
  const SceneFile file = read_scene_file(resolve_named_file(request.source, "SET_OR_SCENE"));
  require_surface(file, request.source, "a scene");
  if (!request.light.camera && !file.camera)
    throw input_error({.file = request.source,
                       .wanted = "a camera in the scene, or " + request_name("at") + " X Y Z and " +
                                 request_name("look_at") + " X Y Z",
                       .found = "neither"});
  X3dSubject subject;
  subject.title = fs::path(request.source).filename().string() + " with " +
                  fs::path(request.object->file).filename().string();
  subject.camera =
      scene_camera(request.light, file, request.width_px, request.height_px, subject.camera_position_m);
  if (request.fov_deg)
    subject.camera.tan_half_horizontal =
        static_cast<float>(std::tan(0.5 * *request.fov_deg * std::numbers::pi / 180));
  subject.exposure_ev = request.light.exposure_ev;
  subject.albedo = request.light.albedo;
  const auto meshes =
      place_meshes(file, Eigen::Affine3d::Identity(), subject.camera_position_m, request.light.albedo, 0);
  subject.light = scene_light(request.light, file, subject.camera_position_m);
  add_emitters(meshes, subject.light);
  require_light(subject.light, request.source);
  PhotoObjects placed = place_objects({*request.object}, subject.camera_position_m);
  subject.objects = std::move(placed.meshes);
  subject.notes = std::move(placed.left_out);
  take_figure(
      {.path = request.object->path,
       .materials = request.object->materials,
       .transparency = request.object->transparency,
       .is_joint = names_joint},
      [&] { return placed.sizes.front().placement; }, subject);
  subject.depth = std::make_shared<const Geometry>(meshes);
  subject.photograph = photograph(*subject.depth, subject.light, subject.camera, request);
  return subject;
}

}  // namespace seamline::renderer
