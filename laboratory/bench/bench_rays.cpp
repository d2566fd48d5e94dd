#include "laboratory/bench/bench_rays.h"

#include <stdexcept>

#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"

namespace seamline::renderer {
namespace {

constexpr int tile_px = 4;
constexpr int vertices = 3;

void record_path(const TruthScene& scene, const Geometry& geometry, const Sampler& sampler,
                 SurfacePoint point, RecordedRays& rays) {
  for (int vertex = 0; vertex < vertices; ++vertex) {
    for (const Sun& sun : scene.light.suns) {
      const Eigen::Vector3f to_sun = direction_to_sun(sun, sampler.point(dimension::sun(vertex)));
      if (vertex == 0 && above_horizon(point, to_sun)) rays.sun.push_back({ray_start(point, to_sun), to_sun});
    }
    const Eigen::Vector3f direction =
        cosine_weighted(point.normal, sampler.point(dimension::direction(vertex)));
    if (!above_horizon(point, direction)) return;
    rays.bounce.push_back({ray_start(point, direction), direction, scene.light.sky_distance_m});
    const std::optional<SurfacePoint> hit = geometry.nearest(rays.bounce.back());
    if (!hit) return;
    point = *hit;
  }
}

}  // namespace

RecordedRays record_rays(const TruthScene& scene, const Geometry& geometry, int tile_row_step) {
  RecordedRays rays;
  const Camera& camera = scene.camera;
  for (int top = 0; top + tile_px <= camera.height_px; top += tile_px)
    for (int left = 0; left + tile_px <= camera.width_px; left += tile_px)
      for (int i = 0; i < tile_px * tile_px; ++i) {
        const int x = left + i % tile_px, y = top + i / tile_px;
        const Sampler sampler(1, x, y, 0);
        rays.primary.push_back(camera_ray(camera, x, y, sampler));
        if (top / tile_px % tile_row_step != 0) continue;
        if (const auto hit = geometry.nearest(rays.primary.back()))
          record_path(scene, geometry, sampler, *hit, rays);
      }
  return rays;
}

SceneDefinition bench_scene(const std::string& name) {
  for (const SceneDefinition& scene : read_study(builtin_study("depth_resolution_isolated")).scenes)
    if (scene.name == name) return scene;
  throw std::logic_error("the isolated study has no scene " + name);
}

}  // namespace seamline::renderer
