// What stands in place of rigid_world.cpp where Bullet was not found.
#ifndef SEAMLINE_HAS_BULLET
#include "physics/rigid_world.h"
#include "support/text/error.h"

namespace seamline::renderer {

bool has_physics() {
  return false;
}

void require_physics() {
  throw input_error({.field = "falling bodies",
                     .wanted = "Seamline built with Bullet (Debian: libbullet-dev)",
                     .found = "a build without it"});
}

struct RigidWorld::Bullet {};

RigidWorld::RigidWorld(Ground, const BodyShape&, const Eigen::Isometry3d&, const PhysicsSettings&) {
  require_physics();
}
RigidWorld::~RigidWorld() = default;
RigidWorld::RigidWorld(RigidWorld&&) noexcept = default;
RigidWorld& RigidWorld::operator=(RigidWorld&&) noexcept = default;
void RigidWorld::move_ground(std::span<const Eigen::Vector3d>) {}
void RigidWorld::set_ground(Ground) {}
void RigidWorld::step() {}
BodyState RigidWorld::body() const {
  return {};
}
Overlap RigidWorld::deepest_overlap() const {
  return {};
}

}  // namespace seamline::renderer
#endif
