// The fast estimator: one truth pass for all objects of a scene, bounce light filtered, the depth mesh asked
// only where and as often as the picture needs it.
#include <tuple>

#include "raytracer/error/error_estimate.h"
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/fast/fast_stimulus.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "renderer/estimators/fast/frame_sums.h"
#include "renderer/estimators/fast/photograph_error.h"
#include "renderer/estimators/fast/scene_sums_bytes.h"
#include "renderer/estimators/fast/truth_sums.h"
#include "renderer/estimators/seen_emission.h"

namespace seamline::renderer {
namespace {

/// The errors of the reference as the stimuli of each object filter it.
struct PhotographJudgement {
  std::vector<ErrorEstimate> errors = {};  ///< [object - 1]; empty: not judged yet
  std::size_t strength = 0;                ///< with the least estimated error, in the choices' filters
  int not_good_enough = 0;                 ///< an object; 0: none, or there is no target

  [[nodiscard]] ErrorEstimate& error(int object) { return errors[object - 1]; }
  [[nodiscard]] const ErrorEstimate& error(int object) const { return errors[object - 1]; }
};

FirstSky first_sky(const EstimatorChoices& choices) {
  if (!choices.filters_sky) return FirstSky::direct;
  return choices.keeps_sky_apart ? FirstSky::apart : FirstSky::bounce;
}

class FastEstimator : public SceneEstimator {
 public:
  FastEstimator(const TruthScene& scene, const EstimateOptions& options)
      : choices_(
            estimator_choices(Estimator::fast, light_facts(scene), scene.definition.exposure_ev, options)),
        scene_(with_chosen_light(scene, choices_)),
        seed_(options.seed),
        threads_(options.threads),
        seen_(find_seen_emission(scene_, threads_)),
        judges_decided_(options.judges_decided),
        keeps_error_maps_(options.keeps_error_maps),
        scene_geometry_(std::make_unique<const SceneGeometry>(scene_)),
        sums_(empty_sums(scene.camera, scene.objects.size())) {
    judged_.errors.resize(scene.objects.size());
    judged_.strength = choices_.filters.size() - 1;
  }

  [[nodiscard]] const EstimatorChoices& choices() const override { return choices_; }

  SceneReference reference(const ReportProgress& progress) override {
    sample(progress);
    const Camera& camera = scene_.camera;
    SceneReference out{reference_image(truth_sums_of(1, filter())),
                       {camera.width_px, camera.height_px, 1, {}},
                       sums_.counts.traced};
    out.object_ids = click_map(scene_);
    return out;
  }

  void take_object(int object_index, const ReportProgress& progress) override {
    sample(progress);
    geometry_.reset();
    geometry_.emplace(object_geometry(scene_, object_index));
    object_index_ = object_index;
    truth_ = truth_sums(sums_, scene_.camera, scene_.light, object_index,
                        {.filter = filter(), .sky_apart = true, .threads = threads_});
    if (keeps_maps()) find_filtered(object_index);
  }

  [[nodiscard]] const ObjectGeometry& geometry() const override { return *geometry_; }
  [[nodiscard]] const TruthSums& truth() const override { return truth_; }

  EstimatedStimulus stimulus(const Recipe& recipe, const DepthWorld& depth,
                             const ReportProgress& progress) override {
    FastStimulusOptions options{.seed = seed_, .threads = threads_, .filter = filter(), .progress = progress};
    if (choices_.error) options.target = ErrorTarget{*choices_.error};
    return estimated(recipe, depth, options);
  }

  [[nodiscard]] PhotographDecision photograph_decision(const ReportProgress& progress) override {
    sample(progress);
    return {sums_.spp, judged_.strength};
  }

  void hold_to(const PhotographDecision& decision) override {
    held_ = decision;
    if (!scene_geometry_) scene_geometry_ = std::make_unique<const SceneGeometry>(scene_);
  }

  [[nodiscard]] std::shared_ptr<const FrameBase> frame_base(const ReportProgress& progress) override {
    if (!held_) return nullptr;
    return std::make_shared<const FrameBase>(
        make_frame_base(scene_, SceneGeometry(scene_), choices_, held_->spp, pass(progress)));
  }

  void sample_beside(std::function<std::shared_ptr<const FrameBase>()> base) override {
    base_ = std::move(base);
  }

  [[nodiscard]] EstimatedStimulus decided_stimulus(const Recipe& recipe, const DepthWorld& depth,
                                                   const StimulusDecision& decision,
                                                   const ReportProgress& progress) override {
    return estimated(recipe, depth,
                     {.seed = seed_,
                      .threads = threads_,
                      .filter = filter(),
                      .decision = &decision,
                      .judges = judges_decided_,
                      .progress = progress});
  }

  [[nodiscard]] int truth_pieces() const override { return 1; }

  void write_truth(int, ByteWriter& out, const ReportProgress& progress) override {
    sample(progress);
    out.put(std::uint64_t{judged_.strength});
    for (const ErrorEstimate& error : judged_.errors) {
      out.put(error.image);
      out.put_all(error.tiles);
      out.put_all(error.blocks);
    }
    write_sums(sums_, out);
  }

  [[nodiscard]] bool read_truth(int, ByteReader& in) override {
    PhotographJudgement judged{.errors = std::vector<ErrorEstimate>(scene_.objects.size())};
    std::uint64_t strength = 0;
    in.get(strength);
    for (ErrorEstimate& error : judged.errors) {
      in.get(error.image);
      in.get_all(error.tiles, static_cast<std::size_t>(sums_.grid.count()));
      in.get_all(error.blocks, static_cast<std::size_t>(sums_.blocks().count()));
    }
    SceneSums sums = empty_sums(scene_.camera, scene_.objects.size());
    if (!read_sums(in, sums) || strength >= choices_.filters.size()) return false;
    judged.strength = static_cast<std::size_t>(strength);
    judged_ = std::move(judged);
    sums_ = std::move(sums);
    scene_geometry_.reset();
    return true;
  }

  [[nodiscard]] Savings savings() const override {
    Savings all = saved_;
    all.joint = sums_.counts;
    if (choices_.keeps_who_is_in_front) return all;
    for (const auto& object : sums_.objects)
      for (std::size_t t = 0; t < object.size(); ++t)
        if (object[t])  // a byte a sample
          for (const int block : blocks_of(sums_.grid, static_cast<int>(t)))
            all.order_bytes += std::int64_t{sums_.blocks().pixels(block)} * sums_.spp[block];
    return all;
  }

 private:
  EstimatedStimulus estimated(const Recipe& recipe, const DepthWorld& depth, FastStimulusOptions options) {
    const ObjectTruth truth{.scene = scene_,
                            .scene_sums = sums_,
                            .geometry = *geometry_,
                            .object_index = object_index_,
                            .truth_sums = truth_,
                            .error = judged_.error(object_index_),
                            .seen = seen_.get()};
    options.keeps_pictures = keeps_maps();
    FastStimulus made = render_fast_stimulus(truth, depth, recipe, choices_, options);
    add(made.saved);
    EstimatedStimulus out{
        .sums = std::move(made.sums), .rmse = {}, .worst_tile = {}, .decision = std::move(made.decision)};
    if (options.judges || options.decision == nullptr) {
      out.rmse = made.error.rmse();
      out.worst_tile = made.error.worst_tile();
    }
    if (keeps_maps())
      out.error_map =
          error_map(made.pictures, filtered_, scene_.definition.exposure_ev, threads_, sums_.grid.wraps);
    return out;
  }

  [[nodiscard]] bool keeps_maps() const { return keeps_error_maps_ && (judges_decided_ || !held_); }

  /// What the filter changed in the photograph of an object, in each half.
  void find_filtered(int object_index) {
    filtered_ = {};
    if (judged_.strength == 0) return;
    filtered_ = photograph_halves(truth_, scene_.definition.view).with_object;
    const PhotographHalves sampled = photograph(object_index, no_filter);
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t i = 0; i < filtered_[half].values.size(); ++i)
        filtered_[half].values[i] -= sampled.with_object[half].values[i];
  }

  void add(const Savings& stimulus) {
    saved_.depth += stimulus.depth;
    saved_.stimuli += stimulus.stimuli;
    saved_.ratio_samples += stimulus.ratio_samples;
    saved_.ratio_rays += stimulus.ratio_rays;
    saved_.untouched_blocks += stimulus.untouched_blocks;
    saved_.untouched_rays += stimulus.untouched_rays;
  }

  [[nodiscard]] ScenePassOptions pass(const ReportProgress& progress) const {
    return {.seed = seed_,
            .threads = threads_,
            .tail_every = choices_.tail_every,
            .first_sky = first_sky(choices_),
            .who_is_in_front = choices_.keeps_who_is_in_front,
            .seen = seen_.get(),
            .progress = progress};
  }

  /// The truth pass: once a scene.
  void sample(const ReportProgress& progress) {
    if (!scene_geometry_) return;
    ScenePassOptions options = pass({});
    // Rounds are not known beforehand: each takes half of what is left of the progress bar.
    double done = 0, part = choices_.error ? 0.5 : 1.0;
    options.progress = [&](double share) {
      if (progress) progress(done + part * share);
    };
    if (held_) return sample_as_held(options);
    std::vector<int> wanted(sums_.spp.size(), choices_.first_spp);
    add_samples(scene_, *scene_geometry_, wanted, options, sums_);
    std::optional<ErrorTarget> target;
    if (choices_.error) target = ErrorTarget{*choices_.error * choices_.photograph_share};
    for (int first = 1;; first = judged_.not_good_enough) {
      judged_ = judge(judged_, first, target);
      if (judged_.not_good_enough == 0) break;
      wanted = next_samples(state(judged_.error(judged_.not_good_enough)), *target).next;
      if (wanted == sums_.spp) break;
      done += part;
      part *= 0.5;
      add_samples(scene_, *scene_geometry_, wanted, options, sums_);
    }
    for (const int k :
         scene_.object_indices())  // those never looked at, because the first object never was good enough
      if (judged_.error(k).tiles.empty())
        judged_.error(k) = error_with(k, judged_.strength, photograph(k, no_filter));
    scene_geometry_.reset();
  }

  void sample_as_held(const ScenePassOptions& options) {
    const std::shared_ptr<const FrameBase> base = base_ ? base_() : nullptr;
    if (base && may_be_base(*base, scene_.definition, choices_))
      saved_.frames += add_samples_beside(*base, scene_, *scene_geometry_, options, sums_);
    else
      add_samples(scene_, *scene_geometry_, held_->spp, options, sums_);
    judged_.strength = held_->strength;
    scene_geometry_.reset();
    if (!judges_decided_) {
      for (ErrorEstimate& error : judged_.errors) error = unknown_error();
      return;
    }
    const PhotographHalves sampled = photograph(1, no_filter);
    for (const int k : scene_.object_indices()) judged_.error(k) = error_with(k, judged_.strength, sampled);
  }

  /// As large as an estimate.
  [[nodiscard]] ErrorEstimate unknown_error() const {
    ErrorEstimate error;
    error.tiles.resize(sums_.grid.count());
    error.blocks.resize(static_cast<std::size_t>(sums_.blocks().count()));
    return error;
  }

  [[nodiscard]] SamplingState state(const ErrorEstimate& error) const {
    SamplingState state{
        .grid = sums_.blocks(), .blocks = {}, .tile_residual = {}, .image_square = error.image.total()};
    for (std::size_t b = 0; b < error.blocks.size(); ++b)
      state.blocks.push_back(
          {.noise = error.blocks[b].noise, .spp = sums_.spp[b], .most_spp = choices_.most_spp});
    for (const SquaredError& tile : error.tiles) state.tile_residual.push_back(std::max(0.0, tile.bias));
    return state;
  }

  /// The reference is filtered for each object as its stimuli are: with the object's change apart from the
  /// light without it, so that its error differs from object to object. Object `first` chooses the strength,
  /// and while it is not good enough the others are not looked at. Else the worst of the others is named,
  /// where the photograph has to be good enough for each of them.
  [[nodiscard]] PhotographJudgement judge(const PhotographJudgement& before, int first,
                                          const std::optional<ErrorTarget>& target) const {
    PhotographJudgement out = before;
    const PhotographHalves sampled = photograph(first, no_filter);
    const auto is_good = [&](int object) { return !target || target->met_by(out.error(object)); };
    std::tie(out.error(first), out.strength) = choose_strength(first, sampled, before.strength);
    if (!is_good(first)) {
      out.not_good_enough = first;
      return out;
    }
    out.not_good_enough = 0;
    for (int k = 1; k <= static_cast<int>(out.errors.size()); ++k) {
      if (k != first) out.error(k) = error_with(k, out.strength, sampled);
      if (choices_.photograph_for_each_object && !is_good(k) &&
          (out.not_good_enough == 0 ||
           out.error(k).image.total() > out.error(out.not_good_enough).image.total()))
        out.not_good_enough = k;
    }
    return out;
  }

  /// The strength with the least estimated error, from `strength` towards weaker ones, and that error.
  [[nodiscard]] std::pair<ErrorEstimate, std::size_t> choose_strength(int object_index,
                                                                      const PhotographHalves& sampled,
                                                                      std::size_t strength) const {
    ErrorEstimate best = error_with(object_index, strength, sampled);
    for (; strength > 0; --strength) {
      ErrorEstimate weaker = error_with(object_index, strength - 1, sampled);
      if (weaker.image.total() >= best.image.total()) break;
      best = std::move(weaker);
    }
    return {std::move(best), strength};
  }

  [[nodiscard]] ErrorEstimate error_with(int object_index, std::size_t strength,
                                         const PhotographHalves& sampled) const {
    return photograph_error(strength == 0 ? sampled : photograph(object_index, choices_.filters[strength]),
                            sampled, scene_.definition.exposure_ev, threads_, sums_.grid.wraps);
  }

  [[nodiscard]] const FilterStrength& filter() const { return choices_.filters[judged_.strength]; }

  /// The sums are gone when it returns.
  [[nodiscard]] PhotographHalves photograph(int object_index, const FilterStrength& strength) const {
    return photograph_halves(truth_sums_of(object_index, strength), scene_.definition.view);
  }

  [[nodiscard]] TruthSums truth_sums_of(int object_index, const FilterStrength& strength) const {
    return truth_sums(sums_, scene_.camera, scene_.light, object_index,
                      {.filter = strength, .threads = threads_});
  }

  const EstimatorChoices choices_;
  const TruthScene scene_;  ///< with the light that is followed
  const std::uint64_t seed_;
  const int threads_;
  const std::shared_ptr<const SeenEmission> seen_;  ///< null: nothing small that emits is in view
  const bool judges_decided_;
  const bool keeps_error_maps_;
  std::optional<PhotographDecision> held_;                  ///< in place of rounds
  std::function<std::shared_ptr<const FrameBase>()> base_;  ///< when it is sampled; empty: none
  std::unique_ptr<const SceneGeometry> scene_geometry_;     ///< until the truth pass is done
  SceneSums sums_;
  PhotographJudgement judged_;
  int object_index_ = 0;
  std::optional<ObjectGeometry> geometry_;
  TruthSums truth_;
  std::array<Image, 2> filtered_;  ///< what the filter changed in the photograph of the object taken
  Savings saved_;                  ///< by stimuli
};

}  // namespace

std::unique_ptr<SceneEstimator> make_fast_estimator(const TruthScene& scene, const EstimateOptions& options) {
  return std::make_unique<FastEstimator>(scene, options);
}

}  // namespace seamline::renderer
