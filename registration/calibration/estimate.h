#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "sensors/camera/pinhole_camera.h"

namespace seamline::registration {

/// What a calibration finds: one camera or two, and where the known points were.
struct Estimate {
  std::vector<sensors::PinholeCamera> cameras;
  Eigen::Isometry3d second_from_first = Eigen::Isometry3d::Identity();  ///< of two cameras
  std::vector<Eigen::Isometry3d> first_from_view;  ///< of each board, or of the one list of points
};

/// A known point and where a camera saw it.
struct SeenPoint {
  int camera = 0, view = 0;
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< in the frame of its view
  Eigen::Vector2d position_px = Eigen::Vector2d::Zero();
};

/// Which of it is unknown besides where the views were.
struct Unknowns {
  bool cameras = true;
  bool second_from_first = false;
};

/// A camera's nine parameters, in this order: fx, fy, cx, cy (pixels), k1, k2, p1, p2, k3. The skew is taken
/// as it is.
inline constexpr int camera_parameters = 9;
/// A pose's six: a small turn about x, y, z of the frame it leads to (radians), then metres along them.
inline constexpr int pose_parameters = 6;

/// A point's place in its camera's picture, and how it changes with each parameter.
struct Reprojection {
  Eigen::Vector2d position_px;
  Eigen::Matrix<double, 2, camera_parameters> by_camera;
  Eigen::Matrix<double, 2, pose_parameters> by_second, by_view;  ///< by_second is 0 for the first camera
};

/// Nothing for a point that is not before the camera. Unlike `sensors::project` it goes on beyond the fold of
/// a lens, where a search may pass.
[[nodiscard]] std::optional<Reprojection> reproject(const Estimate& estimate, const SeenPoint& seen);

/// A camera changed by nine numbers, and a pose by six: R' = exp(turn) R, t' = t + step.
[[nodiscard]] sensors::PinholeCamera changed(const sensors::PinholeCamera& camera,
                                             const Eigen::Matrix<double, camera_parameters, 1>& by);
[[nodiscard]] Eigen::Isometry3d changed(const Eigen::Isometry3d& pose,
                                        const Eigen::Matrix<double, pose_parameters, 1>& by);

/// An estimate and how well it is known. Parameters: nine for each camera where these are unknown, six of
/// `second_from_first` where it is, six for each view.
struct Refined {
  Estimate estimate;
  Unknowns unknowns;
  int points = 0;
  double rms_px = 0;           ///< reprojection error: root of the mean squared distance of a point
  double sigma_px = 0;         ///< s, the noise of one coordinate: s^2 = RSS / (n - p)
  Eigen::MatrixXd covariance;  ///< s^2 (J^T J)^-1

  [[nodiscard]] int first_of_camera(int camera) const { return camera * camera_parameters; }
  [[nodiscard]] int first_of_second() const;
  [[nodiscard]] int first_of_view(int view) const;
};

/// Least squares of the distances in the pictures, from `start` (Levenberg and Marquardt), to where rounding
/// ends it; then the covariance of the parameters from residuals and Jacobian at the solution. Throws
/// InputError naming `what` where the points are no more than the unknowns, where they leave a combination of
/// parameters undetermined, and where the search does not end.
[[nodiscard]] Refined refine(const Estimate& start, const std::vector<SeenPoint>& seen,
                             const Unknowns& unknowns, const std::string& what);

}  // namespace seamline::registration
