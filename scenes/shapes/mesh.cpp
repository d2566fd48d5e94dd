#include "scenes/shapes/mesh.h"

#include <Eigen/LU>
#include <limits>
#include <numeric>

namespace seamline::scenes {
namespace {

using Vector3d = Eigen::Vector3d;

/// Disjoint sets of vertices that share triangles.
std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t vertex) {
  while (parent[vertex] != vertex) {
    parent[vertex] = parent[parent[vertex]];
    vertex = parent[vertex];
  }
  return vertex;
}

}  // namespace

void append(TriangleMesh& whole, const TriangleMesh& part) {
  const auto offset = static_cast<std::uint32_t>(whole.positions_m.size());
  whole.positions_m.insert(whole.positions_m.end(), part.positions_m.begin(), part.positions_m.end());
  whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
  for (const auto& [a, b, c] : part.triangles)
    whole.triangles.push_back({a + offset, b + offset, c + offset});
}

TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Affine3d& transform) {
  TriangleMesh result = mesh;
  const Eigen::Matrix3d linear = transform.linear();
  const Eigen::Matrix3d to_normal = linear.inverse().transpose();
  for (Vector3d& position : result.positions_m) position = transform * position;
  for (Vector3d& normal : result.normals) normal = (to_normal * normal).normalized();
  if (linear.determinant() < 0)
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  return result;
}

Eigen::AlignedBox3d bounds(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& position : mesh.positions_m) box.extend(position);
  return box;
}

double enclosed_volume_m3(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six_volumes += mesh.positions_m[a].dot(mesh.positions_m[b].cross(mesh.positions_m[c]));
  return six_volumes / 6;
}

TriangleMesh largest_piece(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions_m.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const auto& [a, b, c] : mesh.triangles) {
    parent[root_of(parent, a)] = root_of(parent, b);
    parent[root_of(parent, b)] = root_of(parent, c);
  }
  std::vector<std::size_t> size(mesh.positions_m.size(), 0);
  std::uint32_t largest = 0;
  for (const auto& triangle : mesh.triangles) {
    const std::uint32_t piece = root_of(parent, triangle[0]);
    if (++size[piece] > size[largest]) largest = piece;
  }
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> renumbered(mesh.positions_m.size(), unused);
  TriangleMesh result;
  for (const auto& triangle : mesh.triangles) {
    if (root_of(parent, triangle[0]) != largest) continue;
    std::array<std::uint32_t, 3> kept{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::uint32_t& number = renumbered[triangle[corner]];
      if (number == unused) {
        number = static_cast<std::uint32_t>(result.positions_m.size());
        result.positions_m.push_back(mesh.positions_m[triangle[corner]]);
        result.normals.push_back(mesh.normals[triangle[corner]]);
      }
      kept[corner] = number;
    }
    result.triangles.push_back(kept);
  }
  return result;
}

TriangleMesh stood_on_ground(const TriangleMesh& mesh) {
  const Eigen::AlignedBox3d box = bounds(mesh);
  const Vector3d shift(-box.center().x(), -box.min().y(), -box.center().z());
  return transformed(mesh, Eigen::Affine3d(Eigen::Translation3d(shift)));
}

}  // namespace seamline::scenes
