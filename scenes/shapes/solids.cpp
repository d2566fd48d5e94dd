#include "scenes/shapes/solids.h"

#include <cmath>
#include <numbers>

namespace seamline::scenes {
namespace {

using Vector2d = Eigen::Vector2d;
using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

Vector3d on_circle(const ProfilePoint& point, double angle_rad) {
  return {point.radius_m * std::sin(angle_rad), point.height_m, point.radius_m * std::cos(angle_rad)};
}

/// One ring of a turned solid between two profile points; its normals lean as the profile's edge does.
void add_ring(TriangleMesh& mesh, const ProfilePoint& low, const ProfilePoint& high, int sides, bool smooth) {
  const Vector2d normal = Vector2d(high.height_m - low.height_m, low.radius_m - high.radius_m).normalized();
  const double step = 2 * pi / sides;
  for (int side = 0; side < sides; ++side) {
    const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
    for (int corner = 0; corner < 2; ++corner) {
      const double angle = step * (side + corner);
      const double facing = smooth ? angle : step * (side + 0.5);
      for (const ProfilePoint& point : {low, high}) {
        mesh.positions_m.push_back(on_circle(point, angle));
        mesh.normals.emplace_back(normal.x() * std::sin(facing), normal.y(), normal.x() * std::cos(facing));
      }
    }
    if (low.radius_m > 0) mesh.triangles.push_back({first, first + 2, first + 3});
    if (high.radius_m > 0) mesh.triangles.push_back({first, first + 3, first + 1});
  }
}

}  // namespace

TriangleMesh polygon(const std::vector<Vector3d>& corners_m) {
  TriangleMesh mesh;
  const Vector3d normal = (corners_m[1] - corners_m[0]).cross(corners_m[2] - corners_m[0]).normalized();
  for (const Vector3d& corner : corners_m) {
    mesh.positions_m.push_back(corner);
    mesh.normals.push_back(normal);
  }
  for (std::uint32_t i = 2; i < corners_m.size(); ++i) mesh.triangles.push_back({0, i - 1, i});
  return mesh;
}

TriangleMesh box(const Vector3d& low_m, const Vector3d& high_m) {
  const std::vector<Vector2d> outline = {
      {low_m.x(), low_m.y()}, {high_m.x(), low_m.y()}, {high_m.x(), high_m.y()}, {low_m.x(), high_m.y()}};
  return extruded(outline, low_m.z(), high_m.z());
}

TriangleMesh turned(const std::vector<ProfilePoint>& profile, int sides, bool smooth) {
  TriangleMesh mesh;
  if (profile.front().radius_m > 0)
    add_ring(mesh, {0, profile.front().height_m}, profile.front(), sides, smooth);
  for (std::size_t i = 1; i < profile.size(); ++i) add_ring(mesh, profile[i - 1], profile[i], sides, smooth);
  if (profile.back().radius_m > 0)
    add_ring(mesh, profile.back(), {0, profile.back().height_m}, sides, smooth);
  return mesh;
}

TriangleMesh turned_ring(const std::vector<ProfilePoint>& profile, int sides) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < profile.size(); ++i)
    add_ring(mesh, profile[i], profile[(i + 1) % profile.size()], sides, true);
  return mesh;
}

TriangleMesh extruded(const std::vector<Vector2d>& outline, double low_m, double high_m) {
  TriangleMesh mesh;
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& point : outline) centre += point / static_cast<double>(outline.size());
  const auto at = [](const Vector2d& point, double z) { return Vector3d(point.x(), point.y(), z); };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& a = outline[i];
    const Vector2d& b = outline[(i + 1) % outline.size()];
    append(mesh, polygon({at(a, high_m), at(a, low_m), at(b, low_m), at(b, high_m)}));
    append(mesh, polygon({at(centre, high_m), at(a, high_m), at(b, high_m)}));
    append(mesh, polygon({at(centre, low_m), at(b, low_m), at(a, low_m)}));
  }
  return mesh;
}

TriangleMesh beam(const Vector3d& from_m, const Vector3d& to_m, double width_m, double height_m) {
  const Vector3d along = to_m - from_m;
  const Vector3d z = along.normalized();
  const Vector3d hint = std::abs(z.y()) < 0.99 ? Vector3d::UnitY() : Vector3d::UnitX();
  const Vector3d x = hint.cross(z).normalized();
  Eigen::Affine3d frame = Eigen::Affine3d::Identity();
  frame.linear() << x, z.cross(x), z;
  frame.translation() = from_m;
  const TriangleMesh straight =
      box({-width_m / 2, -height_m / 2, 0}, {width_m / 2, height_m / 2, along.norm()});
  return transformed(straight, frame);
}

}  // namespace seamline::scenes
