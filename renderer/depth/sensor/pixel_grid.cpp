#include "renderer/depth/sensor/pixel_grid.h"

#include <algorithm>

#include "support/running/parallel.h"

namespace seamline::renderer {

PixelGrid pixel_grid(const PlacedFrame& placed, int threads) {
  const sensors::PinholeCamera& camera = placed.frame.camera;
  PixelGrid grid{.camera = camera, .eye_m = placed.world_from_frame.translation(), .points_m = {}};
  grid.points_m.resize(placed.frame.depth_m.size(),
                       Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity()));
  run_parallel(camera.height_px, threads, [&](int row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const auto point_m = sensors::point_of_pixel(placed.frame, column, row);
      if (!point_m) continue;
      const Eigen::Vector3f in_world_m = (placed.world_from_frame * *point_m).cast<float>();
      if (in_world_m.allFinite()) grid.points_m[grid.index({row, column})] = in_world_m;
    }
  });
  return grid;
}

bool is_jump(double a_m, double b_m, double c_m, double ratio) {
  const auto [near_m, far_m] = std::minmax({a_m, b_m, c_m});
  return far_m > near_m * ratio;
}

}  // namespace seamline::renderer
