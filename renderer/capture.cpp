#include "renderer/capture.h"

#include <limits>

#include "renderer/parallel.h"

namespace seamline {

DepthMap capture_depth(const Geometry& geometry, int width_px, int yaw_texels, int threads) {
  DepthMap map{.width_px = width_px, .height_px = width_px / 2, .distance_m = {}};
  map.distance_m.assign(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(map.height_px),
                        std::numeric_limits<float>::infinity());
  parallel_for(map.height_px, threads, [&](int row) {
    for (int column = 0; column < width_px; ++column) {
      const Eigen::Vector3d direction =
          panorama_direction(column + yaw_texels + 0.5, row + 0.5, width_px, map.height_px);
      const auto hit = geometry.nearest({Eigen::Vector3f::Zero(), direction.cast<float>()});
      if (hit)
        map.distance_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
                       static_cast<std::size_t>(column)] = hit->distance_m;
    }
  });
  return map;
}

}  // namespace seamline
