#include "renderer/stimulus_pass.h"

#include <atomic>
#include <cassert>

#include "renderer/parallel.h"

namespace seamline {
namespace {

/// What the camera ray of one sample meets.
struct Sample {
  Sampler sampler;
  std::optional<SurfacePoint> real;    ///< x_T
  std::optional<SurfacePoint> object;  ///< x_O, at any depth
  std::optional<SurfacePoint> depth;   ///< x_D
  bool covered_in_truth = false;
  enum class Shows { object, rest, sky, from_reference } shows = Shows::rest;
};

bool covers(const Sample& sample, const std::optional<SurfacePoint>& real) {
  return sample.object && (!real || sample.object->distance_m < real->distance_m);
}

class PixelRenderer {
 public:
  PixelRenderer(const TruthScene& scene, const ObjectGeometry& geometry, const Geometry* depth,
                const Recipe& recipe)
      : scene_(scene), geometry_(geometry), depth_(depth), recipe_(recipe), answers_(recipe.answers) {}

  /// Adds a pixel to its two sums. `truth` are the same pixel's sums in the truth.
  void render(const PassOptions& options, int x, int y, const std::array<const TruthSums*, 2>& truth,
              const std::array<StimulusSums*, 2>& out, Guide& guide) {
    samples_.clear();
    bool truth_serves = true;
    for (int i = 0; i < options.spp; ++i) {
      samples_.push_back(look(options, x, y, i));
      truth_serves = truth_serves && as_in_truth(samples_.back());
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) add_depth_part(samples_[i], *out[i % 2]);
    if (truth_serves) {
      for (std::size_t half = 0; half < 2; ++half) add_truth_sums(*truth[half], *out[half]);
    } else {
      for (std::size_t i = 0; i < samples_.size(); ++i) add_truth_sample(samples_[i], *out[i % 2]);
    }
    const auto& seen = answers_.bounce == Who::depth ? samples_.front().depth : samples_.front().real;
    if (seen) guide = {seen->geometric_normal, seen->distance_m};
  }

 private:
  Sample look(const PassOptions& options, int x, int y, int index) const {
    Sample sample{.sampler = Sampler(options.seed, x, y, index), .real = {}, .object = {}, .depth = {}};
    const Ray ray = camera_ray(scene_.camera, x, y, sample.sampler);
    sample.real = geometry_.truth.nearest(ray);
    sample.object = geometry_.object.nearest(ray);
    if (depth_ != nullptr) sample.depth = depth_->nearest(ray);
    sample.covered_in_truth = covers(sample, sample.real);
    sample.shows = shown(sample);
    return sample;
  }

  Sample::Shows shown(const Sample& sample) const {
    using Shows = Sample::Shows;
    const bool covered = covers(sample, answers_.occlusion == Who::depth ? sample.depth : sample.real);
    // Where the truth shows sky, or the depth mesh does and has to answer for the rest, nothing is
    // multiplied.
    const Shows rest =
        !sample.real || (asks_depth_for_rest(answers_) && !sample.depth) ? Shows::sky : Shows::rest;
    // Layers are exchanged sample by sample, so that together they always make one whole picture: a sample
    // whose coverage truth and depth mesh disagree about would show an occlusion artifact, and comes from the
    // reference.
    switch (recipe_.keep) {
      case Keep::everything:
        return covered ? Shows::object : rest;
      case Keep::object_layer:
        return covered && sample.covered_in_truth ? Shows::object : Shows::from_reference;
      case Keep::rest_layer:
        return covered || sample.covered_in_truth ? Shows::from_reference : rest;
    }
    return rest;
  }

  /// Whether the truth's own sums hold this sample where the stimulus wants it.
  bool as_in_truth(const Sample& sample) const {
    using Shows = Sample::Shows;
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

  RealQuestion ask(Who who, const Sample& sample, const SurfacePoint& point) const {
    if (who == Who::truth) return {&geometry_.truth, &point};
    // Behind the depth mesh on its view ray: asked from the mesh's own surface there, or it would be sealed
    // in.
    const bool behind = sample.depth && sample.depth->distance_m < point.distance_m;
    return {depth_, behind ? &*sample.depth : &point};
  }

  Split object_light(const Sample& sample, Who lit, Who bounce) const {
    return leaving_object(ask(lit, sample, *sample.object), ask(bounce, sample, *sample.object),
                          geometry_.object, *sample.object, scene_.light, sample.sampler);
  }
  /// Sun and sky only: bounce light of the truth is in the truth's sums already.
  Split object_direct_light(const Sample& sample) const {
    return leaving_object(ask(Who::depth, sample, *sample.object), {nullptr, nullptr}, geometry_.object,
                          *sample.object, scene_.light, sample.sampler);
  }

  RadiancePair rest_in_truth(const Sample& sample) const {
    return leaving_pair(geometry_.truth, &geometry_.object, *sample.real, scene_.light, sample.sampler);
  }

  bool all_rest_from_depth() const {
    return answers_.receiver == Who::depth && answers_.real_lit == Who::depth &&
           answers_.bounce == Who::depth;
  }
  bool direct_from_truth() const {
    return answers_.receiver == Who::truth && answers_.real_lit == Who::truth;
  }

  /// Everything that some geometry other than the truth alone has to answer; traced for every stimulus.
  void add_depth_part(const Sample& sample, StimulusSums& out) const {
    if (sample.shows == Sample::Shows::object) {
      if (answers_.bounce == Who::depth) {
        const Split light = object_light(sample, answers_.object_lit, Who::depth);
        if (answers_.object_lit == Who::depth) out.object += light.direct;
        out.object += light.bounce;
      } else if (answers_.object_lit == Who::depth) {
        out.object += object_direct_light(sample).direct;
      }
      return;
    }
    if (sample.shows != Sample::Shows::rest) return;
    ++out.rest;
    if (all_rest_from_depth()) {
      add(leaving_pair(*depth_, &geometry_.object, *sample.depth, scene_.light, sample.sampler), true, true,
          out);
      return;
    }
    if (!direct_from_truth()) {
      const SurfacePoint& receiver = answers_.receiver == Who::depth ? *sample.depth : *sample.real;
      const RealQuestion lit = answers_.real_lit == Who::depth
                                   ? RealQuestion{depth_, &*sample.depth}
                                   : RealQuestion{&geometry_.truth, &*sample.real};
      add(direct_pair(receiver, lit, geometry_.object, sample.real->albedo, scene_.light, sample.sampler),
          true, false, out);
    }
    if (answers_.bounce == Who::depth)
      add(leaving_pair(*depth_, &geometry_.object, *sample.depth, scene_.light, sample.sampler), false, true,
          out);
  }

  static void add(const RadiancePair& pair, bool direct, bool bounce, StimulusSums& out) {
    if (direct) {
      out.no.direct += pair.no.direct;
      out.with.direct += pair.with.direct;
    }
    if (bounce) {
      out.no.bounce += pair.no.bounce;
      out.with.bounce += pair.with.bounce;
    }
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
    add({truth.no, truth.with}, direct_from_truth(), answers_.bounce == Who::truth, out);
  }

  void add_object(const Split& light, StimulusSums& out) const {
    if (answers_.object_lit == Who::truth) out.object += light.direct;
    if (answers_.bounce == Who::truth) out.object += light.bounce;
  }

  /// The same, for one sample that the truth pass sorted differently.
  void add_truth_sample(const Sample& sample, StimulusSums& out) const {
    switch (sample.shows) {
      case Sample::Shows::object:
        if (answers_.object_lit == Who::truth || answers_.bounce == Who::truth)
          add_object(object_light(sample, Who::truth, Who::truth), out);
        return;
      case Sample::Shows::rest: {
        const RadiancePair pair = rest_in_truth(sample);
        out.background += pair.no.total();
        add(pair, direct_from_truth(), answers_.bounce == Who::truth, out);
        return;
      }
      case Sample::Shows::sky:
        out.sky += sample.real ? rest_in_truth(sample).no.total() : scene_.light.environment_radiance;
        return;
      case Sample::Shows::from_reference:
        if (sample.covered_in_truth)
          out.from_reference += object_light(sample, Who::truth, Who::truth).total();
        else
          out.from_reference +=
              sample.real ? rest_in_truth(sample).with.total() : scene_.light.environment_radiance;
        return;
    }
  }

  const TruthScene& scene_;
  const ObjectGeometry& geometry_;
  const Geometry* depth_;
  const Recipe& recipe_;
  const Answers& answers_;
  std::vector<Sample> samples_;
};

}  // namespace

StimulusLayers render_stimulus(const TruthScene& scene, const ObjectGeometry& geometry, const Geometry* depth,
                               const TruthLayers& truth, const Recipe& recipe, const PassOptions& options) {
  assert(truth.spp == options.spp && (depth != nullptr || !recipe.answers.needs_depth()));
  StimulusLayers layers{.width_px = truth.width_px, .height_px = truth.height_px, .spp = options.spp};
  for (auto& half : layers.halves) half.resize(truth.guides.size());
  layers.guides.resize(truth.guides.size());
  layers.depth_lights_rest = depth_lights_rest(recipe.answers);
  std::atomic<std::int64_t> rays = 0;
  const auto row = [&](int y) {
    const std::int64_t before = rays_traced_by_this_thread();
    PixelRenderer pixel(scene, geometry, recipe.answers.needs_depth() ? depth : nullptr, recipe);
    for (int x = 0; x < truth.width_px; ++x) {
      const std::size_t i = truth.index(x, y);
      pixel.render(options, x, y, {&truth.halves[0][i], &truth.halves[1][i]},
                   {&layers.halves[0][i], &layers.halves[1][i]}, layers.guides[i]);
    }
    rays += rays_traced_by_this_thread() - before;
  };
  parallel_for(truth.height_px, options.threads, row, [&](int rows) {
    if (options.progress) options.progress(static_cast<double>(rows) / truth.height_px);
  });
  layers.rays = rays;
  return layers;
}

}  // namespace seamline
