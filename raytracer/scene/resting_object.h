#pragma once
#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <string>

#include "physics/rigid_world.h"
#include "physics/settle.h"
#include "raytracer/scene/scene_file.h"

namespace seamline::renderer {

/// Surfaces as a ground. `offset_m` is added to every vertex: the ground is then in the frame in which bodies
/// are placed.
[[nodiscard]] Ground ground_of(std::span<const std::shared_ptr<const SurfaceMesh>> surfaces,
                               const Eigen::Vector3d& offset_m);
[[nodiscard]] Ground ground_of(const DepthMesh& mesh, const Eigen::Vector3d& offset_m);

/// A file's vertices, scaled: the body's own frame.
[[nodiscard]] std::vector<Eigen::Vector3d> scaled_vertices_m(const SceneFile& file, double scale);

/// Where an object that is placed so comes to rest on a ground: the placement (a turn, one scale, a place)
/// with another turn and place.
struct RestingObject {
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  Settled settled;
};

/// Throws InputError naming `what` as `settle` does.
[[nodiscard]] RestingObject rested(const SceneFile& file, const Eigen::Affine3d& placement,
                                   const Ground& ground, const std::string& what);

/// What became of it, for people: "NAME rests at ..., 0.1 m from its place and turned by 3 degrees".
[[nodiscard]] std::string rest_sentence(const std::string& name, const RestingObject& object);

/// Pitch, yaw and roll in degrees, as `object_placement` takes them.
[[nodiscard]] Eigen::Vector3d rotation_deg_of(const Eigen::Matrix3d& rotation);

}  // namespace seamline::renderer
