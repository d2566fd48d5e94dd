#include "renderer/depth/local_scene.h"

#include "renderer/depth/capture.h"

namespace seamline::renderer {

LocalScene make_local_scene(const Geometry& truth, const DepthSettings& settings, const LocalSceneUse& use) {
  const DepthMesh mesh =
      build_depth_mesh(capture_depth(truth, settings.width_px, settings.yaw_texels, use.threads),
                       {.density = settings.mesh,
                        .tolerance = settings.mesh_tolerance,
                        .yaw_texels = settings.yaw_texels,
                        .threads = use.threads});
  return {Geometry(mesh, Rgb::Constant(static_cast<float>(use.albedo)),
                   use.traces_rays ? TreeQuality::for_light : TreeQuality::for_few_rays),
          {static_cast<std::int64_t>(mesh.triangles.size()), mesh.max_relative_error}};
}

}  // namespace seamline::renderer
