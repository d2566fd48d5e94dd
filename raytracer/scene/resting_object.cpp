#include "raytracer/scene/resting_object.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/body_shape.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

void add(std::span<const Eigen::Vector3f> positions_m, std::span<const Triangle> triangles,
         const Eigen::Vector3d& offset_m, Ground& ground) {
  const auto first = static_cast<std::uint32_t>(ground.vertices_m.size());
  for (const Eigen::Vector3f& position_m : positions_m)
    ground.vertices_m.emplace_back(position_m.cast<double>() + offset_m);
  for (const Triangle& t : triangles) ground.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Small numbers would be printed as -0.00.
Eigen::Vector3d without_negative_zeros(const Eigen::Vector3d& v, double half_step) {
  return (v.array().abs() < half_step).select(0.0, v);
}

}  // namespace

Ground ground_of(std::span<const std::shared_ptr<const SurfaceMesh>> surfaces,
                 const Eigen::Vector3d& offset_m) {
  Ground ground;
  for (const auto& surface : surfaces) add(surface->positions_m, surface->triangles, offset_m, ground);
  return ground;
}

Ground ground_of(const DepthMesh& mesh, const Eigen::Vector3d& offset_m) {
  Ground ground;
  add(mesh.vertices_m, mesh.triangles, offset_m, ground);
  return ground;
}

std::vector<Eigen::Vector3d> scaled_vertices_m(const SceneFile& file, double scale) {
  std::vector<Eigen::Vector3d> vertices_m;
  for (const FileMesh& mesh : file.meshes)
    for (const Eigen::Vector3d& position : mesh.positions_m) vertices_m.emplace_back(scale * position);
  return vertices_m;
}

RestingObject rested(const SceneFile& file, const Eigen::Affine3d& placement, const Ground& ground,
                     const std::string& what) {
  require_physics();
  const double scale = std::cbrt(placement.linear().determinant());
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
  start.linear() = placement.linear() / scale;
  start.translation() = placement.translation();
  const BodyShape shape = body_shape_of(scaled_vertices_m(file, scale), what);
  RestingObject object;
  object.settled = settle(ground, shape, start, PhysicsSettings{}, what);
  object.placement = object.settled.world_from_body;
  object.placement.scale(scale);
  return object;
}

std::string rest_sentence(const std::string& name, const RestingObject& object) {
  const Eigen::Vector3d at = without_negative_zeros(object.placement.translation(), 5e-5);
  const Eigen::Vector3d turn =
      without_negative_zeros(rotation_deg_of(object.settled.world_from_body.linear()), 5e-3);
  return fmt::format(
      "{} rests after {:.1f} s, {:.3g} m from its place and turned by {:.3g} degrees: position {:.4f} {:.4f} "
      "{:.4f}, rotation {:.2f} {:.2f} {:.2f}",
      printable(name), object.settled.seconds, object.settled.moved_m, object.settled.turned_deg, at.x(),
      at.y(), at.z(), turn.x(), turn.y(), turn.z());
}

Eigen::Vector3d rotation_deg_of(const Eigen::Matrix3d& r) {
  // R = Ry(yaw) Rx(pitch) Rz(roll)
  const double pitch = std::asin(std::clamp(-r(1, 2), -1.0, 1.0));
  const double yaw = std::atan2(r(0, 2), r(2, 2)), roll = std::atan2(r(1, 0), r(1, 1));
  return Eigen::Vector3d(pitch, yaw, roll) * 180 / std::numbers::pi;
}

}  // namespace seamline::renderer
