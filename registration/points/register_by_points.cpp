#include "registration/points/register_by_points.h"

#include <cmath>

#include "support/running/parallel.h"

namespace seamline::registration {
namespace {

constexpr std::int64_t outside = -1;

/// The pixel of the colour camera that a point lands in.
std::int64_t pixel_index(const sensors::PinholeCamera& colour, const Eigen::Vector3d& point_m) {
  const auto place_px = sensors::project(colour, point_m);  // NaN is not before the camera
  if (!place_px || !sensors::is_in_picture(colour, *place_px)) return outside;
  return static_cast<std::int64_t>(place_px->y()) * colour.width_px +
         static_cast<std::int64_t>(place_px->x());
}

}  // namespace

RegisteredFrame register_by_points(const sensors::DepthFrame& measured,
                                   const Eigen::Isometry3d& colour_from_depth,
                                   const sensors::PinholeCamera& colour,
                                   std::span<const std::uint8_t> invented, int threads) {
  require_valid(measured, colour_from_depth, colour, invented);
  const std::vector<Eigen::Vector3d> points_m = points_in_colour_frame(measured, colour_from_depth, threads);
  std::vector<std::int64_t> pixels(points_m.size());
  run_parallel(measured.camera.height_px, threads, [&](int row) {
    for (int column = 0; column < measured.camera.width_px; ++column) {
      const std::size_t at = measured.index(column, row);
      pixels[at] = pixel_index(colour, points_m[at]);
    }
  });

  RegisteredFrame registered = empty_frame(colour);
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    if (pixels[i] == outside) continue;
    const auto pixel = static_cast<std::size_t>(pixels[i]);
    const float depth_m = static_cast<float>(points_m[i].z());
    if (!(depth_m > 0) || std::isinf(depth_m)) continue;
    float& nearest_m = registered.frame.depth_m[pixel];
    const std::uint8_t was_invented = invented.empty() ? std::uint8_t{0} : invented[i];
    // Of equals the measured one, so that the order of pixels does not matter.
    const bool wins =
        depth_m < nearest_m || (depth_m == nearest_m && was_invented < registered.invented[pixel]);
    if (!wins) continue;
    nearest_m = depth_m;
    registered.filled[pixel] = 1;
    registered.invented[pixel] = was_invented;
  }
  return registered;
}

}  // namespace seamline::registration
