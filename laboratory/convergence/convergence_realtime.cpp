#include "laboratory/convergence/convergence_realtime.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "laboratory/convergence/estimates/estimates.h"
#include "raytracer/common/parallel.h"
#include "renderer/depth/local_scene.h"
#include "renderer/estimators/realtime_methods.h"
#include "renderer/estimators/stimulus_sampler.h"
#include "renderer/picture/composite.h"
#include "stimuli/pictures/difference.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

struct Method {
  std::string name, setting;
  Pipeline pipeline;
};

Pipeline mapped(ShadowFilter filter, int width_px) {
  return {.shadows = PipelineShadows::shadow_map, .shadow_filter = filter, .shadow_map_px = width_px};
}

std::vector<Method> methods() {
  std::vector<Method> list = {{"traced", "", {}}};
  for (const ShadowFilter filter : {ShadowFilter::none, ShadowFilter::pcf, ShadowFilter::pcss})
    for (const int width_px : {128, 256, 512, 1024, 2048})
      list.push_back({filter == ShadowFilter::none ? "shadow_map" : std::string(word(filter)),
                      fmt::format("{} px", width_px), mapped(filter, width_px)});
  for (const int count : {1, 4, 16, 64}) {
    Pipeline pipeline = mapped(ShadowFilter::none, 512);
    pipeline.lights = PipelineLights::median_cut;
    pipeline.light_count = count;
    list.push_back({"median_cut", fmt::format("{} lights", count), pipeline});
  }
  for (const int bands : {2, 4, 6})
    list.push_back({"field, 8 shells",
                    fmt::format("{} bands", bands),
                    {.shadows = PipelineShadows::occlusion_field, .field_bands = bands}});
  for (const int shells : {2, 4, 16})
    list.push_back({"field, 4 bands",
                    fmt::format("{} shells", shells),
                    {.shadows = PipelineShadows::occlusion_field, .field_shells = shells}});
  for (const PipelineNormals normals :
       {PipelineNormals::truth, PipelineNormals::cross_products, PipelineNormals::triangle_mean})
    list.push_back({"normals", std::string(word(normals)), {.normals = normals}});
  for (const Occlusion occlusion : {Occlusion::depth_test, Occlusion::ghosts})
    list.push_back({"occlusion", std::string(word(occlusion)), {.occlusion = occlusion}});
  list.push_back({"compositing", "additive", {.compositing = PipelineCompositing::additive}});
  list.push_back({"compositing", "dark_layer", {.compositing = PipelineCompositing::dark_layer}});
  return list;
}

/// Everything but bounce light and what is mirrored.
Recipe direct_light() {
  Recipe recipe;
  recipe.answers = {
      .receiver = Who::depth, .real_lit = Who::depth, .object_lit = Who::depth, .occlusion = Who::depth};
  return recipe;
}

/// One sample of every pixel.
void ask_frame(const ConvergenceSubject& subject, const DepthWorld& world) {
  const Recipe recipe = direct_light();
  const StimulusSampler sampler(subject.scene, subject.geometry, world, recipe, subject.study.seed);
  const Camera& camera = subject.scene.camera;
  parallel_for(camera.height_px, subject.threads, [&](int y) {
    std::vector<SampleId> ids;
    for (int x = 0; x < camera.width_px; ++x) ids.push_back({x, y, 0});
    std::vector<StimulusSample> samples;
    std::vector<DepthLight> lights;
    SamplingWork work;
    sampler.look(ids, samples, work);
    sampler.ask_depth(samples, lights, work);
  });
}

double middle(std::array<double, 3> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[1];
}

}  // namespace

std::vector<RealtimeRow> measure_realtime(const ConvergenceSubject& subject, const TruthSums& truth) {
  constexpr std::size_t runs = 3;
  const std::vector<Method> list = methods();
  LocalScene local = make_local_scene(subject.geometry.truth, subject.stimulus.depth,
                                      {.albedo = subject.scene.definition.albedo,
                                       .threads = subject.threads,
                                       .photograph = subject.scene.camera,
                                       .keeps_triangles = true,
                                       .tests_depth = true});
  const std::optional<OcclusionTest> depth_test = std::move(local.realtime_occlusion);
  const auto world_of = [&](const Pipeline& pipeline) {
    local.realtime.reset();
    local.realtime_occlusion.reset();
    if (pipeline.occlusion == Occlusion::depth_test) local.realtime_occlusion = depth_test;
    if (pipeline != Pipeline{})
      add_realtime_methods(subject.scene, subject.geometry, pipeline, subject.threads, local);
    return local.world();
  };
  const Recipe recipe = direct_light();
  const auto picture = [&](const DepthWorld& world) {
    return compose(render_stimulus(subject.scene, subject.geometry, world, truth, recipe,
                                   subject.pass(truth.spp, subject.study.seed)))
        .picture;
  };
  const Image traced = picture(local.traced_world());
  std::vector<RealtimeRow> rows;
  std::vector<double> rmse(list.size());
  std::vector<std::array<double, runs>> prepare(list.size()), ask(list.size());
  Progress progress(stimulus_id(subject.stimulus) + " realtime", runs * list.size());
  for (std::size_t run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double start_s = processor_seconds();
      const DepthWorld world = world_of(list[i].pipeline);
      prepare[i][run] = list[i].pipeline == Pipeline{} ? 0 : processor_seconds() - start_s;
      const double asked_s = processor_seconds();
      ask_frame(subject, world);
      ask[i][run] = processor_seconds() - asked_s;
      if (run == 0) rmse[i] = display_rmse(picture(world), traced, subject.exposure_ev());
      progress.advance(1, list[i].name + " " + list[i].setting);
    }
  for (std::size_t i = 0; i < list.size(); ++i)
    rows.push_back({.method = list[i].name,
                    .setting = list[i].setting,
                    .rmse = rmse[i],
                    .prepare_seconds = middle(prepare[i]),
                    .ask_seconds = middle(ask[i])});
  return rows;
}

}  // namespace seamline::renderer
