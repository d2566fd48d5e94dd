#include "laboratory/convergence/convergence_width.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "raytracer/common/stopwatch.h"
#include "renderer/picture/composite.h"
#include "stimuli/pictures/difference.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

/// Texels of the panorama in one pixel at the middle of the picture.
double texels_per_pixel(const Camera& camera, int width_px) {
  const double pixel_rad = 2.0 * camera.tan_half_horizontal / camera.width_px;
  return pixel_rad * width_px / (2 * std::numbers::pi);
}

}  // namespace

std::vector<WidthRow> measure_width(const ConvergenceSubject& subject, const TruthSums& truth) {
  const Image reference = reference_image(truth);
  std::vector<WidthRow> rows;
  Progress progress(stimulus_id(subject.stimulus) + " width", depth_widths_px(subject.study).size());
  for (const int width_px : depth_widths_px(subject.study)) {
    WidthRow row{.width_px = width_px, .texels_per_pixel = texels_per_pixel(subject.scene.camera, width_px)};
    const Stopwatch capture_watch;
    const DepthMap map =
        capture_depth(subject.geometry.truth, width_px, subject.stimulus.depth.yaw_texels, subject.threads);
    row.capture_seconds = capture_watch.seconds();
    const Stopwatch mesh_watch;
    const DepthMesh mesh =
        subject_mesh(subject, map, subject.study.depth.mesh, subject.study.depth.mesh_tolerance);
    const Geometry geometry = subject_geometry(subject, mesh);
    row.mesh_seconds = mesh_watch.seconds();
    row.triangles = static_cast<std::int64_t>(mesh.triangles.size());
    const Stopwatch stimulus_watch;
    const StimulusSums sums = render_stimulus(subject.scene, subject.geometry, &geometry, truth,
                                              subject.recipe, subject.pass(truth.spp, subject.study.seed));
    const Image picture = compose(sums).picture;
    row.stimulus_seconds = stimulus_watch.seconds();
    row.rays = sums.rays;
    row.rmse = display_rmse(picture, reference, subject.exposure_ev());
    rows.push_back(row);
    progress.advance(1, fmt::format("W = {}", width_px));
  }
  return rows;
}

}  // namespace seamline::renderer
