#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "sensors/camera/pinhole_camera.h"
#include "sensors/noise/measurement.h"

namespace seamline::sensors {

/// A depth camera and a colour camera that are fixed to each other. A point of the depth camera's frame (x
/// right, y down, z forward, metres) is `colour_from_depth * point` in the colour camera's.
struct Rig {
  PinholeCamera depth;
  PinholeCamera colour;
  Eigen::Isometry3d colour_from_depth = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Vector3d> projector_m;  ///< in the depth camera's frame; its shadow has no depth
  NoiseModel noise;
};

/// A scanner that turns: equal angles between columns, all the way round, and between rows. It measures
/// radially from one point; `measure_pixel` is what it makes of each.
struct Scanner {
  int width_px = 6284;
  int height_px = 2618;
  double lowest_elevation_deg = -60;
  double highest_elevation_deg = 90;
  NoiseModel noise;
};

/// The rotation by `angle_deg` about an axis, then the translation: how presets and files write a pose.
[[nodiscard]] Eigen::Isometry3d pose_of(const Eigen::Vector3d& translation_m, const Eigen::Vector3d& axis,
                                        double angle_deg);

/// Throws InputError unless the linear part is a rotation (orthonormal within 1e-6, determinant +1) and all
/// is finite.
void require_rigid(const Eigen::Isometry3d& pose, const std::string& field);

/// Throws InputError naming `where`, field, wanted and found, for a camera, pose, projector or noise model
/// that is none.
void require_valid(const Rig& rig, const std::string& where);
void require_valid(const Scanner& scanner, const std::string& where);

}  // namespace seamline::sensors
