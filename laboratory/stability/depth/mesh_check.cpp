#include "laboratory/stability/depth/mesh_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

constexpr double touching = -1e-7, containing = -1e-6;  // sines of the angle to an edge

/// A triangle as rays from the centre see it.
struct SeenTriangle {
  std::array<Eigen::Vector3d, 3> inward;   ///< unit normals of the planes through centre and edge
  std::array<Eigen::Vector3d, 3> corners;  ///< unit directions
  Eigen::Vector3d normal;
  double offset = 0;

  explicit SeenTriangle(const DepthMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    std::array<Eigen::Vector3d, 3> at_m;
    for (std::size_t i = 0; i < 3; ++i) {
      at_m[i] = mesh.vertices_m[t[i]].cast<double>();
      corners[i] = at_m[i].normalized();
    }
    normal = (at_m[1] - at_m[0]).cross(at_m[2] - at_m[0]);
    offset = normal.dot(at_m[0]);
    for (std::size_t i = 0; i < 3; ++i) inward[i] = -corners[i].cross(corners[(i + 1) % 3]).normalized();
  }

  [[nodiscard]] bool faces_centre() const {
    for (std::size_t i = 0; i < 3; ++i)
      if (inward[i].dot(corners[(i + 2) % 3]) < 0) return false;
    return true;
  }
  [[nodiscard]] bool has_corner(const Eigen::Vector3d& direction) const {
    return std::any_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
      return corner.dot(direction) > 0 && corner.cross(direction).norm() < 1e-6;
    });
  }
};

}  // namespace

MeshCheck check_mesh(const DepthMesh& mesh, const DenseSphere& sphere) {
  MeshCheck check;
  std::vector<SeenTriangle> seen;
  seen.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    seen.emplace_back(mesh, t);
    check.facing_away += seen.back().faces_centre() ? 0 : 1;
  }
  for (int row = 0; row < sphere.height; ++row)
    for (int column = 0; column < sphere.width; ++column) {
      const Eigen::Vector3d d = sphere.direction(row, column);
      const double r = sphere.at(row, column);
      bool hit = false;
      for (const SeenTriangle& triangle : seen) {
        double inside = triangle.inward[0].dot(d);
        if (inside < containing) continue;
        inside = std::min(inside, triangle.inward[1].dot(d));
        if (inside < containing) continue;
        inside = std::min(inside, triangle.inward[2].dot(d));
        if (inside < containing) continue;
        hit = true;
        if (inside < touching) continue;
        if (is_hole(sphere.at(row, column)))
          ++check.holes_covered;
        else if (!triangle.has_corner(d))
          check.largest_error =
              std::max(check.largest_error, std::abs(triangle.offset / triangle.normal.dot(d) - r) / r);
      }
      if (!hit && !is_hole(sphere.at(row, column))) ++check.rays_without_hit;
    }
  return check;
}

double brute_force_distance_m(const DepthMesh& mesh, const Eigen::Vector3d& direction) {
  double nearest_m = infinity;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices_m[t[0]].cast<double>();
    if (a.dot(direction) <= 0) continue;
    const Eigen::Vector3d b = mesh.vertices_m[t[1]].cast<double>(), c = mesh.vertices_m[t[2]].cast<double>();
    if (b.cross(a).dot(direction) < 0 || c.cross(b).dot(direction) < 0 || a.cross(c).dot(direction) < 0)
      continue;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    nearest_m = std::min(nearest_m, normal.dot(a) / normal.dot(direction));
  }
  return nearest_m;
}

EdgeCheck check_edges(const DepthMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> directed;
  directed.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) directed.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(directed.begin(), directed.end());
  EdgeCheck check;
  for (std::size_t i = 0; i < directed.size(); ++i) {
    check.repeated += i > 0 && directed[i] == directed[i - 1] ? 1 : 0;
    check.open +=
        std::binary_search(directed.begin(), directed.end(), std::pair(directed[i].second, directed[i].first))
            ? 0
            : 1;
  }
  return check;
}

}  // namespace seamline::stability
