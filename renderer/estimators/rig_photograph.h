#pragma once
#include <Eigen/Geometry>
#include <functional>

#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"
#include "sensors/camera/pinhole_camera.h"
#include "support/files/image.h"

namespace seamline::renderer {

struct PhotographOptions {
  int spp = 64;
  std::uint64_t seed = 1;
  int threads = 1;
  std::function<void(double share_done)> progress = {};  ///< called on the calling thread
};

/// What a colour camera with a lens sees of a scene, linear radiance, every path traced to its end. Where the
/// lens lets no direction through the picture is black. The same bytes for any number of threads.
[[nodiscard]] Image photograph_scene(const Geometry& scene, const Light& light,
                                     const sensors::PinholeCamera& camera,
                                     const Eigen::Isometry3d& world_from_camera,
                                     const PhotographOptions& options);

/// What a camera at the origin sees, or its eyes around it; a camera of directions of its own may be a
/// panorama.
[[nodiscard]] Image photograph_scene(const Geometry& scene, const Light& light, const Camera& camera,
                                     const PhotographOptions& options);

}  // namespace seamline::renderer
