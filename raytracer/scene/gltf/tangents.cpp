#include "raytracer/scene/gltf/tangents.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raytracer/material/hemisphere.h"

namespace seamline::renderer {
namespace {

/// Of a triangle with the picture's right and up as directions in space; false where there are none.
bool directions_of_picture(const std::array<Eigen::Vector3d, 3>& corners_m,
                           const std::array<Eigen::Vector2d, 3>& uvs, Eigen::Vector3d& right,
                           Eigen::Vector3d& up) {
  const Eigen::Vector3d a = corners_m[1] - corners_m[0], b = corners_m[2] - corners_m[0];
  const Eigen::Vector2d s = uvs[1] - uvs[0], t = uvs[2] - uvs[0];
  const double area = s.x() * t.y() - s.y() * t.x();
  if (!std::isnormal(area)) return false;
  right = (a * t.y() - b * s.y()) / area;
  up = (a * t.x() - b * s.x()) / area;  // v grows downwards
  return std::isnormal(right.squaredNorm()) && std::isnormal(up.squaredNorm());
}

double angle_at(const std::array<Eigen::Vector3d, 3>& corners_m, std::size_t corner) {
  const Eigen::Vector3d a = (corners_m[(corner + 1) % 3] - corners_m[corner]).normalized();
  const Eigen::Vector3d b = (corners_m[(corner + 2) % 3] - corners_m[corner]).normalized();
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

}  // namespace

std::vector<Eigen::Vector4f> make_tangents(std::span<const Eigen::Vector3d> positions_m,
                                           std::span<const Eigen::Vector3f> normals,
                                           std::span<const Triangle> triangles,
                                           std::span<const Eigen::Vector2f> uvs) {
  std::vector<Eigen::Vector3d> right_sum(positions_m.size(), Eigen::Vector3d::Zero()), up_sum = right_sum,
                                                                                       normal_sum = right_sum;
  for (const Triangle& triangle : triangles) {
    std::array<Eigen::Vector3d, 3> corners_m;
    std::array<Eigen::Vector2d, 3> corner_uvs;
    for (std::size_t k = 0; k < 3; ++k) {
      corners_m[k] = positions_m[triangle[k]];
      corner_uvs[k] = uvs[triangle[k]].cast<double>();
    }
    const Eigen::Vector3d across = (corners_m[1] - corners_m[0]).cross(corners_m[2] - corners_m[0]);
    Eigen::Vector3d right, up;
    if (!std::isnormal(across.squaredNorm()) || !directions_of_picture(corners_m, corner_uvs, right, up))
      continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = angle_at(corners_m, k);
      right_sum[triangle[k]] += weight * right.normalized();
      up_sum[triangle[k]] += weight * up.normalized();
      normal_sum[triangle[k]] += weight * across.normalized();
    }
  }
  std::vector<Eigen::Vector4f> tangents(positions_m.size());
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Eigen::Vector3f normal =
        !normals.empty() ? normals[i] : normal_sum[i].normalized().cast<float>().eval();
    const Eigen::Vector3f right = right_sum[i].cast<float>();
    Eigen::Vector3f across = right - normal.dot(right) * normal;
    const bool says = across.norm() > 1e-6F;
    across = says ? across.normalized() : Eigen::Vector3f(local_axes(normal).col(0));
    const bool mirrored = says && normal.cross(across).dot(up_sum[i].cast<float>()) < 0.0F;
    tangents[i] << across, mirrored ? -1.0F : 1.0F;
  }
  return tangents;
}

}  // namespace seamline::renderer
