#include "renderer/depth/local_scene.h"

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/panorama_chain.h"
#include "renderer/depth/panorama_layers.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

/// A mesh, and what it was built from as far as the chain's test of who is in front looks at it.
struct Rebuilt {
  DepthMesh mesh;
  std::optional<SensorCounts> counts = {};
  std::optional<ModelRecord> model = {};
  std::optional<DepthErrorRecord> depth_error = {};
  std::vector<DepthSight> sights = {};
};

/// The paper's: an exact panorama, and nothing done to it.
Rebuilt from_exact_panorama(const Geometry& truth, const DepthSettings& settings, bool tests_depth,
                            int threads) {
  DepthMap map = capture_depth(truth, settings.width_px, settings.yaw_texels, threads);
  const MeshOptions options{.density = settings.mesh,
                            .tolerance = settings.mesh_tolerance,
                            .yaw_texels = settings.yaw_texels,
                            .threads = threads};
  if (settings.mitigation.blockers == Blockers::layers) return {.mesh = layered_mesh(truth, map, options)};
  Rebuilt out{.mesh = build_depth_mesh(map, options)};
  if (tests_depth) out.sights.emplace_back(PanoramaSight{std::move(map), settings.yaw_texels});
  return out;
}

Rebuilt from_panorama(const Geometry& truth, const DepthSettings& settings, const LocalSceneUse& use) {
  if (is_budgeted(*settings.chain) && use.budgeted == nullptr)
    throw input_error(
        {.field = "depth.reduction",
         .wanted = "another reduction here: only `render`, `predict` and `composite` spend a budget",
         .found = "\"jumps\" or \"budgeted\""});
  MeasuredPanorama made =
      use.budgeted != nullptr ? std::move(*use.budgeted) : panorama_mesh(truth, settings, use.threads);
  Rebuilt out{.mesh = std::move(made.mesh), .model = made.model, .depth_error = made.depth_error};
  // Samples that are spent unevenly do not count holes by what is there, but by what was asked.
  if (use.budgeted == nullptr) out.counts = made.counts;
  if (use.tests_depth || tests_pixels(settings.chain->occlusion))
    out.sights.emplace_back(PanoramaSight{std::move(made.map), settings.yaw_texels});
  return out;
}

Rebuilt from_sensors(const Geometry& truth, const DepthSettings& settings, const LocalSceneUse& use) {
  if (has_stereo(*settings.chain) && use.stereo == nullptr)
    throw input_error({.field = "depth.source",
                       .wanted = "another source here: only `render` makes the pictures that are matched",
                       .found = "\"stereo\""});
  SeenPhotograph photograph(use.photograph, use.picture);
  photograph.stereo = use.stereo;
  MeasuredMesh made = sensor_mesh(truth, settings, photograph, use.threads);
  Rebuilt out{.mesh = std::move(made.mesh), .counts = made.counts, .depth_error = made.depth_error};
  if (use.tests_depth || tests_pixels(settings.chain->occlusion))
    for (const PlacedFrame& placed : made.frames)
      out.sights.emplace_back(
          FrameSight{sensors::in_convention(placed.frame, sensors::DepthConvention::planar),
                     placed.world_from_frame.linear().transpose()});
  return out;
}

Rebuilt rebuilt(const Geometry& truth, const DepthSettings& settings, const LocalSceneUse& use) {
  if (!settings.chain) return from_exact_panorama(truth, settings, use.tests_depth, use.threads);
  return is_panorama(*settings.chain) ? from_panorama(truth, settings, use)
                                      : from_sensors(truth, settings, use);
}

std::optional<OcclusionTest> occlusion_test(const DepthSettings& settings, const Camera& photograph,
                                            std::vector<DepthSight> sights) {
  if (sights.empty()) return std::nullopt;
  OcclusionTest test{.sights = std::move(sights), .forward = -photograph.axes.col(2)};
  if (settings.chain && settings.chain->occlusion == Occlusion::depth_buffer)
    test.buffer = settings.chain->buffer;
  return test;
}

}  // namespace

std::optional<SensorCounts> count_captured(const Geometry& truth, const DepthSettings& settings,
                                           const Camera& photograph, int threads) {
  if (!settings.chain || is_budgeted(*settings.chain) || has_stereo(*settings.chain)) return std::nullopt;
  return is_panorama(*settings.chain) ? panorama_counts(truth, settings, threads)
                                      : sensor_counts(truth, *settings.chain, photograph, threads);
}

LocalScene make_local_scene(const Geometry& truth, const DepthSettings& settings, const LocalSceneUse& use) {
  Rebuilt made = rebuilt(truth, settings, use);
  const bool in_place = (!settings.chain || is_seen_from_its_place(*settings.chain)) &&
                        settings.mitigation.blockers == Blockers::sheets;
  LocalScene local{Geometry(made.mesh, Rgb::Constant(static_cast<float>(use.albedo)),
                            use.traces_rays || !in_place ? TreeQuality::for_light : TreeQuality::for_few_rays,
                            in_place ? CentreRays::by_table : CentreRays::by_tree),
                   {.triangles = static_cast<std::int64_t>(made.mesh.triangles.size()),
                    .max_relative_error = made.mesh.max_relative_error,
                    .sensor = made.counts,
                    .model = made.model,
                    .depth_error = made.depth_error}};
  (use.tests_depth ? local.realtime_occlusion : local.occlusion) =
      occlusion_test(settings, use.photograph, std::move(made.sights));
  if (use.keeps_triangles) local.triangles = std::make_shared<const DepthMesh>(std::move(made.mesh));
  return local;
}

}  // namespace seamline::renderer
