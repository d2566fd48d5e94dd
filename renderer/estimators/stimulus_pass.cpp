#include "renderer/estimators/stimulus_pass.h"

#include <atomic>
#include <cassert>

#include "renderer/common/parallel.h"
#include "renderer/estimators/stimulus_sampler.h"

namespace seamline::renderer {
namespace {

/// Renders a pixel by the path estimator: every answer traced for every sample, except where the truth's own
/// sums hold just these samples.
class PixelRenderer {
 public:
  explicit PixelRenderer(const StimulusSampler& sampler)
      : sampler_(sampler), recipe_(sampler.recipe()), answers_(recipe_.answers) {}

  /// Adds a pixel to its two sums. `truth` are the same pixel's sums in the truth.
  void render(const PassOptions& options, int x, int y, const std::array<const TruthSums*, 2>& truth,
              const std::array<StimulusSums*, 2>& out, Guide& guide) {
    ids_.clear();
    for (int number = 0; number < options.spp; ++number) ids_.push_back({x, y, number});
    sampler_.look(ids_, samples_, work_);
    sampler_.ask_depth(samples_, parts_, work_);
    bool truth_serves = true;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      truth_serves = truth_serves && as_in_truth(samples_[i]);
      add_depth_part(parts_[i], *out[i % 2]);
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
  static void add_depth_part(const DepthPart& part, StimulusSums& out) {
    out.no += part.no.total();
    out.with += part.with.total();
    out.object += part.object.total();
    out.rest += part.rest;
  }

  /// Whether the truth's own sums hold this sample where the stimulus wants it.
  bool as_in_truth(const StimulusSample& sample) const {
    using Shows = StimulusSample::Shows;
    switch (sample.shows) {
      case Shows::object:
        return sample.covered_in_truth;
      case Shows::rest:
        return !sample.covered_in_truth;
      case Shows::sky:
        return !sample.covered_in_truth && !sample.real;
      case Shows::from_reference:
        return sample.covered_in_truth == (recipe_.keep == Keep::rest_layer);
    }
    return false;
  }

  /// What the truth answers, from the sums of the truth pass.
  void add_truth_sums(const TruthSums& truth, StimulusSums& out) const {
    const Rgb rest = truth.sky + truth.with.total();
    switch (recipe_.keep) {
      case Keep::object_layer:
        out.from_reference += rest;
        add_object(truth.object, out);
        return;
      case Keep::rest_layer:
        out.from_reference += truth.object.total();
        break;
      case Keep::everything:
        add_object(truth.object, out);
        break;
    }
    out.sky += truth.sky;
    out.background += truth.no.total();
    add_rest({truth.no, truth.with}, out);
  }

  void add_object(const Split& light, StimulusSums& out) const {
    if (answers_.object_lit == Who::truth) out.object += light.direct;
    if (answers_.bounce == Who::truth) out.object += light.bounce;
  }

  /// What the truth answers of the light on the rest.
  void add_rest(const RadiancePair& pair, StimulusSums& out) const {
    if (sampler_.direct_from_truth()) {
      out.no += pair.no.direct;
      out.with += pair.with.direct;
    }
    if (answers_.bounce == Who::truth) {
      out.no += pair.no.bounce;
      out.with += pair.with.bounce;
    }
  }

  /// The same, for one sample that the truth pass sorted differently.
  void add_truth_sample(const StimulusSample& sample, StimulusSums& out) {
    switch (sample.shows) {
      case StimulusSample::Shows::object:
        if (answers_.object_lit == Who::truth || answers_.bounce == Who::truth)
          add_object(sampler_.object_in_truth(sample, work_), out);
        return;
      case StimulusSample::Shows::rest: {
        const RadiancePair pair = sampler_.rest_in_truth(sample, work_);
        out.background += pair.no.total();
        add_rest(pair, out);
        return;
      }
      case StimulusSample::Shows::sky:
        out.sky += sample.real ? sampler_.rest_in_truth(sample, work_).no.total()
                               : sampler_.scene().light.environment_radiance;
        return;
      case StimulusSample::Shows::from_reference:
        if (sample.covered_in_truth)
          out.from_reference += sampler_.object_in_truth(sample, work_).total();
        else
          out.from_reference += sample.real ? sampler_.rest_in_truth(sample, work_).with.total()
                                            : sampler_.scene().light.environment_radiance;
        return;
    }
  }

  const StimulusSampler& sampler_;
  const Recipe& recipe_;
  const Answers& answers_;
  std::vector<SampleId> ids_;
  std::vector<StimulusSample> samples_;
  std::vector<DepthPart> parts_;
  SamplingWork work_;
};

}  // namespace

StimulusLayers render_stimulus(const TruthScene& scene, const ObjectGeometry& geometry, const Geometry* depth,
                               const TruthLayers& truth, const Recipe& recipe, const PassOptions& options) {
  assert(truth.spp == options.spp && (depth != nullptr || !recipe.answers.needs_depth()));
  StimulusLayers layers{.width_px = truth.width_px, .height_px = truth.height_px, .spp = options.spp};
  for (auto& half : layers.halves) half.resize(truth.guides.size());
  layers.guides.resize(truth.guides.size());
  layers.depth_lights_rest = depth_lights_rest(recipe.answers);
  const StimulusSampler sampler(scene, geometry, depth, recipe, options.seed);
  std::atomic<std::int64_t> rays = 0;
  const auto row = [&](int y) {
    PixelRenderer pixel(sampler);
    for (int x = 0; x < truth.width_px; ++x) {
      const std::size_t i = truth.index(x, y);
      pixel.render(options, x, y, {&truth.halves[0][i], &truth.halves[1][i]},
                   {&layers.halves[0][i], &layers.halves[1][i]}, layers.guides[i]);
    }
    rays += pixel.counts().traced;
  };
  parallel_for(truth.height_px, options.threads, row, [&](int rows) {
    if (options.progress) options.progress(static_cast<double>(rows) / truth.height_px);
  });
  layers.rays = rays;
  return layers;
}

}  // namespace seamline::renderer
