#include "renderer/estimators/stimulus_sampler.h"

#include "raytracer/tracing/surface_point.h"
#include "renderer/estimators/seen_emission.h"
#include "renderer/transport/object_light.h"
#include "renderer/transport/path_batch.h"
#include "renderer/transport/realtime_light.h"
#include "renderer/transport/uncovered_light.h"

namespace seamline::renderer {
namespace {

/// Adds light off the object: its direct part, its bounce part, or both.
void add_uncovered(const RadiancePair& pair, bool direct, bool bounce, DepthLight& out) {
  if (direct) {
    out.without_object.direct += pair.without_object.direct;
    out.with_object.direct += pair.with_object.direct;
  }
  if (bounce) {
    out.without_object.bounce += pair.without_object.bounce;
    out.with_object.bounce += pair.with_object.bounce;
    out.without_object.mirrored += pair.without_object.mirrored;
    out.with_object.mirrored += pair.with_object.mirrored;
  }
}

bool is_nearer(const SurfacePoint& object, const std::optional<SurfacePoint>& other) {
  return !other || object.distance_m < other->distance_m;
}

}  // namespace

bool is_in_front(const DepthWorld& depth, const MaskPlace& place, const SurfacePoint& object,
                 const std::optional<SurfacePoint>& on_mesh) {
  if (depth.occlusion == nullptr) return is_nearer(object, on_mesh);
  return !hides(*depth.occlusion, place, object.distance_m);
}

StimulusSampler::StimulusSampler(const TruthScene& scene, const ObjectGeometry& geometry,
                                 const DepthWorld& depth, const Recipe& recipe, std::uint64_t seed,
                                 const LightSampling& sampling)
    : scene_(scene),
      geometry_(geometry),
      depth_(needs_mesh(recipe.answers, depth) ? depth.mesh : nullptr),
      occlusion_(depth.occlusion),
      looks_in_photograph_((depth.occlusion != nullptr && depth.occlusion->mask) ||
                           (depth.matte != nullptr && depth.matte->of_all_suns != nullptr)),
      matte_(recipe.answers.real_lit == Who::depth ? depth.matte : nullptr),
      realtime_(depth.realtime),
      recipe_(recipe),
      answers_(recipe.answers),
      depth_worlds_{depth_, &geometry.object, {}, 1},
      seed_(seed),
      sampling_(sampling) {}

void StimulusSampler::look(std::span<const SampleId> ids, std::vector<StimulusSample>& out,
                           SamplingWork& work) const {
  out.clear();
  std::array<Ray, rays_a_call> rays;
  std::array<std::optional<SurfacePoint>, rays_a_call> real, object, depth;
  for (std::size_t first = 0; first < ids.size(); first += rays_a_call) {
    const std::span<const SampleId> some = ids.subspan(first, std::min(rays_a_call, ids.size() - first));
    const std::size_t count = some.size();
    const std::span<const Ray> asked(rays.data(), count);
    for (std::size_t i = 0; i < count; ++i)
      rays[i] = camera_ray(scene_.camera, some[i].x, some[i].y, sampler_of(some[i]));
    nearest_seen(scene_.camera, geometry_.truth, asked, std::span(real.data(), count), &work.counts_);
    nearest_seen(scene_.camera, geometry_.object, asked, std::span(object.data(), count), &work.counts_);
    if (depth_ != nullptr)
      nearest_seen(scene_.camera, *depth_, asked, std::span(depth.data(), count), &work.counts_);
    for (std::size_t i = 0; i < count; ++i) {
      StimulusSample sample{.number = some[i].number,
                            .x = some[i].x,
                            .y = some[i].y,
                            .sampler = sampler_of(some[i]),
                            .real = real[i],
                            .object = object[i],
                            .depth = depth[i]};
      if (realtime_ != nullptr) override_normals(sample);
      sample.covered_in_truth = sample.object && is_nearer(*sample.object, sample.real);
      sample.covered_in_depth = answers_.occlusion == Who::depth && sample.object &&
                                is_in_front({depth_, occlusion_}, {rays[i].direction, place_of(sample)},
                                            *sample.object, sample.depth);
      if (sampling_.seen != nullptr) even_out(sample);
      sample.shows = shown(sample);
      out.push_back(sample);
    }
  }
}

void StimulusSampler::even_out(StimulusSample& sample) const {
  const SurfacePoint* front = sample.covered_in_truth ? &*sample.object
                              : sample.real           ? &*sample.real
                                                      : nullptr;
  if (front == nullptr) return;
  const int first = front->object_index;
  if (sample.real) sampling_.seen->even_out(sample.x, sample.y, first, *sample.real);
  if (sample.covered_in_truth) sampling_.seen->even_out(sample.x, sample.y, first, *sample.object);
}

/// Gives the depth mesh's point the normal that a method says.
void StimulusSampler::override_normals(StimulusSample& sample) const {
  if (!sample.depth) return;
  if (realtime_->pipeline.normals == PipelineNormals::truth && sample.real)
    sample.depth->normal = sample.real->normal;
  if (!realtime_->normals) return;
  const Eigen::Vector3f& normal = realtime_->normals->at(sample.x, sample.y);
  if (!normal.isZero()) sample.depth->normal = normal;
}

StimulusSample::Shows StimulusSampler::shown(const StimulusSample& sample) const {
  using Shows = StimulusSample::Shows;
  const bool covered = answers_.occlusion == Who::depth ? sample.covered_in_depth : sample.covered_in_truth;
  // Where the truth shows sky, or the depth mesh does and has to answer off the object, nothing is
  // multiplied.
  const Shows uncovered =
      !sample.real || (asks_depth_off_object(answers_) && !sample.depth) ? Shows::sky : Shows::uncovered;
  // Object and surroundings are exchanged sample by sample, so that they always make one whole picture: a
  // sample whose coverage truth and depth mesh disagree about would show an occlusion artifact, and comes
  // from the reference.
  switch (recipe_.keep) {
    case Keep::everything:
      return covered ? Shows::object : uncovered;
    case Keep::object_only:
      return covered && sample.covered_in_truth ? Shows::object : Shows::from_reference;
    case Keep::all_but_object:
      return covered || sample.covered_in_truth ? Shows::from_reference : uncovered;
  }
  return uncovered;
}

RealQuestion StimulusSampler::ask(Who who, const StimulusSample& sample, const SurfacePoint& point) const {
  if (who == Who::truth) return {&geometry_.truth, &point};
  return asked_of_mesh(depth_, sample.depth, point);
}

Split StimulusSampler::object_light(const StimulusSample& sample, const Answers& answers,
                                    SamplingWork& work) const {
  const SurfacePoint& point = *sample.object;
  return leaving_object({ask(answers.object_lit, sample, point), ask(answers.bounce, sample, point),
                         ask(answers.mirrored, sample, point)},
                        geometry_.object, point, scene_.light, sample.sampler, &work.counts_);
}

Split StimulusSampler::object_in_truth(const StimulusSample& sample, SamplingWork& work) const {
  return object_light(sample, {}, work);
}

RadiancePair StimulusSampler::uncovered_in_truth(const StimulusSample& sample, SamplingWork& work) const {
  return radiance_with_and_without(geometry_.truth, &geometry_.object, *sample.real, scene_.light,
                                   sample.sampler, &work.counts_);
}

void StimulusSampler::ask_depth(std::span<const StimulusSample> samples, std::vector<DepthLight>& lights,
                                SamplingWork& work) const {
  lights.assign(samples.size(), {});
  add_direct_on_object(samples, lights, work);
  add_direct_on_uncovered(samples, lights, work);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].shows == StimulusSample::Shows::uncovered) lights[i].uncovered_surfaces = 1.0F;
  // Bounce light of the truth, and what the truth mirrors, is in the truth's sums already.
  if (answers_.bounce == Who::truth && !asks_for_mirror()) return;
  if (sampling_.may_filter) follow_paths(samples, lights, work);
  for (std::size_t i = 0; i < samples.size(); ++i) add_one_path(samples[i], lights[i], work);
}

void StimulusSampler::add_direct_on_object(std::span<const StimulusSample> samples,
                                           std::span<DepthLight> lights, SamplingWork& work) const {
  if (!adds_to_object(answers_) && !methods_light_object()) return;  // or it is found with its bounce light
  using Shows = StimulusSample::Shows;
  std::vector<ObjectPoint>& points = work.object_points_;
  std::vector<Rgb>& lit = work.lit_object_;
  const auto answer = [&](Who who, auto asked, auto take) {
    points.clear();
    for (const StimulusSample& sample : samples)
      if (sample.shows == Shows::object && asked(sample))
        points.push_back({&*sample.object, ask(who, sample, *sample.object), sample.sampler});
    lit.resize(points.size());
    if (who == Who::depth && methods_light())
      realtime_on_object(points, geometry_.object, *realtime_, lit, work.light_rays_, &work.counts_);
    else
      direct_on_object(points, geometry_.object, scene_.light, lit, work.light_rays_, &work.counts_);
    std::size_t next = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].shows == Shows::object && asked(samples[i])) take(lights[i]) = lit[next++];
  };
  answer(
      Who::depth, [](const StimulusSample&) { return true; },
      [](DepthLight& light) -> Rgb& { return light.object.direct; });
  answer(
      Who::truth, [](const StimulusSample& sample) { return sample.is_paired_with_truth; },
      [](DepthLight& light) -> Rgb& { return light.object_in_truth; });
}

void StimulusSampler::add_direct_on_uncovered(std::span<const StimulusSample> samples,
                                              std::span<DepthLight> lights, SamplingWork& work) const {
  if (direct_from_truth() || (uncovered_is_one_path() && !path_leaves_suns_to_matte())) return;
  std::vector<UncoveredPoint>& points = work.uncovered_points_;
  std::vector<RadiancePair>& lit = work.lit_uncovered_;
  points.clear();
  for (const StimulusSample& sample : samples) {
    if (sample.shows != StimulusSample::Shows::uncovered) continue;
    points.push_back({.receiver = answers_.receiver == Who::depth ? &*sample.depth : &*sample.real,
                      .lit = answers_.real_lit == Who::depth ? RealQuestion{depth_, &*sample.depth}
                                                             : RealQuestion{&geometry_.truth, &*sample.real},
                      .shaded_as = answers_.bounce == Who::depth ? &*sample.depth : &*sample.real,
                      .sampler = sample.sampler,
                      .in_photograph = place_of(sample)});
  }
  lit.assign(points.size(), {});
  if (path_leaves_suns_to_matte())
    add_suns_by_matte(points, geometry_.object, scene_.light, *matte_, lit, work.light_rays_, &work.counts_);
  else if (methods_light())
    realtime_on_uncovered(points, geometry_.object, *realtime_, answers_, lit, work.light_rays_,
                          &work.counts_);
  else
    direct_on_uncovered(points, geometry_.object, scene_.light, lit, work.light_rays_, &work.counts_, matte_);
  std::size_t next = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].shows != StimulusSample::Shows::uncovered) continue;
    RadiancePair& pair = lit[next++];
    if (!sampling_.may_filter)
      pair = {.without_object = {pair.without_object.total(), Rgb::Zero()},
              .with_object = {pair.with_object.total(), Rgb::Zero()}};
    add_uncovered(pair, true, true, lights[i]);
  }
}

bool StimulusSampler::is_batched(const StimulusSample& sample) const {
  if (!sampling_.may_filter || answers_.bounce == Who::truth) return false;
  if (sample.shows == StimulusSample::Shows::uncovered) return true;
  // Every question of such a path is the depth mesh's, asked from the object itself.
  return sample.shows == StimulusSample::Shows::object && answers_.object_lit == Who::depth &&
         (answers_.mirrored == Who::depth || !is_glossy(scatterer(*sample.object))) &&
         ask(Who::depth, sample, *sample.object).start == &*sample.object;
}

PathRules StimulusSampler::uncovered_rules(const Sampler& sampler) const {
  PathRules rules = path_rules(sampler, sampling_.tail_every,
                               uncovered_is_one_path() ? FirstSky::bounce : FirstSky::direct);
  rules.without_first_suns = path_leaves_suns_to_matte();
  return rules;
}

void StimulusSampler::follow_paths(std::span<const StimulusSample> samples, std::span<DepthLight> lights,
                                   SamplingWork& work) const {
  const bool direct = uncovered_is_one_path();
  PathBatch& paths = work.paths_;
  paths.begin(depth_worlds_, scene_.light);
  for (const StimulusSample& sample : samples) {
    if (!is_batched(sample)) continue;
    if (sample.shows == StimulusSample::Shows::uncovered)
      paths.add({depth_worlds_.all(), *sample.depth, sample.sampler, uncovered_rules(sample.sampler)});
    else
      paths.add(
          {only_world(0), *sample.object, sample.sampler, path_rules(sample.sampler, sampling_.tail_every)});
  }
  const std::span<const PathLight> found = paths.trace();
  std::size_t next = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_batched(samples[i])) continue;
    const PathLight& path = found[next++];
    if (samples[i].shows == StimulusSample::Shows::uncovered) {
      lights[i].reach_m = path.reach_m;
      add_uncovered({.without_object = path.light[1], .with_object = path.light[0]}, direct, !is_dark_layer(),
                    lights[i]);
    } else {
      const Rgb direct_light = lights[i].object.direct;
      lights[i].object += path.light[0];
      if (methods_light_object()) lights[i].object.direct = direct_light;
    }
  }
}

void StimulusSampler::add_one_path(const StimulusSample& sample, DepthLight& out, SamplingWork& work) const {
  if (is_batched(sample)) return;
  if (sample.shows == StimulusSample::Shows::uncovered && answers_.bounce == Who::depth)
    add_uncovered(radiance_with_and_without(*depth_, &geometry_.object, *sample.depth, scene_.light,
                                            sample.sampler, &work.counts_),
                  uncovered_is_one_path(), !is_dark_layer(), out);
  if (sample.shows != StimulusSample::Shows::object) return;
  if (answers_.bounce == Who::truth && !is_glossy(scatterer(*sample.object))) return;
  const Split light = object_light(sample, answers_, work);
  // With bounce light of the truth, what comes past the depth mesh was found by `direct_on_object`.
  if (answers_.bounce == Who::depth) {
    if (answers_.object_lit == Who::depth && !methods_light()) out.object.direct += light.direct;
    out.object.bounce += light.bounce;
  }
  if (answers_.mirrored == Who::depth) out.object.mirrored += light.mirrored;
}

}  // namespace seamline::renderer
