#include "renderer/estimators/stimulus_sampler.h"

#include "renderer/tracing/leaving_ray.h"
#include "renderer/transport/object_light.h"
#include "renderer/transport/path_batch.h"
#include "renderer/transport/rest_light.h"

namespace seamline::renderer {
namespace {

/// Adds light on the rest: its direct part, its bounce part, or both.
void add_rest(const RadiancePair& pair, bool direct, bool bounce, DepthPart& out) {
  if (direct) {
    out.no.direct += pair.no.direct;
    out.with.direct += pair.with.direct;
  }
  if (bounce) {
    out.no.bounce += pair.no.bounce;
    out.with.bounce += pair.with.bounce;
  }
}

bool covers(const StimulusSample& sample, const std::optional<SurfacePoint>& real) {
  return sample.object && (!real || sample.object->distance_m < real->distance_m);
}

}  // namespace

StimulusSampler::StimulusSampler(const TruthScene& scene, const ObjectGeometry& geometry,
                                 const Geometry* depth, const Recipe& recipe, std::uint64_t seed,
                                 const LightSampling& sampling)
    : scene_(scene),
      geometry_(geometry),
      depth_(recipe.answers.needs_depth() ? depth : nullptr),
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
    geometry_.truth.nearest_from_centre(asked, std::span(real.data(), count), &work.counts_);
    geometry_.object.nearest_from_centre(asked, std::span(object.data(), count), &work.counts_);
    if (depth_ != nullptr) depth_->nearest_from_centre(asked, std::span(depth.data(), count), &work.counts_);
    for (std::size_t i = 0; i < count; ++i) {
      StimulusSample sample{.number = some[i].number,
                            .sampler = sampler_of(some[i]),
                            .real = real[i],
                            .object = object[i],
                            .depth = depth[i]};
      sample.covered_in_truth = covers(sample, sample.real);
      sample.shows = shown(sample);
      out.push_back(sample);
    }
  }
}

StimulusSample::Shows StimulusSampler::shown(const StimulusSample& sample) const {
  using Shows = StimulusSample::Shows;
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

RealQuestion StimulusSampler::ask(Who who, const StimulusSample& sample, const SurfacePoint& point) const {
  if (who == Who::truth) return {&geometry_.truth, &point};
  // Behind the depth mesh on its view ray: asked from the mesh's own surface there, or it would be sealed in.
  const bool behind = sample.depth && sample.depth->distance_m < point.distance_m;
  return {depth_, behind ? &*sample.depth : &point};
}

Split StimulusSampler::object_light(const StimulusSample& sample, Who lit, Who bounce,
                                    SamplingWork& work) const {
  return leaving_object(ask(lit, sample, *sample.object), ask(bounce, sample, *sample.object),
                        geometry_.object, *sample.object, scene_.light, sample.sampler, &work.counts_);
}

Split StimulusSampler::object_in_truth(const StimulusSample& sample, SamplingWork& work) const {
  return object_light(sample, Who::truth, Who::truth, work);
}

RadiancePair StimulusSampler::rest_in_truth(const StimulusSample& sample, SamplingWork& work) const {
  return leaving_pair(geometry_.truth, &geometry_.object, *sample.real, scene_.light, sample.sampler,
                      &work.counts_);
}

void StimulusSampler::ask_depth(std::span<const StimulusSample> samples, std::vector<DepthPart>& parts,
                                SamplingWork& work) const {
  parts.assign(samples.size(), {});
  add_direct_on_object(samples, parts, work);
  add_direct_on_rest(samples, parts, work);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].shows == StimulusSample::Shows::rest) parts[i].rest = 1.0F;
  if (answers_.bounce == Who::truth) return;  // bounce light of the truth is in the truth's sums already
  if (sampling_.may_filter) follow_paths(samples, parts, work);
  for (std::size_t i = 0; i < samples.size(); ++i) add_one_path(samples[i], parts[i], work);
}

void StimulusSampler::add_direct_on_object(std::span<const StimulusSample> samples,
                                           std::span<DepthPart> parts, SamplingWork& work) const {
  if (!adds_to_object(answers_)) return;  // or it is found with its bounce light
  using Shows = StimulusSample::Shows;
  std::vector<ObjectPoint>& points = work.object_points_;
  std::vector<Rgb>& lit = work.lit_object_;
  const auto answer = [&](Who who, auto asked, auto take) {
    points.clear();
    for (const StimulusSample& sample : samples)
      if (sample.shows == Shows::object && asked(sample))
        points.push_back({&*sample.object, ask(who, sample, *sample.object), sample.sampler});
    lit.resize(points.size());
    direct_on_object(points, geometry_.object, scene_.light, lit, work.light_rays_, &work.counts_);
    std::size_t next = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].shows == Shows::object && asked(samples[i])) take(parts[i]) = lit[next++];
  };
  answer(
      Who::depth, [](const StimulusSample&) { return true; },
      [](DepthPart& part) -> Rgb& { return part.object.direct; });
  answer(
      Who::truth, [](const StimulusSample& sample) { return sample.beside_truth; },
      [](DepthPart& part) -> Rgb& { return part.object_in_truth; });
}

void StimulusSampler::add_direct_on_rest(std::span<const StimulusSample> samples, std::span<DepthPart> parts,
                                         SamplingWork& work) const {
  if (direct_from_truth() || rest_is_one_path()) return;
  std::vector<RestPoint>& points = work.rest_points_;
  std::vector<RadiancePair>& lit = work.lit_rest_;
  points.clear();
  for (const StimulusSample& sample : samples) {
    if (sample.shows != StimulusSample::Shows::rest) continue;
    points.push_back({.receiver = answers_.receiver == Who::depth ? &*sample.depth : &*sample.real,
                      .lit = answers_.real_lit == Who::depth ? RealQuestion{depth_, &*sample.depth}
                                                             : RealQuestion{&geometry_.truth, &*sample.real},
                      .albedo = sample.real->albedo,
                      .sampler = sample.sampler,
                      .emission = sample.real->emission});
  }
  lit.resize(points.size());
  direct_on_rest(points, geometry_.object, scene_.light, lit, work.light_rays_, &work.counts_);
  std::size_t next = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].shows != StimulusSample::Shows::rest) continue;
    RadiancePair& pair = lit[next++];
    if (!sampling_.may_filter)
      pair = {.no = {pair.no.total(), Rgb::Zero()}, .with = {pair.with.total(), Rgb::Zero()}};
    add_rest(pair, true, true, parts[i]);
  }
}

bool StimulusSampler::is_batched(const StimulusSample& sample) const {
  if (!sampling_.may_filter) return false;
  if (sample.shows == StimulusSample::Shows::rest) return true;
  // Every question of such a path is the depth mesh's, asked from the object itself.
  return sample.shows == StimulusSample::Shows::object && answers_.object_lit == Who::depth &&
         ask(Who::depth, sample, *sample.object).start == &*sample.object;
}

void StimulusSampler::follow_paths(std::span<const StimulusSample> samples, std::span<DepthPart> parts,
                                   SamplingWork& work) const {
  const bool direct = rest_is_one_path();
  PathBatch& paths = work.paths_;
  paths.begin(depth_worlds_, scene_.light);
  for (const StimulusSample& sample : samples) {
    if (!is_batched(sample)) continue;
    if (sample.shows == StimulusSample::Shows::rest)
      paths.add({depth_worlds_.all(), *sample.depth, sample.sampler,
                 path_plan(sample.sampler, sampling_.tail_every, direct)});
    else
      paths.add(
          {only_world(0), *sample.object, sample.sampler, path_plan(sample.sampler, sampling_.tail_every)});
  }
  const std::span<const PathLight> found = paths.trace();
  std::size_t next = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_batched(samples[i])) continue;
    const PathLight& path = found[next++];
    if (samples[i].shows == StimulusSample::Shows::rest) {
      parts[i].reach_m = path.reach_m;
      add_rest({.no = path.light[1], .with = path.light[0]}, direct, true, parts[i]);
    } else {
      parts[i].object += path.light[0];
    }
  }
}

void StimulusSampler::add_one_path(const StimulusSample& sample, DepthPart& out, SamplingWork& work) const {
  if (is_batched(sample)) return;
  if (sample.shows == StimulusSample::Shows::rest)
    add_rest(
        leaving_pair(*depth_, &geometry_.object, *sample.depth, scene_.light, sample.sampler, &work.counts_),
        rest_is_one_path(), true, out);
  if (sample.shows != StimulusSample::Shows::object) return;
  const Split light = object_light(sample, answers_.object_lit, Who::depth, work);
  if (answers_.object_lit == Who::depth) out.object.direct += light.direct;
  out.object.bounce += light.bounce;
}

}  // namespace seamline::renderer
