#include "registration/mesh/register_by_mesh.h"

#include <algorithm>
#include <cmath>

#include "registration/mesh/depth_grid.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/number_range.h"

namespace seamline::registration {
namespace {

/// Each worker has hits of its own, which take memory; more than these are not faster.
constexpr int most_workers = 8;

/// What the rays meet of the whole grid.
std::vector<Hit> hits_of(const DepthGrid& grid, const RayGrid& rays, std::size_t pixels, int threads) {
  const int wanted = threads > 0 ? threads : default_thread_count();
  const int workers = std::clamp(std::min(wanted, grid.rows_of_squares()), 1, most_workers);
  std::vector<std::vector<Hit>> hits_of_worker(static_cast<std::size_t>(workers));
  run_parallel(workers, workers, [&](int worker) {
    std::vector<Hit>& hits = hits_of_worker[static_cast<std::size_t>(worker)];
    hits.resize(pixels);
    for (int row = worker; row < grid.rows_of_squares(); row += workers) {
      stop_if_interrupted();
      grid.each_measured(row, [&](const Triangle& triangle) { rays.look_at(triangle, false, hits); });
    }
  });
  std::vector<Hit> best = std::move(hits_of_worker.front());
  for (std::size_t worker = 1; worker < hits_of_worker.size(); ++worker)
    for (std::size_t i = 0; i < pixels; ++i)
      if (hits_of_worker[worker][i].is_better_than(best[i])) best[i] = hits_of_worker[worker][i];
  grid.each_extruded([&](const Triangle& triangle) {
    stop_if_interrupted();
    rays.look_at(triangle, true, best);
  });
  return best;
}

}  // namespace

void require_valid(const MeshRegistration& mesh, const std::string& where) {
  if (!(mesh.jump_ratio > 1) || !std::isfinite(mesh.jump_ratio))
    throw input_error(
        {.field = where + "jump_ratio", .wanted = "a number above 1", .found = number_text(mesh.jump_ratio)});
  constexpr NumberRange extrusion{0, 16384, "px"};
  if (!inside(mesh.border_extrusion_px, extrusion))
    throw input_error({.field = where + "border_extrusion_px",
                       .wanted = range_text("a whole number", extrusion),
                       .found = std::to_string(mesh.border_extrusion_px)});
}

RegisteredFrame register_by_mesh(const sensors::DepthFrame& measured,
                                 const Eigen::Isometry3d& colour_from_depth,
                                 const sensors::PinholeCamera& colour, const MeshRegistration& mesh,
                                 std::span<const std::uint8_t> invented) {
  require_valid(measured, colour_from_depth, colour, invented);
  require_valid(mesh, "registration: ");
  RegisteredFrame registered = empty_frame(colour);
  const DepthGrid grid(measured, colour_from_depth, mesh, invented);
  const std::vector<Hit> hits =
      hits_of(grid, RayGrid(colour, mesh.threads), registered.filled.size(), mesh.threads);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const float depth_m = static_cast<float>(hits[i].planar_m);
    if (!hits[i].met || !(depth_m > 0) || std::isinf(depth_m)) continue;
    registered.frame.depth_m[i] = depth_m;
    registered.filled[i] = 1;
    registered.extruded[i] = hits[i].extruded ? 1 : 0;
    registered.invented[i] = hits[i].invented ? 1 : 0;
  }
  return registered;
}

}  // namespace seamline::registration
