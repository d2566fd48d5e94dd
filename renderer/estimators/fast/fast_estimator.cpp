// The fast estimator: one joint pass for all worlds of a scene, bounce light filtered, the depth mesh asked
// only where and as often as the picture needs it.
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/fast/fast_stimulus.h"
#include "renderer/estimators/fast/scene_layers.h"
#include "renderer/estimators/fast/scene_pass.h"
#include "renderer/picture/error_estimate.h"
#include "renderer/transport/needed_light.h"

namespace seamline::renderer {
namespace {

constexpr int first_spp = 16, most_spp = 1 << 14;
constexpr int tail_every = 4;

/// Sky rays a sample. Beside bounce light, which costs several rays a sample, a second one is worth its
/// price and a third is not; where there is nothing but sky, the camera ray is what they share.
int sky_rays_of(const Light& light) {
  if (light.environment_radiance.isZero(0.0F)) return 1;
  return light.bounces > 0 ? 2 : 8;
}

/// From weak to strong; more samples need less of it.
constexpr std::array<FilterStrength, 6> strengths = {
    {{0, 2.0F}, {1, 5.0F}, {2, 5.0F}, {2, 3.0F}, {2, 2.0F}, {3, 2.0F}}};
constexpr std::size_t first_strength = 4;
/// Of the light that only decides a ratio: few samples, filtered more. Where there is nothing but sky a ratio
/// of few samples is noisiest and its light smoothest: a weaker filter would leave blotches.
FilterStrength ratio_strength_of(const Light& light) {
  return light.bounces > 0 ? FilterStrength{2, 3.0F} : FilterStrength{3, 2.0F};
}

/// Of the error asked for, what the photograph may have. What is left is for the noise that stimuli add: next
/// to nothing, except where bounce light has to be traced for each of them. Of 0.8, 0.85, 0.9 and 0.94 there,
/// 0.9 needs the fewest rays for the paper's set: a better photograph costs more and saves stimuli nothing.
double photograph_share(const EstimateOptions& options) {
  return options.depth_bounces ? 0.9 : 0.985;
}

class FastEstimator : public SceneEstimator {
 public:
  FastEstimator(const TruthScene& scene, const EstimateOptions& options)
      : scene_(with_needed_light(scene, options)),
        options_(options),
        joint_(std::make_unique<const SceneGeometry>(scene_)),
        sums_(empty_sums(scene.camera)) {
    options_.who_is_in_front = options.who_is_in_front || !options.omit.who_is_in_front;
    if (!options.omit.bounce_filter || (scene_.light.bounces == 0 && !joint_->worlds.emits())) strength_ = 0;
  }

  SceneReference reference(const ReportProgress& progress) override {
    sample(progress);
    const Camera& camera = scene_.camera;
    SceneReference out{reference_image(layers_of(1, strengths[strength_])),
                       {camera.width_px, camera.height_px, 1, {}},
                       sums_.rays};
    out.object_ids = click_map(scene_);
    return out;
  }

  void take_object(int object_index, const ReportProgress& progress) override {
    sample(progress);
    geometry_.reset();
    geometry_.emplace(object_geometry(scene_, object_index));
    object_index_ = object_index;
    truth_ = layers_of(object_index, strengths[strength_]);
  }

  [[nodiscard]] const ObjectGeometry& geometry() const override { return *geometry_; }
  [[nodiscard]] const TruthLayers& truth() const override { return truth_; }

  EstimatedStimulus stimulus(const Recipe& recipe, const Geometry* depth,
                             const ReportProgress& progress) override {
    FastStimulusOptions options{
        .seed = options_.seed,
        .threads = options_.threads,
        .tail_every = tail_every_of(options_),
        .omit = options_.omit,
        .filter = strengths[strength_],
        .ratio_filter = options_.omit.bounce_filter ? ratio_strength_of(scene_.light) : strengths[0],
        .progress = progress};
    if (options_.error) options.target = ErrorTarget{*options_.error};
    const ObjectTruth truth{scene_,        sums_,  *geometry_,
                            object_index_, truth_, errors_[static_cast<std::size_t>(object_index_ - 1)]};
    FastStimulus made = render_fast_stimulus(truth, depth, recipe, options);
    add(made.saved);
    return {std::move(made.layers), made.error.rmse(), made.error.worst_tile()};
  }

  [[nodiscard]] Savings savings() const override {
    Savings all = saved_;
    all.omitted += sums_.omitted;
    all.joint_rays = sums_.rays;
    if (options_.who_is_in_front) return all;
    for (const auto& object : sums_.objects)
      for (std::size_t t = 0; t < object.size(); ++t)
        if (object[t])  // a byte a sample
          for (const int block : blocks_of(sums_.grid, static_cast<int>(t)))
            all.order_bytes += sums_.blocks().pixels(block) * sums_.spp[static_cast<std::size_t>(block)];
    return all;
  }

 private:
  static TruthScene with_needed_light(TruthScene scene, const EstimateOptions& options) {
    scene.light = needed_light(scene, options.omit, options.error);
    scene.light.sky_rays = sky_rays_of(scene.light);
    return scene;
  }
  static int tail_every_of(const EstimateOptions& options) {
    return options.omit.path_tails ? tail_every : 1;
  }

  void add(const Savings& stimulus) {
    saved_.omitted += stimulus.omitted;
    saved_.depth_rays += stimulus.depth_rays;
    saved_.stimuli += stimulus.stimuli;
    saved_.ratio_samples += stimulus.ratio_samples;
    saved_.ratio_rays += stimulus.ratio_rays;
    saved_.untouched_blocks += stimulus.untouched_blocks;
    saved_.untouched_rays += stimulus.untouched_rays;
  }

  /// The joint pass: once a scene.
  void sample(const ReportProgress& progress) {
    if (!joint_) return;
    ScenePassOptions options{.seed = options_.seed,
                             .threads = options_.threads,
                             .tail_every = tail_every_of(options_),
                             .who_is_in_front = options_.who_is_in_front,
                             .progress = {}};
    // Rounds are not known beforehand: each takes half of what is left of the progress bar.
    double done = 0, part = options_.error ? 0.5 : 1.0;
    options.progress = [&](double share) {
      if (progress) progress(done + part * share);
    };
    std::vector<int> wanted(sums_.spp.size(), options_.error ? first_spp : std::max(2, options_.spp / 2 * 2));
    add_samples(scene_, *joint_, wanted, options, sums_);
    std::optional<ErrorTarget> target;
    if (options_.error) target = ErrorTarget{*options_.error * photograph_share(options_)};
    for (int judged = 1; (judged = judge(judged, target)) > 0;) {
      wanted = plan_samples(state(errors_[static_cast<std::size_t>(judged - 1)]), *target).next;
      if (wanted == sums_.spp) break;
      done += part;
      part *= 0.5;
      add_samples(scene_, *joint_, wanted, options, sums_);
    }
    joint_.reset();
  }

  [[nodiscard]] SamplingState state(const ErrorEstimate& error) const {
    SamplingState state{
        .grid = sums_.blocks(), .blocks = {}, .tile_rest = {}, .image_square = error.image.total()};
    for (std::size_t b = 0; b < error.blocks.size(); ++b)
      state.blocks.push_back({.noise = error.blocks[b].noise, .spp = sums_.spp[b], .most_spp = most_spp});
    for (const SquaredError& tile : error.tiles) state.tile_rest.push_back(std::max(0.0, tile.bias));
    return state;
  }

  /// The reference is filtered for each object as its stimuli are: with the object's change apart from the
  /// light without it, so that its error differs from object to object. An object whose error is not what is
  /// wanted, `first` before the others, which only count where stimuli have next to nothing for noise of
  /// their own. 0: there is none, or nothing is wanted.
  int judge(int first, const std::optional<ErrorTarget>& target) {
    const std::array<Image, 2> sampled = half_pictures(first, {.levels = 0});
    errors_[static_cast<std::size_t>(first - 1)] = choose_strength(first, sampled);
    if (target && !target->met_by(errors_[static_cast<std::size_t>(first - 1)])) return first;
    int worst = 0;
    for (int k = 1; k <= static_cast<int>(errors_.size()); ++k) {
      ErrorEstimate& error = errors_[static_cast<std::size_t>(k - 1)];
      if (k != first) error = error_with(k, strength_, sampled);
      if (target && !options_.depth_bounces && !target->met_by(error) &&
          (worst == 0 || error.image.total() > errors_[static_cast<std::size_t>(worst - 1)].image.total()))
        worst = k;
    }
    return worst;
  }

  /// Takes the strength with the least estimated error, from the present one towards weaker ones.
  ErrorEstimate choose_strength(int object_index, const std::array<Image, 2>& sampled) {
    ErrorEstimate best = error_with(object_index, strength_, sampled);
    while (strength_ > 0) {
      ErrorEstimate weaker = error_with(object_index, strength_ - 1, sampled);
      if (weaker.image.total() >= best.image.total()) break;
      best = std::move(weaker);
      --strength_;
    }
    return best;
  }

  [[nodiscard]] ErrorEstimate error_with(int object_index, std::size_t strength,
                                         const std::array<Image, 2>& sampled) const {
    return estimate_error(
        {.filtered = strength == 0 ? sampled : half_pictures(object_index, strengths[strength]),
         .sampled = sampled},
        scene_.definition.exposure_ev, options_.threads);
  }

  /// The reference from each half of the samples; the layers are gone when it returns.
  [[nodiscard]] std::array<Image, 2> half_pictures(int object_index, const FilterStrength& strength) const {
    const TruthLayers layers = layers_of(object_index, strength);
    return {half_reference_image(layers, 0), half_reference_image(layers, 1)};
  }

  [[nodiscard]] TruthLayers layers_of(int object_index, const FilterStrength& strength) const {
    return truth_layers(sums_, scene_.camera, scene_.light.environment_radiance, object_index,
                        {.filter = strength, .threads = options_.threads});
  }

  const TruthScene scene_;  ///< with the light that is needed
  EstimateOptions options_;
  std::unique_ptr<const SceneGeometry> joint_;  ///< until the joint pass is done
  SceneSums sums_;
  std::size_t strength_ = first_strength;
  std::array<ErrorEstimate, 3> errors_;  ///< of the reference, filtered for each object
  int object_index_ = 0;
  std::optional<ObjectGeometry> geometry_;
  TruthLayers truth_;
  Savings saved_;  ///< by stimuli
};

}  // namespace

std::unique_ptr<SceneEstimator> make_fast_estimator(const TruthScene& scene, const EstimateOptions& options) {
  return std::make_unique<FastEstimator>(scene, options);
}

}  // namespace seamline::renderer
