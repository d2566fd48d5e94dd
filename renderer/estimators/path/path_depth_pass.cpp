#include "renderer/estimators/path/path_depth_pass.h"
#include "raytracer/scene/panorama_camera.h"

#include <atomic>
#include <cassert>

#include "raytracer/common/parallel.h"
#include "renderer/estimators/path/path_emission.h"
#include "renderer/estimators/stimulus_sampler.h"
#include "support/running/interrupt.h"

namespace seamline::renderer {
namespace {

/// Renders a pixel by the path estimator: every answer traced for every sample, except where the truth's own
/// sums hold just these samples.
class PixelRenderer {
 public:
  explicit PixelRenderer(const StimulusSampler& sampler)
      : sampler_(sampler), recipe_(sampler.recipe()), answers_(recipe_.answers) {}

  /// Adds a pixel to its two sums. `truth` are the same pixel's sums in the truth.
  void render(const PassOptions& options, int x, int y, const std::array<const TruthPixel*, 2>& truth,
              const std::array<StimulusPixel*, 2>& out, Guide& guide) {
    ids_.clear();
    for (int number = 0; number < options.spp; ++number) ids_.push_back({x, y, number});
    sampler_.look(ids_, samples_, work_);
    sampler_.ask_depth(samples_, lights_, work_);
    bool truth_serves = true;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      truth_serves = truth_serves && as_in_truth(samples_[i]);
      add_depth_light(lights_[i], *out[i % 2]);
    }
    if (truth_serves) {
      for (std::size_t half = 0; half < 2; ++half) add_truth_sums(*truth[half], *out[half]);
    } else {
      for (std::size_t i = 0; i < samples_.size(); ++i) add_truth_sample(samples_[i], *out[i % 2]);
    }
    const auto& seen = answers_.bounce == Who::depth ? samples_.front().depth : samples_.front().real;
    if (seen) guide = {seen->geometric_normal, seen->distance_m};
  }

  [[nodiscard]] RayCounts counts() const { return work_.counts(); }

 private:
  static void add_depth_light(const DepthLight& light, StimulusPixel& out) {
    out.without_object += light.without_object.total();
    out.with_object += light.with_object.total();
    out.object += light.object.total();
    out.uncovered_surfaces += light.uncovered_surfaces;
  }

  /// Whether the truth's own sums hold this sample where the stimulus wants it.
  bool as_in_truth(const StimulusSample& sample) const {
    using Shows = StimulusSample::Shows;
    switch (sample.shows) {
      case Shows::object:
        return sample.covered_in_truth;
      case Shows::uncovered:
        return !sample.covered_in_truth;
      case Shows::sky:
        return !sample.covered_in_truth && !sample.real;
      case Shows::from_reference:
        return sample.covered_in_truth == (recipe_.keep == Keep::all_but_object);
    }
    return false;
  }

  /// What the truth answers, from the sums of the truth pass.
  void add_truth_sums(const TruthPixel& truth, StimulusPixel& out) const {
    const Rgb uncovered = truth.sky + truth.with_object.total();
    switch (recipe_.keep) {
      case Keep::object_only:
        out.from_reference += uncovered;
        add_object(truth.object, out);
        return;
      case Keep::all_but_object:
        out.from_reference += truth.object.total();
        break;
      case Keep::everything:
        add_object(truth.object, out);
        break;
    }
    out.sky += truth.sky;
    out.background += truth.without_object.total();
    add_uncovered({truth.without_object, truth.with_object}, out);
  }

  void add_object(const Split& light, StimulusPixel& out) const {
    if (answers_.object_lit == Who::truth) out.object += light.direct;
    if (answers_.bounce == Who::truth) out.object += light.bounce;
    if (answers_.mirrored == Who::truth) out.object += light.mirrored;
  }

  /// What the truth answers of the light off the object.
  void add_uncovered(const RadiancePair& pair, StimulusPixel& out) const {
    if (sampler_.direct_from_truth()) {
      out.without_object += pair.without_object.direct;
      out.with_object += pair.with_object.direct;
    }
    if (answers_.bounce == Who::truth && !sampler_.is_dark_layer()) {
      out.without_object += pair.without_object.bounce + pair.without_object.mirrored;
      out.with_object += pair.with_object.bounce + pair.with_object.mirrored;
    }
  }

  /// The same, for one sample that the truth pass sorted differently.
  void add_truth_sample(const StimulusSample& sample, StimulusPixel& out) {
    switch (sample.shows) {
      case StimulusSample::Shows::object:
        if (answers_.object_lit == Who::truth || answers_.bounce == Who::truth ||
            answers_.mirrored == Who::truth)
          add_object(sampler_.object_in_truth(sample, work_), out);
        return;
      case StimulusSample::Shows::uncovered: {
        const RadiancePair pair = sampler_.uncovered_in_truth(sample, work_);
        out.background += pair.without_object.total();
        add_uncovered(pair, out);
        return;
      }
      case StimulusSample::Shows::sky:
        out.sky += sample.real ? sampler_.uncovered_in_truth(sample, work_).without_object.total()
                               : sampler_.sky_behind(sample);
        return;
      case StimulusSample::Shows::from_reference:
        if (sample.covered_in_truth)
          out.from_reference += sampler_.object_in_truth(sample, work_).total();
        else
          out.from_reference += sample.real ? sampler_.uncovered_in_truth(sample, work_).with_object.total()
                                            : sampler_.sky_behind(sample);
        return;
    }
  }

  const StimulusSampler& sampler_;
  const Recipe& recipe_;
  const Answers& answers_;
  std::vector<SampleId> ids_;
  std::vector<StimulusSample> samples_;
  std::vector<DepthLight> lights_;
  SamplingWork work_;
};

}  // namespace

StimulusSums render_stimulus(const TruthScene& scene, const ObjectGeometry& geometry, const DepthWorld& depth,
                             const TruthSums& truth, const Recipe& recipe, const PassOptions& options) {
  return render_stimulus(scene, geometry, depth, truth, recipe, options, nullptr);
}

StimulusSums render_stimulus(const TruthScene& scene, const ObjectGeometry& geometry, const DepthWorld& depth,
                             const TruthSums& truth, const Recipe& recipe, const PassOptions& options,
                             const SeenEmission* seen) {
  assert(truth.spp == options.spp && (depth.mesh != nullptr || !needs_mesh(recipe.answers, depth)));
  StimulusSums sums{.width_px = truth.width_px, .height_px = truth.height_px, .spp = options.spp};
  for (auto& half : sums.halves) half.resize(truth.guides.size());
  sums.guides.resize(truth.guides.size());
  const StimulusSampler sampler(scene, geometry, depth, recipe, options.seed, {.seen = seen});
  sums.depth_lights_uncovered = depth_lights_uncovered(recipe.answers) && !sampler.is_dark_layer();
  sums.compositing = sampler.compositing();
  sums.wraps = wraps(scene.camera);
  std::atomic<std::int64_t> rays = 0;
  const auto row = [&](int y) {
    PixelRenderer pixel(sampler);
    for (int x = 0; x < truth.width_px; ++x) {
      stop_if_interrupted();
      const std::size_t i = truth.index(x, y);
      pixel.render(options, x, y, {&truth.halves[0][i], &truth.halves[1][i]},
                   {&sums.halves[0][i], &sums.halves[1][i]}, sums.guides[i]);
    }
    rays += pixel.counts().traced;
  };
  parallel_for(truth.height_px, options.threads, row, [&](int rows) {
    if (options.progress) options.progress(static_cast<double>(rows) / truth.height_px);
  });
  sums.rays = rays;
  return sums;
}

}  // namespace seamline::renderer
