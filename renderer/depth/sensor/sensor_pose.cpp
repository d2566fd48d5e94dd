#include "renderer/depth/sensor/sensor_pose.h"

#include <algorithm>
#include <cmath>

#include "registration/pose/pose.h"
#include "support/arithmetic/units.h"

namespace seamline::renderer {

Eigen::Isometry3d world_from_photograph(const Camera& camera) {
  // Columns right, up, back become right, down, forward; through a quaternion, so that floats end as a
  // rotation.
  Eigen::Matrix3d axes = camera.axes.cast<double>();
  axes.col(1) *= -1;
  axes.col(2) *= -1;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(axes).normalized().toRotationMatrix();
  return pose;
}

sensors::PinholeCamera pinhole_of(const Camera& camera, double largest_focal_px) {
  const double tan_half = static_cast<double>(camera.tan_half_horizontal);
  const double own_focal_px = camera.width_px / (2 * tan_half);
  const double share = std::min(1.0, largest_focal_px / own_focal_px);
  sensors::PinholeCamera pinhole;
  pinhole.width_px = std::max(2, static_cast<int>(std::lround(camera.width_px * share)));
  pinhole.height_px = std::max(2, static_cast<int>(std::lround(camera.height_px * share)));
  pinhole.fx_px = pinhole.fy_px = pinhole.width_px / (2 * tan_half);
  pinhole.cx_px = 0.5 * pinhole.width_px;
  pinhole.cy_px = 0.5 * pinhole.height_px;
  return pinhole;
}

Eigen::Isometry3d photograph_from_sensor(const SensorPose& given) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(given.position_m.data()));
  pose.rotate(Eigen::AngleAxisd(given.rotation_deg[1] * radians_per_degree, Eigen::Vector3d::UnitY()));
  pose.rotate(Eigen::AngleAxisd(given.rotation_deg[0] * radians_per_degree, Eigen::Vector3d::UnitX()));
  pose.rotate(Eigen::AngleAxisd(given.rotation_deg[2] * radians_per_degree, Eigen::Vector3d::UnitZ()));
  return pose;
}

Eigen::Isometry3d believed_photograph_from_sensor(const SensorPose& given, const DepthChain& chain) {
  Eigen::Isometry3d pose = photograph_from_sensor(given);
  pose.pretranslate(Eigen::Vector3d(chain.velocity_m_s.data()) * (chain.delay_ms * 1e-3));
  return registration::with_calibration_error(pose, {.rotation_deg = chain.calibration_error_deg,
                                                     .displacement_m = chain.calibration_error_m,
                                                     .seed = chain.seed});
}

}  // namespace seamline::renderer
