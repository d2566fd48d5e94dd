#include "laboratory/convergence/convergence_links.h"

#include <algorithm>

#include "raytracer/common/stopwatch.h"
#include "renderer/depth/local_scene.h"
#include "renderer/picture/composite.h"
#include "sensors/rig/presets.h"
#include "stimuli/pictures/difference.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

/// A way to capture depth, and who asks it.
struct Variant {
  std::string link, name;
  DepthSettings settings;
  Recipe recipe;
};

PinholeSource sensor(bool noisy, double aside_m) {
  const auto& rig = std::get<sensors::Rig>(sensors::sensor_preset("tof_640x576", "preset").sensor);
  PinholeSource source;
  source.camera = resized(rig.depth, rig.depth.width_px / 2, rig.depth.height_px / 2);
  source.range = {.nearest_m = 0.25, .farthest_m = 15};
  source.pose.position_m = {aside_m, 0, 0};
  if (!noisy) return source;
  source.noise = SourceNoise{.model = rig.noise, .scale = 1};
  std::visit([](auto& model) { model.range = {}; }, source.noise->model);
  source.convention = sensors::convention_of(source.noise->model);
  return source;
}

/// Every variant, each after the "none" or the first of its link.
class Variants {
 public:
  explicit Variants(const ConvergenceSubject& subject) : subject_(subject) {
    add_sources();
    add_repairs();
    add_registrations();
    add_reductions();
    add_jumps();
    add_occlusions();
  }
  [[nodiscard]] const std::vector<Variant>& list() const { return list_; }

 private:
  void add(const std::string& link, const std::string& name, std::optional<DepthChain> chain) {
    Variant variant{link, name, subject_.stimulus.depth, subject_.recipe};
    variant.settings.chain = std::move(chain);
    if (variant.settings.chain && !is_panorama(*variant.settings.chain)) {
      variant.settings.width_px = camera_of(variant.settings.chain->sources.front())->width_px;
      variant.settings.yaw_texels = 0;
    }
    list_.push_back(std::move(variant));
  }
  static DepthChain chain_of(const DepthSource& source) {
    DepthChain chain;
    chain.sources = {source};
    chain.seed = 1;
    return chain;
  }

  void add_sources() {
    add("source", "panorama", std::nullopt);
    add("source", "pinhole", chain_of(sensor(false, 0)));
    add("noise", "none", chain_of(sensor(false, 0)));
    add("noise", "time_of_flight", chain_of(sensor(true, 0)));
  }
  void add_repairs() {
    for (const sensors::RepairMethod& repair :
         {sensors::RepairMethod(sensors::NoRepair{}), sensors::RepairMethod(sensors::NearestRepair{}),
          sensors::RepairMethod(sensors::MedianRepair{}),
          sensors::RepairMethod(sensors::JointBilateralRepair{}),
          sensors::RepairMethod(sensors::PlaneRepair{})}) {
      DepthChain chain = chain_of(sensor(true, 0));
      chain.repair = repair;
      add("repair", std::string(stimuli::word(repair)), chain);
    }
    DepthChain guided = chain_of(sensor(true, 0));
    guided.repair = sensors::JointBilateralRepair{};
    guided.guide = RepairGuide::photograph;
    add("repair", "joint_bilateral by the photograph", guided);
  }
  void add_registrations() {
    for (const Registration registration : {Registration::none, Registration::points, Registration::mesh}) {
      DepthChain chain = chain_of(sensor(false, 0.06));
      chain.registration = registration;
      add("registration", std::string(word(registration)), chain);
    }
  }
  void add_reductions() {
    constexpr int factor = 4;
    for (const Reduction reduction : {Reduction::sample, Reduction::minimum, Reduction::maximum,
                                      Reduction::median, Reduction::edge_aware, Reduction::boxes}) {
      PanoramaSource source;
      source.reduction = reduction;
      source.reduction_factor = reduction == Reduction::sample ? 1 : factor;
      add("reduction", std::string(word(reduction)), chain_of(source));
    }
  }
  void add_jumps() {
    for (const Jumps jumps : {Jumps::stretch, Jumps::cut, Jumps::layer}) {
      DepthChain chain = chain_of(sensor(false, 0));
      chain.jumps = jumps;
      add("jumps", std::string(stimuli::word(jumps)), chain);
    }
  }
  /// Question 4 alone: by nobody, by the mesh, by a test a pixel.
  void add_occlusions() {
    const auto of = [&](const std::string& name, Occlusion method, Artifact artifact) {
      DepthChain chain;
      chain.occlusion = method;
      add("occlusion", name, chain);
      list_.back().recipe = recipe(artifact, Isolation::query);
    };
    of("none", Occlusion::mesh, Artifact::none);
    of("mesh", Occlusion::mesh, Artifact::occlusion);
    of("depth_test", Occlusion::depth_test, Artifact::occlusion);
    of("depth_buffer", Occlusion::depth_buffer, Artifact::occlusion);
  }

  const ConvergenceSubject& subject_;
  std::vector<Variant> list_;
};

double middle(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace

std::vector<LinkRow> measure_links(const ConvergenceSubject& subject, const TruthSums& truth) {
  constexpr int runs = 3;
  const Image reference = reference_image(truth), background = background_image(truth);
  const Variants variants(subject);
  const std::size_t count = variants.list().size();
  std::vector<LinkRow> rows(count);
  std::vector<std::vector<double>> scene_seconds(count), stimulus_seconds(count);
  Progress progress(stimulus_id(subject.stimulus) + " links", runs * count);
  for (int run = 0; run < runs; ++run)
    for (std::size_t i = 0; i < count; ++i) {
      const Variant& variant = variants.list()[i];
      const Stopwatch scene_watch;
      const LocalScene local = make_local_scene(subject.geometry.truth, variant.settings,
                                                {.albedo = subject.scene.definition.albedo,
                                                 .traces_rays = variant.recipe.answers.traces_depth(),
                                                 .threads = subject.threads,
                                                 .photograph = subject.scene.camera,
                                                 .picture = &background});
      scene_seconds[i].push_back(scene_watch.seconds());
      const Stopwatch stimulus_watch;
      const Image picture =
          compose(render_stimulus(subject.scene, subject.geometry, local.world(), truth, variant.recipe,
                                  subject.pass(truth.spp, subject.study.seed)))
              .picture;
      stimulus_seconds[i].push_back(stimulus_watch.seconds());
      rows[i] = {.link = variant.link,
                 .variant = variant.name,
                 .rmse = display_rmse(picture, reference, subject.exposure_ev()),
                 .scene_seconds = 0,
                 .stimulus_seconds = 0,
                 .triangles = local.mesh.triangles};
      progress.advance(1, variant.link + " " + variant.name);
    }
  for (std::size_t i = 0; i < count; ++i) {
    rows[i].scene_seconds = middle(scene_seconds[i]);
    rows[i].stimulus_seconds = middle(stimulus_seconds[i]);
  }
  return rows;
}

}  // namespace seamline::renderer
