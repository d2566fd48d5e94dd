#pragma once
#include <Eigen/Geometry>
#include <array>
#include <string_view>

namespace seamline::live {

/// How a generated recording's camera moves. `still`: not. `orbit`: about a vertical line through a point.
/// `sweep`: to its right. `approach`: forwards.
enum class PathKind { still, orbit, sweep, approach };
inline constexpr std::array every_path_kind = {PathKind::still, PathKind::orbit, PathKind::sweep,
                                               PathKind::approach};
[[nodiscard]] std::string_view word(PathKind kind);

struct CameraPath {
  PathKind kind = PathKind::orbit;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< of an orbit
  double angle_deg = 20;                               ///< of an orbit, from the first frame to the last
  double distance_m = 0.3;                             ///< of the other ways
};

/// The pose after a share (0 to 1) of the way that began at `first`: even steps.
[[nodiscard]] Eigen::Isometry3d pose_on_path(const CameraPath& path, const Eigen::Isometry3d& first,
                                             double share);

}  // namespace seamline::live
