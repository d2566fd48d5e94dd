#include "renderer/depth/occlusion_test.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::renderer {
namespace {

/// The length of a panorama's ray.
double radial_m(const PanoramaSight& sight, const Eigen::Vector3d& direction) {
  const DepthMap& map = sight.map;
  const double column =
      (std::atan2(direction.x(), -direction.z()) / (2 * std::numbers::pi) + 0.5) * map.width_px -
      sight.yaw_texels - 0.5;
  const double row =
      (0.5 - std::asin(std::clamp(direction.y(), -1.0, 1.0)) / std::numbers::pi) * map.height_px - 0.5;
  return static_cast<double>(sensors::linear_between(column, row, [&](int x, int y) {
    return map.at(((x % map.width_px) + map.width_px) % map.width_px, std::clamp(y, 0, map.height_px - 1));
  }));
}

struct Hides {
  const OcclusionTest& test;
  const Eigen::Vector3d direction;
  const double distance_m;

  [[nodiscard]] const sensors::DepthBuffer* buffer() const { return test.buffer ? &*test.buffer : nullptr; }

  bool operator()(const PanoramaSight& sight) const {
    const double real_m = radial_m(sight, direction);
    const double cosine = test.buffer ? direction.dot(test.forward.cast<double>()) : 1;
    return sensors::hides(real_m * cosine, distance_m * cosine, buffer());
  }

  bool operator()(const FrameSight& sight) const {
    const Eigen::Vector3d point_m = sight.frame_from_world * direction * distance_m;
    const auto at_px = sensors::project(sight.frame.camera, point_m);
    if (!at_px || !sensors::is_in_picture(sight.frame.camera, *at_px)) return false;
    const float real_m = sensors::depth_between(sight.frame, at_px->x(), at_px->y());
    return sensors::hides(static_cast<double>(real_m), point_m.z(), buffer());
  }

  bool operator()(const PictureSight& sight) const {
    const ViewedPoint seen = view_point(sight.view, sight.picture, (direction * distance_m).cast<float>());
    const float real_m = depth_at(sight.picture, seen.x_px, seen.y_px);
    return sensors::hides(static_cast<double>(real_m), static_cast<double>(seen.depth_m), buffer());
  }
};

}  // namespace

bool hides(const OcclusionTest& test, const MaskPlace& place, float distance_m) {
  if (test.mask) return mask_at(*test.mask, place) >= 0.5F;
  const Hides asked{test, place.direction.cast<double>().normalized(), static_cast<double>(distance_m)};
  return std::any_of(test.sights.begin(), test.sights.end(),
                     [&](const DepthSight& sight) { return std::visit(asked, sight); });
}

}  // namespace seamline::renderer
