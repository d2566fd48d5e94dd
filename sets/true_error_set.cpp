#include "sets/true_error_set.h"

#include <fmt/core.h>

#include <functional>
#include <tuple>
#include <vector>

#include "raytracer/common/parallel.h"
#include "raytracer/common/sampler.h"
#include "raytracer/error/true_error.h"
#include "raytracer/error/worst_tile.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "renderer/views/depth_image.h"
#include "renderer/views/view_picture.h"
#include "sets/stimulus_scene.h"
#include "sets/view_depth.h"
#include "stimuli/definition/looks/study_look.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

/// What shares a scene, a truth pass and a depth mesh comes together.
using MeshKey = std::tuple<std::string, int, DepthSettings>;  // truth, object, mesh
using Groups = std::map<MeshKey, std::vector<ManifestStimulus>>;

Groups unmeasured(const StudyDefinition& study, const Manifest& manifest, const TrueErrorRequest& request,
                  const TrueErrors& known) {
  // A manifest says how depth was captured as a text only.
  std::map<std::string, DepthSettings> settings;
  for (const Stimulus& stimulus : list_stimuli(study)) settings[stimulus_id(stimulus)] = stimulus.depth;
  Groups groups;
  bool any = false;
  for (const ManifestStimulus& record : manifest.stimuli) {
    if (!matches_pattern(record.id, request.pattern)) continue;
    any = true;
    const auto found = known.find(record.id);
    if (found != known.end() && found->second.picture_sha256 == record.sha256 &&
        found->second.reference_spp == request.spp)
      continue;
    DepthSettings depth = record.stimulus.depth;
    if (const auto of_study = settings.find(record.id); of_study != settings.end()) {
      depth.chain = of_study->second.chain;
      depth.mitigation = of_study->second.mitigation;
      depth.pipeline = of_study->second.pipeline;
    }
    groups[{truth_of(record.stimulus), record.stimulus.object_index, depth}].push_back(record);
  }
  if (!any)
    throw input_error({.file = request.set_folder.string(),
                       .field = request_name("true_error"),
                       .wanted = "a pattern that matches a finished stimulus' id",
                       .found = "\"" + request.pattern + "\""});
  return groups;
}

class ErrorMeasuring {
 public:
  ErrorMeasuring(const StudyDefinition& study, const TrueErrorRequest& request)
      : study_(study),
        request_(request),
        threads_(request.threads > 0 ? request.threads : default_thread_count()),
        errors_(read_true_errors(request.set_folder)) {}

  void run() {
    const Manifest manifest = read_manifest(request_.set_folder);
    forget_changed(manifest);
    const Groups groups = unmeasured(study_, manifest, request_, errors_);
    double work = 0;
    for (const auto& [key, records] : groups) work += 1 + records.size();
    progress_.emplace("true errors of " + study_.name, work);
    for (const SceneDefinition& scene : list_truths(study_)) measure_scene(scene, groups);
    progress_.reset();
    write_true_errors(request_.set_folder, errors_);
  }

 private:
  /// Results for pictures that are no longer there say nothing.
  void forget_changed(const Manifest& manifest) {
    std::map<std::string, std::string> pictures;
    for (const ManifestStimulus& record : manifest.stimuli) pictures[record.id] = record.sha256;
    std::erase_if(errors_, [&](const auto& error) {
      const auto found = pictures.find(error.first);
      return found == pictures.end() || found->second != error.second.picture_sha256;
    });
  }

  void measure_scene(const SceneDefinition& definition, const Groups& groups) {
    std::optional<TruthScene> scene;
    std::unique_ptr<SceneEstimator> estimator;
    int object_taken = 0;
    for (const auto& [key, records] : groups) {
      const auto& [name, object_index, depth] = key;
      if (name != definition.truth) continue;
      if (!scene) {
        scene = load_truth_scene(definition, study_.width_px, study_.height_px);
        estimator = make_path_estimator(
            *scene, {.spp = request_.spp, .seed = study_.seed + reference_seed_offset, .threads = threads_});
      }
      if (object_taken != object_index)
        estimator->take_object(object_index, report(1, fmt::format("{} object {}", name, object_index)));
      else
        progress_->advance(1, name);
      object_taken = object_index;
      measure_mesh(*scene, *estimator, depth, records);
    }
  }

  void measure_mesh(const TruthScene& scene, SceneEstimator& estimator, DepthSettings settings,
                    const std::vector<ManifestStimulus>& records) {
    settings.mesh = request_.mesh.value_or(settings.mesh);
    std::optional<LocalScene> depth;
    for (const ManifestStimulus& record : records) {
      const Recipe how = recipe(record.stimulus.artifact, record.stimulus.isolation);
      const bool has_parallax = scene.definition.view.parallax == Parallax::depth;
      if ((how.answers.needs_depth() || has_parallax) && !depth)
        depth.emplace(stimulus_scene(scene, estimator, settings, true, threads_));
      const EstimatedStimulus made =
          estimator.stimulus(how, depth ? depth->world() : DepthWorld(nullptr), report(1, record.id));
      measure(record, scene.definition, made.sums, [&](Composite&& composite) {
        give_depth_parallax(scene, estimator.truth(), depth ? &depth->geometry : nullptr, made.sums, threads_,
                            composite);
        return compose_view(scene.definition.view, composite.picture);
      });
    }
  }

  /// `seen` makes of a composite what people would be shown.
  void measure(const ManifestStimulus& record, const SceneDefinition& scene, const StimulusSums& reference,
               const std::function<Image(Composite&&)>& seen) {
    const View& view = scene.view;
    const double exposure_ev = scene.exposure_ev;
    ByteImage shown =
        read_all_eyes(request_.set_folder, {record.image, record.sha256, study_.width_px, study_.height_px},
                      record.more_eyes);
    if (view.kind == ViewKind::depth_image) shown = half_of(shown, false);
    const TrueError error =
        true_error(shown, {seen(compose_half(reference, 0)), seen(compose_half(reference, 1))}, exposure_ev,
                   is_panorama(scene));
    const TrueErrorRecord result{.rmse = error.rmse(),
                                 .standard_error = error.standard_error(),
                                 .worst_tile = error.worst_tile_rmse(),
                                 .noisy_reference = error.reference_is_noisy(),
                                 .reference_spp = request_.spp,
                                 .picture_sha256 = record.sha256};
    write_png(
        request_.set_folder / ("worst-tile-" + record.id + ".png"),
        worst_tile_picture(shown, display_image(seen(compose(reference)), exposure_ev), error.worst_tile(),
                           fmt::format("{}: error {:.4f} in this tile, {:.4f} in the picture (display units)",
                                       record.id, result.worst_tile, result.rmse)));
    errors_[record.id] = result;
    write_true_errors(request_.set_folder, errors_);
  }

  /// A share of `work` as a pass reports it.
  ReportProgress report(double work, const std::string& what) {
    return [this, work, what, last = 0.0](double share) mutable {
      if (share < last) last = share;
      progress_->advance((share - last) * work, what);
      last = share;
    };
  }

  const StudyDefinition& study_;
  const TrueErrorRequest& request_;
  int threads_;
  TrueErrors errors_;
  std::optional<Progress> progress_;
};

}  // namespace

void measure_true_errors(const StudyDefinition& study, const TrueErrorRequest& request) {
  ErrorMeasuring(study, request).run();
}

}  // namespace seamline::renderer
