#pragma once
#include <functional>
#include <limits>
#include <vector>

#include "registration/frame/registered_frame.h"
#include "sensors/rig/rig.h"
#include "support/arithmetic/random.h"

/// Scenes that are traced by formula, in the frame of the depth camera.
namespace seamline::registration::test {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using sensors::DepthConvention;
using sensors::DepthFrame;
using sensors::PinholeCamera;

/// How far along a ray (in lengths of its direction) the scene is; infinity: nothing.
using Scene = std::function<double(const Vector3d& from_m, const Vector3d& direction)>;

/// The plane a . x = 1.
inline Scene plane(const Vector3d& a) {
  return [a](const Vector3d& from_m, const Vector3d& direction) {
    const double distance = (1 - a.dot(from_m)) / a.dot(direction);
    return distance > 0 ? distance : std::numeric_limits<double>::infinity();
  };
}

/// A wall at `near_m` left of x = 0, before one at `far_m`.
inline Scene step(double near_m, double far_m) {
  return [=](const Vector3d& from_m, const Vector3d& direction) {
    const double to_near = (near_m - from_m.z()) / direction.z();
    if (from_m.x() + to_near * direction.x() < 0) return to_near;
    return (far_m - from_m.z()) / direction.z();
  };
}

/// Planar depth that a camera truly sees through an image position; infinity: nothing.
inline double true_planar_m(const Scene& scene, const PinholeCamera& camera,
                            const Isometry3d& camera_from_depth, const Eigen::Vector2d& position_px) {
  const auto direction = sensors::direction_through(camera, position_px);
  if (!direction) return std::numeric_limits<double>::infinity();
  const Isometry3d depth_from_camera = camera_from_depth.inverse();
  return scene(depth_from_camera.translation(), depth_from_camera.linear() * *direction);
}

inline DepthFrame depth_of(const Scene& scene, const PinholeCamera& camera, DepthConvention convention) {
  DepthFrame frame;
  frame.camera = camera;
  frame.convention = convention;
  for (int row = 0; row < camera.height_px; ++row)
    for (int column = 0; column < camera.width_px; ++column) {
      const Eigen::Vector2d centre(column + 0.5, row + 0.5);
      const auto direction = sensors::direction_through(camera, centre);
      const double planar_m = true_planar_m(scene, camera, Isometry3d::Identity(), centre);
      const double factor = convention == DepthConvention::radial && direction ? direction->norm() : 1;
      frame.depth_m.push_back(static_cast<float>(planar_m * factor));
    }
  return frame;
}

/// A camera with skew and every term of the lens.
inline PinholeCamera crooked(int width_px, int height_px, double field_of_view_deg) {
  PinholeCamera camera = sensors::pinhole_of_field_of_view(width_px, height_px, field_of_view_deg);
  camera.fy_px *= 1.02;
  camera.cx_px += 0.013 * width_px;
  camera.cy_px -= 0.021 * height_px;
  camera.skew_px = 0.004 * width_px;
  camera.distortion = {.k1 = -0.12, .k2 = 0.03, .p1 = 0.0012, .p2 = -0.0007, .k3 = -0.004};
  return camera;
}

inline Isometry3d crooked_pose() {
  return sensors::pose_of({-0.05, 0.02, 0.03}, {0.3, 1, -0.2}, 4);
}

/// Depths that know nothing of each other, every seventh a hole.
inline DepthFrame random_frame(const PinholeCamera& camera, DepthConvention convention) {
  DepthFrame frame;
  frame.camera = camera;
  frame.convention = convention;
  Random random(11);
  for (int i = 0; i < camera.width_px * camera.height_px; ++i)
    frame.depth_m.push_back(i % 7 == 3 ? sensors::hole : static_cast<float>(0.5 + 4 * random.uniform()));
  return frame;
}

}  // namespace seamline::registration::test
