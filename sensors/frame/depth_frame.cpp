#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {
namespace {

/// The direction of a pixel's centre, in which one unit is one metre of the convention.
std::optional<Eigen::Vector3d> metre_of_pixel(const DepthFrame& frame, int column, int row) {
  std::optional<Eigen::Vector3d> direction = direction_through(frame.camera, {column + 0.5, row + 0.5});
  if (direction && frame.convention == DepthConvention::radial) direction->normalize();
  return direction;
}

}  // namespace

std::optional<Eigen::Vector3d> point_of_pixel(const DepthFrame& frame, int column, int row) {
  const float depth_m = frame.at(column, row);
  if (DepthFrame::is_hole(depth_m)) return std::nullopt;
  const auto metre = metre_of_pixel(frame, column, row);
  if (!metre) return std::nullopt;
  return *metre * depth_m;
}

DepthFrame in_convention(const DepthFrame& frame, DepthConvention convention) {
  DepthFrame other = frame;
  if (frame.convention == convention) return other;
  other.convention = convention;
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const auto point_m = point_of_pixel(frame, column, row);
      const double value = !point_m                                ? double{hole}
                           : convention == DepthConvention::radial ? point_m->norm()
                                                                   : point_m->z();
      other.depth_m[frame.index(column, row)] = static_cast<float>(value);
    }
  return other;
}

std::int64_t clean_holes(DepthFrame& frame, double nearest_m, double farthest_m) {
  std::int64_t cleaned = 0;
  for (float& depth_m : frame.depth_m) {
    if (DepthFrame::is_hole(depth_m)) continue;
    const double value = depth_m;
    if (value > 0 && value >= nearest_m && value <= farthest_m) continue;
    depth_m = hole;
    ++cleaned;
  }
  return cleaned;
}

}  // namespace seamline::sensors
