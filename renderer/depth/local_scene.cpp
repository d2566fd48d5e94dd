#include "renderer/depth/local_scene.h"

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/panorama_chain.h"

namespace seamline::renderer {
namespace {

/// The paper's: an exact panorama, and nothing done to it.
MeasuredMesh exact_mesh(const Geometry& truth, const DepthSettings& settings, int threads) {
  return {build_depth_mesh(capture_depth(truth, settings.width_px, settings.yaw_texels, threads),
                           {.density = settings.mesh,
                            .tolerance = settings.mesh_tolerance,
                            .yaw_texels = settings.yaw_texels,
                            .threads = threads}),
          {}};
}

}  // namespace

LocalScene make_local_scene(const Geometry& truth, const DepthSettings& settings, const LocalSceneUse& use) {
  const bool has_sensor = settings.chain && !is_panorama(*settings.chain);
  const MeasuredMesh made = !settings.chain ? exact_mesh(truth, settings, use.threads)
                            : has_sensor    ? sensor_mesh(truth, settings, use.photograph, use.threads)
                                            : panorama_mesh(truth, settings, use.threads);
  const bool in_place = !settings.chain || is_seen_from_its_place(*settings.chain);
  return {Geometry(made.mesh, Rgb::Constant(static_cast<float>(use.albedo)),
                   use.traces_rays || !in_place ? TreeQuality::for_light : TreeQuality::for_few_rays,
                   in_place ? CentreRays::by_table : CentreRays::by_tree),
          {.triangles = static_cast<std::int64_t>(made.mesh.triangles.size()),
           .max_relative_error = made.mesh.max_relative_error,
           .sensor = settings.chain ? std::optional(made.counts) : std::nullopt}};
}

}  // namespace seamline::renderer
