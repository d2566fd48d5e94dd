#include "renderer/depth/budget/budgeted_panorama.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "renderer/depth/capture.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

/// Even, as wide as the uniform map of so many samples.
int uniform_width_px(std::int64_t samples) {
  return 2 * static_cast<int>(std::sqrt(2 * static_cast<double>(samples)) / 2);
}

MeasuredPanorama uniform_panorama(const Geometry& truth, const DepthSettings& settings, int threads) {
  MeasuredPanorama made{
      .map = capture_depth(truth, settings.width_px, settings.yaw_texels, threads), .mesh = {}, .counts = {}};
  made.mesh = build_depth_mesh(made.map, {.density = settings.mesh,
                                          .tolerance = settings.mesh_tolerance,
                                          .yaw_texels = settings.yaw_texels,
                                          .threads = threads});
  made.counts.holes = std::count_if(made.map.distance_m.begin(), made.map.distance_m.end(), is_hole);
  made.counts.measured = std::ssize(made.map.distance_m) - made.counts.holes;
  return made;
}

}  // namespace

BudgetedMesh spend_samples(const Geometry& truth, std::int64_t samples, const ShownWeights* weights,
                           double yaw_turns, int threads) {
  if (samples < fewest_budgeted_samples)
    throw input_error({.field = "depth samples",
                       .wanted = "at least " + std::to_string(fewest_budgeted_samples) +
                                 ", so that some are left beside the coarse net",
                       .found = std::to_string(samples)});
  const int uniform_px = uniform_width_px(samples);
  const int finest_px = std::min(16384, std::max(2 * uniform_px, std::clamp(16 * uniform_px, 2048, 4096)));
  const double yaw_texels = yaw_turns * finest_px;
  const DepthMap finest = capture_depth(truth, finest_px, yaw_texels, threads);
  DenseSphere sphere = make_dense_sphere(finest, yaw_texels, threads);
  return build_budgeted_mesh(sphere, samples, weights, yaw_turns, threads);
}

MeasuredPanorama budgeted_panorama(const ShownScene& scene, const DepthSettings& settings, bool keeps_map) {
  const auto& source = std::get<PanoramaSource>(settings.chain->sources.front());
  std::optional<ShownWeights> weights;
  if (source.reduction == Reduction::budgeted) {
    weights = where_it_shows(scene);
    if (nothing_shows(*weights)) return uniform_panorama(scene.truth, settings, scene.threads);
  }
  const double yaw_turns = settings.yaw_texels / settings.width_px;
  const std::int64_t samples = std::int64_t{settings.width_px} * (settings.width_px / 2);
  BudgetedMesh spent =
      spend_samples(scene.truth, samples, weights ? &*weights : nullptr, yaw_turns, scene.threads);
  MeasuredPanorama made{.map = {}, .mesh = std::move(spent.mesh), .counts = {}};
  made.counts.measured = spent.measured;
  made.counts.holes = spent.holes;
  if (keeps_map)
    made.map = capture_depth(Geometry(made.mesh, Rgb::Constant(0.5F)), settings.width_px, settings.yaw_texels,
                             scene.threads);
  return made;
}

}  // namespace seamline::renderer
