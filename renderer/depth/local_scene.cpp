#include "renderer/depth/local_scene.h"

#include "renderer/depth/capture.h"

namespace seamline::renderer {

LocalScene make_local_scene(const Geometry& truth, const Condition& condition,
                            const LocalSceneSettings& settings) {
  const DepthMesh mesh =
      build_depth_mesh(capture_depth(truth, condition.depth_width_px, condition.yaw_texels, settings.threads),
                       {.density = settings.density,
                        .tolerance = settings.tolerance,
                        .yaw_texels = condition.yaw_texels,
                        .threads = settings.threads});
  return {Geometry(mesh, Rgb::Constant(static_cast<float>(settings.albedo)),
                   settings.traces_rays ? TreeQuality::for_light : TreeQuality::for_few_rays),
          {static_cast<std::int64_t>(mesh.triangles.size()), mesh.max_relative_error}};
}

}  // namespace seamline::renderer
