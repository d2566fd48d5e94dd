#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace seamline::renderer {

// Bodies that fall on triangles. Metres and seconds; gravity points along -Y.

/// A ball, in the body's own frame.
struct BallShape {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  double radius_m = 0.1;
};

/// The convex hull of points in the body's own frame; they do not lie in one plane.
struct HullShape {
  std::vector<Eigen::Vector3d> points_m;
};

/// What of a body can touch. Its mass is spread evenly over it; how much it is makes no difference, because
/// nothing else moves.
using BodyShape = std::variant<BallShape, HullShape>;

/// What a body falls on: triangles with two sides.
struct Ground {
  std::vector<Eigen::Vector3d> vertices_m;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct PhysicsSettings {
  int steps_per_s = 240;
  double gravity_m_s2 = 9.81;
  double friction = 0.5;              ///< Coulomb's coefficient between body and ground
  double rolling_friction_m = 0.001;  ///< torque against rolling, per newton that presses
  double margin_m = 0.0005;           ///< a body rests so far above the ground, at most twice
};

/// A body inside the ground: how deep, and where in the world.
struct Overlap {
  double depth_m = 0;
  Eigen::Vector3d where_m = Eigen::Vector3d::Zero();
};

/// Where a body is and how it moves.
struct BodyState {
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();  ///< its centre of mass, in the world
  double speed_m_s = 0, spin_rad_s = 0;
  double energy_j_kg = 0;  ///< of motion and height, per kilogram; 0 at rest at y = 0
};

/// Whether Seamline was built with Bullet.
[[nodiscard]] bool has_physics();
/// Throws InputError, naming the package, when it was not.
void require_physics();

/// One body over a ground, in fixed steps, by Bullet: a solver of one thread, no deactivation. The same calls
/// give the same bits.
class RigidWorld {
 public:
  /// The body begins at rest. Throws InputError without Bullet, and where the shape has no volume.
  RigidWorld(Ground ground, const BodyShape& shape, const Eigen::Isometry3d& world_from_body,
             const PhysicsSettings& settings);
  ~RigidWorld();
  RigidWorld(RigidWorld&&) noexcept;
  RigidWorld& operator=(RigidWorld&&) noexcept;

  /// Moves the ground's vertices: its tree is fitted again, not built. What touched is forgotten, because
  /// Bullet would keep points of contact where the ground was.
  void move_ground(std::span<const Eigen::Vector3d> vertices_m);
  /// Puts another ground in its place; the body goes on as it moves.
  void set_ground(Ground ground);
  void step();
  [[nodiscard]] BodyState body() const;
  /// Where the body reaches deepest into the ground; a depth of 0: not at all.
  [[nodiscard]] Overlap deepest_overlap() const;

 private:
  struct Bullet;
  std::unique_ptr<Bullet> bullet_;
};

}  // namespace seamline::renderer
