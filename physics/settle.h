#pragma once
#include <Eigen/Geometry>
#include <string>

#include "physics/rigid_world.h"

namespace seamline::renderer {

/// Where a body came to rest.
struct Settled {
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
  double seconds = 0;     ///< of the fall
  double moved_m = 0;     ///< of its centre of mass
  double turned_deg = 0;  ///< from how it began
};

/// Lets a body down from where it is, at rest, until it rests: until its centre of mass moves by less than
/// 0.2 mm and it turns by less than 0.1 degrees in half a second.
///
/// Throws InputError naming `what` for a body that begins in the ground (by more than a centimetre, or a
/// tenth of its smallest side), or inside something (the ground shows it nothing but backs, up, down and on
/// all sides); that falls past the ground's lowest point; that does not rest within twenty seconds.
[[nodiscard]] Settled settle(const Ground& ground, const BodyShape& shape,
                             const Eigen::Isometry3d& world_from_body, const PhysicsSettings& settings,
                             const std::string& what);

/// Throws InputError naming `what`, as `settle` does, where a body cannot begin.
void require_free_start(const RigidWorld& world, const Ground& ground, const BodyShape& shape,
                        const std::string& what);

/// The lowest point of a ground, along Y.
[[nodiscard]] double lowest_m(const Ground& ground);

}  // namespace seamline::renderer
