#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "composites/objects/photo_objects.h"
#include "live/physics/depth_ground.h"

namespace seamline::live {

/// A virtual thing that falls. Its own frame has its origin where its model says `position_m`, turned as the
/// model says.
struct FallingBody {
  std::string name;  ///< for complaints and tables
  renderer::BodyShape shape;
  Eigen::Isometry3d world_from_placed = Eigen::Isometry3d::Identity();  ///< where the model says it is
};

/// The bodies of placed models. Throws InputError as the readers do, and for an object without a volume.
[[nodiscard]] std::vector<FallingBody> falling_bodies(const std::vector<renderer::PlacedModel>& models);

/// Where a body is at the end of a frame's time.
struct BodyPose {
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
  double speed_m_s = 0;  ///< of its centre of mass
  bool is_held = false;  ///< it waits: nothing is seen below it
  int times_let_go = 1;
};

/// Virtual things that fall on the local scenes of a recording's frames. Time is the recording's: the same
/// poses on any machine, for any number of threads. They do not touch each other. A body below whose centre
/// of mass the frame shows no surface (it left the picture, or something came in front of it) waits where it
/// is until there is one again.
class FallingBodies {
 public:
  /// Bodies are let go `drop_m` above where they were placed.
  FallingBodies(std::vector<FallingBody> bodies, DepthGround ground, double drop_m);

  /// Puts the bodies over the first frame. Throws InputError where that has no depth, where a body begins in
  /// a surface (`renderer::require_free_start`) or above none.
  void begin(const DepthPoints& points, const std::vector<float>& depth_m,
             const Eigen::Isometry3d& world_from_colour);
  /// Moves the ground to the next frame's local scene, and the bodies on by so much of the recording's time.
  void advance(const DepthPoints& points, const std::vector<float>& depth_m,
               const Eigen::Isometry3d& world_from_colour, double interval_s);
  /// Lets all bodies go again from where they began.
  void let_go();

  [[nodiscard]] std::span<const BodyPose> poses() const { return poses_; }
  [[nodiscard]] std::span<const FallingBody> bodies() const { return bodies_; }
  /// For each body, from where it was placed to where it is, in the world.
  [[nodiscard]] std::vector<Eigen::Isometry3d> moves() const;
  [[nodiscard]] double simulated_s() const { return simulated_s_; }

 private:
  [[nodiscard]] Eigen::Isometry3d start_of(const FallingBody& body) const;
  void fit_ground(DepthGround::Change change);

  std::vector<FallingBody> bodies_;
  DepthGround ground_;
  double drop_m_;
  renderer::PhysicsSettings settings_;
  std::vector<renderer::RigidWorld> worlds_;  ///< one for each body
  std::vector<BodyPose> poses_;
  double simulated_s_ = 0;
  std::int64_t steps_ = 0;
};

}  // namespace seamline::live
