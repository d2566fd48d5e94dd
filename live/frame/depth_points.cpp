#include "live/frame/depth_points.h"

#include <algorithm>
#include <limits>

#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"

namespace seamline::live {
namespace {

constexpr std::int32_t outside = -1;
constexpr float hole_m = std::numeric_limits<float>::infinity();

}  // namespace

DepthPoints::DepthPoints(const sensors::DepthFileForm& form, const Eigen::Isometry3d& colour_from_depth,
                         int threads)
    : width_px_(form.camera.width_px),
      height_px_(form.camera.height_px),
      colour_from_depth_(colour_from_depth) {
  metre_of_pixel_.resize(width_px_ * static_cast<std::size_t>(height_px_));
  run_parallel(height_px_, threads, [&](int row) {
    for (int column = 0; column < width_px_; ++column) {
      auto direction = sensors::direction_through(form.camera, {column + 0.5, row + 0.5});
      if (direction && form.convention == sensors::DepthConvention::radial) direction->normalize();
      metre_of_pixel_[grid_index(row, column, width_px_)] = direction.value_or(Eigen::Vector3d::Zero());
    }
  });
}

void PointRegistration::operator()(const DepthPoints& points, const std::vector<float>& depth_m, int threads,
                                   renderer::DepthPicture& registered) {
  landings_.resize(depth_m.size());
  const double width = view_.width_px, height = view_.height_px;
  run_parallel(points.height_px(), threads, [&](int row) {
    const std::size_t first = grid_index(row, 0, points.width_px());
    for (std::size_t i = first; i < first + points.width_px(); ++i) {
      landings_[i].pixel = outside;
      if (sensors::DepthFrame::is_hole(depth_m[i]) || !points.has_ray(i)) continue;
      const Eigen::Vector3d point_m = points.point_m(i, depth_m[i]);
      if (!(point_m.z() > 0)) continue;
      const double x = view_.fx_px * (point_m.x() / point_m.z()) + view_.cx_px;
      const double y = view_.fy_px * (point_m.y() / point_m.z()) + view_.cy_px;
      if (!(x >= 0 && x < width && y >= 0 && y < height)) continue;
      landings_[i] = {static_cast<std::int32_t>(y) * view_.width_px + static_cast<std::int32_t>(x),
                      static_cast<float>(point_m.z())};
    }
  });
  std::fill(registered.depth_m.begin(), registered.depth_m.end(), hole_m);
  for (const Landing& landing : landings_) {
    if (landing.pixel == outside) continue;
    float& nearest_m = registered.depth_m[landing.pixel];
    if (landing.depth_m > 0 && landing.depth_m < nearest_m) nearest_m = landing.depth_m;
  }
}

}  // namespace seamline::live
