#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace seamline {

/// The rotation by the least angle that takes the direction `from` to the direction `to`; of opposite ones
/// about any axis across them. Neither needs unit length, and neither may be 0. The arithmetic is that of
/// Eigen's `FromTwoVectors`, whose opposite case alone takes seconds to compile in every file that asks for
/// it.
[[nodiscard]] Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace seamline
