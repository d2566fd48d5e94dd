#include "registration/calibration/estimate.h"

namespace seamline::registration {
namespace {

Eigen::Matrix3d crossing(const Eigen::Vector3d& v) {
  Eigen::Matrix3d by;
  by << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return by;
}

/// Of R X + t, by a turn and a step of the pose.
Eigen::Matrix<double, 3, pose_parameters> by_pose(const Eigen::Vector3d& turned_m) {
  Eigen::Matrix<double, 3, pose_parameters> by;
  by << -crossing(turned_m), Eigen::Matrix3d::Identity();
  return by;
}

/// Pixel, and its derivatives by the camera and by the point (Brown's lens, sensors/camera).
struct Pixel {
  Eigen::Vector2d position_px;
  Eigen::Matrix<double, 2, camera_parameters> by_camera;
  Eigen::Matrix<double, 2, 3> by_point;
};

Pixel pixel_of(const sensors::PinholeCamera& camera, const Eigen::Vector3d& point_m) {
  const sensors::LensDistortion& lens = camera.distortion;
  const double x = point_m.x() / point_m.z(), y = point_m.y() / point_m.z(), r2 = x * x + y * y;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = lens.k1 + r2 * (2 * lens.k2 + r2 * 3 * lens.k3);  // of radial, by r^2
  const Eigen::Vector2d bent(x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
                             y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y);
  Eigen::Matrix2d to_pixels, bent_by_ideal;
  to_pixels << camera.fx_px, camera.skew_px, 0, camera.fy_px;
  const double mixed = 2 * x * y * slope + 2 * lens.p1 * x + 2 * lens.p2 * y;
  bent_by_ideal << radial + 2 * x * x * slope + 2 * lens.p1 * y + 6 * lens.p2 * x, mixed, mixed,
      radial + 2 * y * y * slope + 6 * lens.p1 * y + 2 * lens.p2 * x;
  Eigen::Matrix<double, 2, 3> ideal_by_point;
  ideal_by_point << 1, 0, -x, 0, 1, -y;
  ideal_by_point /= point_m.z();
  Eigen::Matrix<double, 2, 5> bent_by_lens;
  bent_by_lens << x * r2, x * r2 * r2, 2 * x * y, r2 + 2 * x * x, x * r2 * r2 * r2, y * r2, y * r2 * r2,
      r2 + 2 * y * y, 2 * x * y, y * r2 * r2 * r2;

  Pixel pixel;
  pixel.position_px = to_pixels * bent + Eigen::Vector2d(camera.cx_px, camera.cy_px);
  pixel.by_camera << bent.x(), 0, 1, 0, Eigen::Matrix<double, 1, 5>::Zero(), 0, bent.y(), 0, 1,
      Eigen::Matrix<double, 1, 5>::Zero();
  pixel.by_camera.rightCols<5>() = to_pixels * bent_by_lens;
  pixel.by_point = to_pixels * bent_by_ideal * ideal_by_point;
  return pixel;
}

}  // namespace

std::optional<Reprojection> reproject(const Estimate& estimate, const SeenPoint& seen) {
  const Eigen::Isometry3d& view = estimate.first_from_view[static_cast<std::size_t>(seen.view)];
  const Eigen::Vector3d turned_m = view.linear() * seen.point_m, first_m = turned_m + view.translation();
  const bool is_second = seen.camera == 1;
  const Eigen::Isometry3d& second = estimate.second_from_first;
  const Eigen::Vector3d point_m = is_second ? Eigen::Vector3d(second * first_m) : first_m;
  if (!(point_m.z() > 0)) return std::nullopt;
  const Pixel pixel = pixel_of(estimate.cameras[static_cast<std::size_t>(seen.camera)], point_m);
  Reprojection reprojection;
  reprojection.position_px = pixel.position_px;
  reprojection.by_camera = pixel.by_camera;
  reprojection.by_second.setZero();
  if (is_second) {
    reprojection.by_second = pixel.by_point * by_pose(second.linear() * first_m);
    reprojection.by_view = pixel.by_point * second.linear() * by_pose(turned_m);
  } else {
    reprojection.by_view = pixel.by_point * by_pose(turned_m);
  }
  return reprojection;
}

sensors::PinholeCamera changed(const sensors::PinholeCamera& camera,
                               const Eigen::Matrix<double, camera_parameters, 1>& by) {
  sensors::PinholeCamera other = camera;
  other.fx_px += by[0];
  other.fy_px += by[1];
  other.cx_px += by[2];
  other.cy_px += by[3];
  other.distortion.k1 += by[4];
  other.distortion.k2 += by[5];
  other.distortion.p1 += by[6];
  other.distortion.p2 += by[7];
  other.distortion.k3 += by[8];
  return other;
}

Eigen::Isometry3d changed(const Eigen::Isometry3d& pose,
                          const Eigen::Matrix<double, pose_parameters, 1>& by) {
  const Eigen::Vector3d turn = by.head<3>();
  const double angle = turn.norm();
  Eigen::Isometry3d other = pose;
  if (angle > 0)
    other.linear() = Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle) * pose.linear())
                         .normalized()
                         .toRotationMatrix();
  other.translation() += by.tail<3>();
  return other;
}

}  // namespace seamline::registration
