#pragma once
// For rigid_world.cpp alone: this header includes Bullet.
#ifdef SEAMLINE_HAS_BULLET
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include <Eigen/Geometry>
#include <memory>
#include <utility>
#include <vector>

#include "physics/rigid_world.h"

namespace seamline::renderer {

[[nodiscard]] btVector3 to_bullet(const Eigen::Vector3d& v);
[[nodiscard]] Eigen::Vector3d from_bullet(const btVector3& v);
[[nodiscard]] btTransform to_bullet(const Eigen::Isometry3d& pose);
[[nodiscard]] Eigen::Isometry3d from_bullet(const btTransform& pose);

/// A shape for Bullet, about the centre of mass and along the principal axes.
struct MassedShape {
  std::unique_ptr<btConvexInternalShape> shape;
  Eigen::Isometry3d body_from_principal = Eigen::Isometry3d::Identity();
  Eigen::Vector3d inertia_m2 = Eigen::Vector3d::Ones();  ///< of a kilogram
  double reach_m = 0;                                    ///< of its farthest point from the centre of mass
  // Of a hull, in the principal frame: corners, the margin inside its surface, and planes of faces, outwards.
  std::vector<Eigen::Vector3d> corners_m;
  std::vector<std::pair<Eigen::Vector3d, double>> faces;
};

/// The hull's faces are moved inwards by the margin, which Bullet adds again on every side. Throws InputError
/// for a shape without a volume.
[[nodiscard]] MassedShape massed(const HullShape& hull, double margin_m);
[[nodiscard]] MassedShape massed(const BallShape& ball, double margin_m);

}  // namespace seamline::renderer
#endif
