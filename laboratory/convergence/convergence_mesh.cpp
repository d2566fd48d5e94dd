#include "laboratory/convergence/convergence_mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "raytracer/common/stopwatch.h"
#include "raytracer/tracing/geometry.h"
#include "raytracer/tracing/ray_device.h"
#include "renderer/picture/composite.h"
#include "stimuli/pictures/difference.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

/// The largest first, each once, the study's own among them.
std::vector<double> tolerances_to_try(std::vector<double> all, double default_tolerance) {
  all.push_back(default_tolerance);
  std::sort(all.rbegin(), all.rend());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Rays a second of one thread: through each pixel's centre, and from what it meets into a direction of the
/// cosine distribution.
double ray_rate(const ConvergenceSubject& subject, const Geometry& geometry) {
  const Camera& camera = subject.scene.camera;
  RayCounts counts;
  const Stopwatch watch;
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Sampler sampler(subject.study.seed, x, y, 0);
      const std::optional<SurfacePoint> seen = geometry.nearest(camera_ray(camera, x, y, sampler), &counts);
      if (!seen) continue;
      const Eigen::Vector3f direction = cosine_weighted(seen->normal, sampler.point(dimension::direction(0)));
      if (above_horizon(*seen, direction))
        (void)geometry.nearest({ray_start(*seen, direction), direction}, &counts);
    }
  return counts.traced / watch.seconds();
}

/// Times of quick builds are the fastest of three, because other programs only ever slow them down.
Geometry build_and_measure(const ConvergenceSubject& subject, MeshRow& row) {
  constexpr double quick_s = 0.3;
  const MeshDensity density = row.tolerance ? MeshDensity::adaptive : MeshDensity::full;
  for (int repeat = 1;; ++repeat) {
    const Stopwatch build_watch;
    const DepthMesh mesh = subject_mesh(subject, subject.map, density, row.tolerance.value_or(0));
    const double build_s = build_watch.seconds();
    const std::int64_t memory_before = RayDevice::instance().memory_bytes();
    const Stopwatch bvh_watch;
    Geometry geometry = subject_geometry(subject, mesh);
    const double bvh_s = bvh_watch.seconds();
    row.build_seconds = repeat == 1 ? build_s : std::min(build_s, row.build_seconds);
    row.bvh_seconds = repeat == 1 ? bvh_s : std::min(bvh_s, row.bvh_seconds);
    row.embree_bytes = RayDevice::instance().memory_bytes() - memory_before;
    row.triangles = static_cast<std::int64_t>(mesh.triangles.size());
    row.mesh_bytes = static_cast<std::int64_t>(mesh.vertices_m.size() * sizeof(mesh.vertices_m[0]) +
                                               mesh.triangles.size() * sizeof(mesh.triangles[0]));
    row.depth_error = mesh.max_relative_error;
    if (repeat == 3 || build_s + bvh_s > quick_s) return geometry;
  }
}

void compare(const ConvergenceSubject& subject, const Image& picture, const Image& full, MeshRow& row) {
  row.rmse = display_rmse(picture, full, subject.exposure_ev());
  const ByteImage a = display_image(picture, subject.exposure_ev());
  const ByteImage b = display_image(full, subject.exposure_ev());
  std::size_t changed = 0;
  const std::size_t pixels = a.values.size() / 3;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    int steps = 0;
    for (std::size_t c = 0; c < 3; ++c)
      steps = std::max(steps, std::abs(int{a.values[3 * pixel + c]} - int{b.values[3 * pixel + c]}));
    changed += steps > 1 ? 1 : 0;
    row.largest_change_steps = std::max(row.largest_change_steps, steps);
  }
  row.changed_share = static_cast<double>(changed) / static_cast<double>(pixels);
}

void judge(MeshResult& result) {
  bool finer_keep = true;
  for (auto row = result.rows.rbegin(); row != result.rows.rend(); ++row) {
    if (!row->tolerance) continue;
    finer_keep = finer_keep && keeps_rule(*row);
    if (finer_keep) result.largest_that_keeps = row->tolerance;
    if (*row->tolerance == result.default_tolerance) result.default_keeps_rule = keeps_rule(*row);
  }
}

}  // namespace

bool keeps_rule(const MeshRow& row) {
  return row.changed_share <= allowed_changed_share && row.largest_change_steps <= allowed_change_steps;
}

MeshResult measure_mesh(const ConvergenceSubject& subject, const TruthSums& truth,
                        const std::vector<double>& tolerances) {
  MeshResult result{.default_tolerance = subject.study.depth.mesh_tolerance};
  const std::vector<double> tried = tolerances_to_try(tolerances, result.default_tolerance);
  Progress progress(stimulus_id(subject.stimulus) + " mesh", tried.size() + 2);
  const auto render = [&](MeshRow& row, double work) {
    const Geometry geometry = build_and_measure(subject, row);
    row.rays_per_second = ray_rate(subject, geometry);
    const StimulusSums sums = render_stimulus(subject.scene, subject.geometry, &geometry, truth,
                                              subject.recipe, subject.pass(truth.spp, subject.study.seed));
    progress.advance(work, row.tolerance ? fmt::format("tolerance {:g}", *row.tolerance) : "full density");
    return compose(sums).picture;
  };
  MeshRow full_row;
  const Image full = render(full_row, 2);
  for (const double tolerance : tried) {
    MeshRow row{.tolerance = tolerance};
    compare(subject, render(row, 1), full, row);
    result.rows.push_back(row);
  }
  result.rows.push_back(full_row);
  judge(result);
  return result;
}

}  // namespace seamline::renderer
