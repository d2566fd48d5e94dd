#include "live/recording/camera_path.h"

#include <numbers>

namespace seamline::live {

std::string_view word(PathKind kind) {
  switch (kind) {
    case PathKind::still:
      return "still";
    case PathKind::orbit:
      return "orbit";
    case PathKind::sweep:
      return "sweep";
    case PathKind::approach:
      return "approach";
  }
  return {};
}

Eigen::Isometry3d pose_on_path(const CameraPath& path, const Eigen::Isometry3d& first, double share) {
  Eigen::Isometry3d pose = first;
  switch (path.kind) {
    case PathKind::still:
      break;
    case PathKind::orbit: {
      const double angle_rad = share * path.angle_deg * std::numbers::pi / 180;
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
      pose.linear() = turn * first.linear();
      pose.translation() = path.centre_m + turn * (first.translation() - path.centre_m);
      break;
    }
    case PathKind::sweep:
      pose.translation() += share * path.distance_m * first.linear().col(0);
      break;
    case PathKind::approach:
      pose.translation() += share * path.distance_m * first.linear().col(2);
      break;
  }
  return pose;
}

}  // namespace seamline::live
