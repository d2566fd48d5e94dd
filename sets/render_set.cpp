#include "sets/render_set.h"

#include <fmt/core.h>

#include "raytracer/common/parallel.h"
#include "raytracer/common/stopwatch.h"
#include "raytracer/scene/moving_scenes.h"
#include "raytracer/scene/visible_objects.h"
#include "raytracer/tracing/kept_trees.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "renderer/picture/rare_light.h"
#include "sets/clips/clip_decisions.h"
#include "sets/clips/frame_changes.h"
#include "sets/clips/mesh_share.h"
#include "sets/clips/set_clips.h"
#include "sets/contact_sheet.h"
#include "sets/render_plan.h"
#include "sets/set_layers.h"
#include "sets/set_manifest.h"
#include "sets/set_pictures.h"
#include "sets/set_work.h"
#include "sets/sharing/set_claim.h"
#include "sets/sharing/set_running.h"
#include "sets/sharing/set_truths.h"
#include "sets/sharing/work_list.h"
#include "sets/stimulus_scene.h"
#include "sets/timings.h"
#include "sets/view_depth.h"
#include "stimuli/definition/clip_frames.h"
#include "stimuli/pictures/difference.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/carried_files.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/running/memory.h"
#include "support/running/progress.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

/// A name for the files of one process; empty when it renders everything.
std::string part_name(const RenderRequest& request) {
  if (!request.element.empty()) return request.element;
  return request.shard_count == 1 ? std::string() : fmt::format("{}of{}", request.shard, request.shard_count);
}

/// One render job: what is asked, what is finished, and the order of work: scene, object, width.
class SetRenderer {
 public:
  /// `shown` is what people see, `study` what is rendered for it (`still_study`).
  SetRenderer(const StudyDefinition& shown, const StudyDefinition& study, const RenderRequest& request)
      : shown_(shown),
        study_(study),
        request_(request),
        settings_(render_settings(study, request)),
        hashes_(study, settings_),
        records_(request.set_folder),
        threads_(request.threads > 0 ? request.threads : default_thread_count()),
        timings_(request.set_folder, threads_, part_name(request)) {}

  RenderSummary run() {
    const Stopwatch watch;
    require_set_folder(request_.set_folder);
    earlier_stimuli_ = stimuli_listed(request_.set_folder, study_);
    work_ = find_work(study_, request_, hashes_, records_);
    summary_.already_finished = work_.already_finished;
    if (shown_.clip) share_among_frames();
    if (request_.part == JobPart::truth) work_.pending.clear(), work_.of_object.clear();
    if (request_.part == JobPart::join) require_nothing_pending(work_, request_.set_folder);
    for (const SceneDefinition& truth : truths_) load_and_check(truth);
    for (const char* part : {"records", "stimuli", "references"})
      prepare_output_folder(request_.set_folder / part);
    const SetClaim claim(request_.set_folder, hashes_.of_set());
    if (!request_.element.empty()) {
      write_work_list(request_.set_folder, list_work(study_, request_.only, hashes_, request_.job));
      const int done = request_.part == JobPart::stimuli ? work_.already_finished : 0;
      mark_.emplace(request_.set_folder, request_.element, done,
                    done + static_cast<int>(work_.pending.size()));
    }
    render_scenes();
    if (request_.part == JobPart::whole || request_.part == JobPart::join) write_set();
    if (request_.part == JobPart::join) truths_of_others_.remove_all();
    mark_.reset();
    summary_.seconds = watch.seconds();
    timings_.write(summary_.seconds);
    return summary_;
  }

 private:
  void render_scenes() {
    progress_.emplace("rendering " + study_.name, total_weight(work_, weights_));
    for (const SceneDefinition& truth : truths_) {
      render_scene(truth);
      give_back_freed_memory();
    }
    progress_.reset();
  }

  /// Frames of clips have search trees and meshes in common and, where an error is asked for, how they are
  /// sampled.
  void share_among_frames() {
    trees_.emplace(settings_.estimator == Estimator::fast ? TreeQuality::for_few_rays
                                                          : TreeQuality::for_light);
    std::vector<Stimulus> rendered;
    for (const PendingStimulus& work : work_.pending) rendered.push_back(work.stimulus);
    meshes_.emplace(study_, rendered, [this](const Stimulus& stimulus) {
      return asked_of_depth(stimuli_.at(truth_of(stimulus))).traces_depth();
    });
    if (!request_.error) return;
    ClipDecisionSubject subject{
        .study = study_, .stimuli = stimuli_, .moving = moving_, .set_folder = request_.set_folder};
    subject.inputs_of_truth = [this](const std::string& truth) { return hashes_.of_reference(truth); };
    subject.inputs_of_stimulus = [this](const Stimulus& one) { return hashes_.of_stimulus(one); };
    subject.estimator_of = [this](const TruthScene& scene) { return estimator_of(scene, Frame::decides); };
    subject.depth_of = [this](const TruthScene& scene, const SceneEstimator& estimator, const Stimulus& one) {
      return depth_of(scene, estimator, one);
    };
    subject.wanted = std::move(rendered);
    subject.tell = [this](const std::string& what) {
      if (mark_) mark_->alive();
      progress_->advance(0, what);
    };
    decisions_.emplace(shown_, std::move(subject));
  }

  /// Manifest and study file change together, at the end: until then a set stays what it was.
  void write_set() {
    identity_ = identity_in(request_.set_folder, shown_);
    Manifest written = manifest();
    copy_carried_files(shown_, request_.set_folder);
    write_study_file(request_.set_folder, shown_, identity_);
    write_manifest(request_.set_folder, written);
    // Another shard may have finished meanwhile: the last to look lists everything.
    for (Manifest now = manifest(); now.stimuli.size() != written.stimuli.size(); now = manifest()) {
      write_manifest(request_.set_folder, now);
      written = std::move(now);
    }
    if (written.stimuli.size() < earlier_stimuli_)
      summary_.notes.push_back(fmt::format(
          "the set had {} and now has {}: the others were rendered with other settings; "
          "render without {} to make them again",
          counted(earlier_stimuli_, "stimulus", "stimuli"), written.stimuli.size(), request_name("only")));
  }

  ReportProgress report(double work, const std::string& what) {
    return [this, work, what, last = 0.0](double share) mutable {
      if (mark_) mark_->alive();
      if (share < last) last = share;  // a further round over the same picture
      progress_->advance((share - last) * work, what);
      last = share;
    };
  }

  enum class Frame { decides, shown };
  [[nodiscard]] std::unique_ptr<SceneEstimator> estimator_of(const TruthScene& scene, Frame frame) const {
    const std::string& truth = truth_of(scene.definition);
    EstimateOptions options = estimate_options(stimuli_.at(truth), settings_, threads_);
    options.keeps_error_maps = decisions_ && frame == Frame::shown;
    options.judges_decided = !decisions_ || frame == Frame::decides || is_judged(truth, shown_.clip->frames);
    return make_estimator(settings_.estimator, scene, options);
  }

  /// Every wrong input is found before the first long computation.
  void load_and_check(const SceneDefinition& definition) {
    if (!work_.selected_truths.contains(definition.truth) || request_.part == JobPart::join) return;
    if (request_.part == JobPart::truth && definition.truth != request_.truth) return;
    if (request_.part != JobPart::truth && !work_.is_pending(definition.truth) &&
        records_.finished_reference(definition.truth, hashes_.of_reference(definition.truth)))
      return;
    TruthScene scene = shown_.clip ? moving_.load(definition)
                                   : load_truth_scene(definition, study_.width_px, study_.height_px);
    require_visible_objects(study_, scene);
    require_mirrors(study_, scene);
    lights_.emplace(definition.truth, light_facts(scene));
    wanted_.insert(definition.truth);
    if (!shown_.clip) scenes_.emplace(definition.truth, std::move(scene));
  }

  void render_scene(const SceneDefinition& definition) {
    if (!wanted_.contains(definition.truth)) return;
    const TruthScene scene =
        shown_.clip ? moving_.load(definition) : std::move(scenes_.extract(definition.truth).mapped());
    const std::unique_ptr<SceneEstimator> estimator = estimator_of(scene, Frame::shown);
    if (decisions_) decisions_->hold(*estimator, definition.truth);
    if (request_.part == JobPart::stimuli && estimator->truth_pieces() == 1) take_truth(scene, 1, *estimator);
    finish_reference(scene, *estimator);
    if (request_.part == JobPart::truth)
      truths_of_others_.leave(definition.truth, hashes_.of_reference(definition.truth), *estimator,
                              report(weights_.truth, definition.truth + " truth"));
    give_back_freed_memory();
    for (const int object : scene.object_indices()) render_object(scene, object, *estimator);
    summary_.savings.emplace_back(definition.truth, estimator->savings());
  }

  /// What another process made of the truth; what is not there is made here.
  void take_truth(const TruthScene& scene, int piece, SceneEstimator& estimator) {
    truths_of_others_.take(scene.definition.truth, piece, hashes_.of_reference(scene.definition.truth),
                           estimator);
  }

  void finish_reference(const TruthScene& scene, SceneEstimator& estimator) {
    const std::string& name = scene.definition.truth;
    const std::string inputs = hashes_.of_reference(name);
    if (records_.finished_reference(name, inputs)) return;
    const Stopwatch watch;
    const SceneReference reference = estimator.reference(report(weights_.reference, name + " reference"));
    records_.finish_reference(write_reference(request_.set_folder, name,
                                              {.made = reference,
                                               .exposure_ev = scene.definition.exposure_ev,
                                               .view = scene.definition.view,
                                               .planar_m = reference_depth(scene)}),
                              inputs);
    timings_.add("reference-" + name, watch.seconds(), reference.rays);
  }

  void render_object(const TruthScene& scene, int object_index, SceneEstimator& estimator) {
    const std::vector<std::vector<PendingStimulus>> meshes =
        by_mesh(work_, study_, scene.definition.truth, object_index);
    if (meshes.empty()) return;
    stereo_.forget();
    const std::string what = scene.definition.truth + " " + scene.definition.objects[object_index - 1].name;
    if (request_.part == JobPart::stimuli && estimator.truth_pieces() > 1)
      take_truth(scene, object_index, estimator);
    const Stopwatch watch;
    estimator.take_object(object_index, report(weights_.truth, what));
    timings_.add("truth-" + scene.definition.truth + "-" + std::to_string(object_index), watch.seconds(),
                 estimator.truth().rays);
    for (const std::vector<PendingStimulus>& works : meshes) render_mesh(scene, estimator, works);
    give_back_freed_memory();
  }

  /// What the depth camera saw, where that was not what is there now.
  [[nodiscard]] std::optional<Geometry> captured_geometry(const TruthScene& now, const Stimulus& stimulus) {
    const std::optional<SceneDefinition> captured = captured_scene(study_, stimulus);
    if (!captured) return std::nullopt;
    const TruthScene then = moving_.load(*captured);
    require_same_camera(study_, now, then);
    return then.geometry_without(stimulus.object_index);
  }

  [[nodiscard]] LocalScene depth_of(const TruthScene& scene, const SceneEstimator& estimator,
                                    const Stimulus& stimulus) {
    DepthSettings settings = stimulus.depth;
    settings.mesh = settings_.mesh.value_or(settings.mesh);
    const Answers asked = asked_of_depth(stimuli_.at(truth_of(scene.definition)));
    const std::optional<Geometry> captured = captured_geometry(scene, stimulus);
    return stimulus_scene(scene, estimator, settings, asked.traces_depth(), threads_,
                          captured ? &*captured : nullptr, &stereo_);
  }

  /// All stimuli of one depth map share its mesh.
  void render_mesh(const TruthScene& scene, SceneEstimator& estimator,
                   const std::vector<PendingStimulus>& works) {
    const Stopwatch watch;
    std::shared_ptr<const LocalScene> depth = meshes_ ? meshes_->find(works.front().stimulus) : nullptr;
    bool needed = request_.layers || scene.definition.view.parallax == Parallax::depth;
    for (const PendingStimulus& work : works)
      needed = needed || recipe(work.stimulus.artifact, work.stimulus.isolation).answers.needs_depth();
    // By all artifacts of the scene, not by those left to render: an interrupted set has the same bytes.
    const Answers asked = asked_of_depth(stimuli_.at(truth_of(scene.definition)));
    if (needed && depth == nullptr)
      depth = std::make_shared<const LocalScene>(depth_of(scene, estimator, works.front().stimulus));
    progress_->advance(weights_.mesh, "depth mesh");
    timings_.add(fmt::format("mesh-{}-{}-{:04}", scene.definition.truth, works.front().stimulus.object,
                             works.front().stimulus.depth.width_px),
                 watch.seconds(), 0);
    // Frames of clips may be sampled each in its own way.
    for (const std::vector<PendingStimulus>& alike : by_picture(works)) {
      if (decisions_)
        for (const PendingStimulus& work : alike) render_one(scene, estimator, depth.get(), {work});
      else
        render_one(scene, estimator, depth.get(), alike);
      for (const PendingStimulus& work : alike)
        if (meshes_) meshes_->finish(work.stimulus, depth);
    }
    // Taking it again costs 0.15 s: little beside stimuli that trace bounce light, which need most of it.
    if (asked.bounce == Who::depth) give_back_freed_memory();
  }

  /// Renders a picture, and writes it for each of the stimuli that show it. `depth` is null when no stimulus
  /// of its width asks it anything.
  void render_one(const TruthScene& scene, SceneEstimator& estimator, const LocalScene* depth,
                  const std::vector<PendingStimulus>& works) {
    const Stimulus& first = works.front().stimulus;
    const std::string id = stimulus_id(first);
    const StimulusDecision* decision = decisions_ ? &decisions_->of_stimulus(id) : nullptr;
    const Stopwatch watch;
    const Recipe how = recipe(first.artifact, first.isolation);
    const DepthWorld world = depth != nullptr ? depth->world() : DepthWorld(nullptr);
    const ReportProgress reported = report(weights_.stimulus, id);
    EstimatedStimulus made = decision != nullptr ? estimator.decided_stimulus(how, world, *decision, reported)
                                                 : estimator.stimulus(how, world, reported);
    Composite composite = compose(made.sums, made.sums.compositing, threads_);
    give_depth_parallax(scene, estimator.truth(), depth != nullptr ? &depth->geometry : nullptr, made.sums,
                        threads_, composite);
    ErrorNotes notes{.worst_tile = made.worst_tile};
    if (request_.error && made.rmse)
      notes.rare_light =
          rare_light_share(made.sums, composite.picture, scene.definition.exposure_ev, threads_);
    if (made.error_map) notes.changes = changes_.add(id, std::move(*made.error_map));
    for (const PendingStimulus& work : works) {
      keep(scene, estimator, depth, work, made, composite);
      const bool is_first = &work == &works.front();
      timings_.add(stimulus_id(work.stimulus), is_first ? watch.seconds() : 0, is_first ? made.sums.rays : 0,
                   notes);
      if (!is_first) progress_->advance(weights_.stimulus, stimulus_id(work.stimulus));
      ++summary_.rendered;
      if (mark_) mark_->finished_one();
    }
  }

  /// A rendered picture as that of one stimulus, whose record then says that it is finished.
  void keep(const TruthScene& scene, SceneEstimator& estimator, const LocalScene* depth,
            const PendingStimulus& work, const EstimatedStimulus& made, const Composite& composite) {
    const Recipe how = recipe(work.stimulus.artifact, work.stimulus.isolation);
    const Geometry* geometry = depth != nullptr ? &depth->geometry : nullptr;
    ManifestStimulus record =
        write_stimulus(request_.set_folder, work.stimulus,
                       {.made = made,
                        .composite = composite,
                        .exposure_ev = scene.definition.exposure_ev,
                        .view = scene.definition.view,
                        .planar_m = stimulus_depth(scene, estimator.geometry(), how, geometry)});
    if (depth != nullptr && work.stimulus.depth.pipeline != Pipeline{} && how.answers.needs_depth())
      record.pipeline_error = display_rmse(composite.picture, traced_picture(estimator, how, *depth),
                                           scene.definition.exposure_ev);
    if (depth != nullptr && (how.answers.needs_depth() || scene.definition.view.parallax == Parallax::depth))
      record.mesh = depth->mesh;
    if (request_.layers)
      write_layers({request_.set_folder, work.stimulus, work.inputs}, scene, geometry,
                   {estimator.truth(), made.sums, composite});
    records_.finish(record, work.inputs);
  }

  /// What methods of real time stand for.
  [[nodiscard]] Image traced_picture(SceneEstimator& estimator, const Recipe& how,
                                     const LocalScene& depth) const {
    const EstimatedStimulus traced = estimator.stimulus(how, depth.traced_world(), {});
    return compose(traced.sums, Compositing::ratio, threads_).picture;
  }

  [[nodiscard]] Manifest manifest() {
    Manifest of_pictures = set_manifest({study_, settings_, hashes_, records_, identity_}, lights_);
    if (shown_.clip) return assemble_clips(shown_, request_.set_folder, of_pictures);
    std::error_code error;
    fs::remove(request_.set_folder / clip_set_file, error);  // the study may have had clips before
    return of_pictures;
  }

  const StudyDefinition& shown_;
  const StudyDefinition& study_;
  const std::vector<SceneDefinition> truths_ = list_truths(study_);
  const StimuliOfTruths stimuli_ = stimuli_of_truths(study_);
  const RenderRequest& request_;
  RenderSettings settings_;
  InputHashes hashes_;
  SetRecords records_;
  std::string identity_;  ///< of the set in the folder; known when it is written
  int threads_;
  Timings timings_;
  SetWork work_;
  const WorkWeights weights_ = work_weights(settings_.estimator);
  std::size_t earlier_stimuli_ = 0;
  std::optional<KeptTrees> trees_;                          ///< of clips
  MovingScenes moving_{study_.width_px, study_.height_px};  ///< of clips
  std::optional<ClipDecisions> decisions_;                  ///< of clips, where an error is asked for
  std::optional<MeshShare> meshes_;                         ///< of clips
  FrameChanges changes_{shown_};
  std::set<std::string> wanted_;              ///< truths that were loaded and are rendered
  std::map<std::string, TruthScene> scenes_;  ///< of them, until then; those of clips are loaded again
  StereoMemory stereo_;                       ///< of the object that is rendered
  std::map<std::string, LightFacts> lights_;  ///< of scenes loaded so far
  SetTruths truths_of_others_{request_.set_folder};
  std::optional<RunningMark> mark_;
  std::optional<Progress> progress_;
  RenderSummary summary_;
};

}  // namespace

RenderSummary render_set(const StudyDefinition& study, const RenderRequest& request) {
  if (study.clip && request.error && request.estimator != Estimator::fast)
    throw input_error({.field = request_name("error"),
                       .wanted = "the fast estimator, or a number of samples (" + request_name("spp") +
                                 "), for a study of clips",
                       .found = request_name("estimator") + " " + std::string(word(request.estimator))});
  const StudyDefinition rendered = still_study(study);
  const RenderSummary summary = SetRenderer(study, rendered, request).run();
  if (request.contact_sheet) write_contact_sheets(request.set_folder);
  return summary;
}

}  // namespace seamline::renderer
