#pragma once
#include <Eigen/Geometry>
#include <string>

#include "support/files/toml_table.h"

namespace seamline::registration {

/// A pose as files write it: `translation_m`, and one of `rotation` (nine numbers, row by row),
/// `quaternion_xyzw`, and `axis` with `angle_deg`, or none for not turned. Throws InputError naming file and
/// key. Whether the nine numbers are a rotation is for `sensors::require_rigid`.
[[nodiscard]] Eigen::Isometry3d read_pose(const TomlTable& table);

/// The table `name` with such a pose, bit for bit.
[[nodiscard]] std::string pose_text(const std::string& name, const Eigen::Isometry3d& pose);

}  // namespace seamline::registration
