#include <array>
#include <cmath>
#include <map>

#include "scenes/objects/objects.h"
#include "scenes/objects/teapot_patches.h"

namespace seamline::scenes {
namespace teapot_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using Weights = std::array<double, 4>;

/// Cubic Bernstein polynomials and their derivatives.
Weights bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
Weights bernstein_slope(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Vector3d combine(const BezierPatch& patch, const Weights& v, const Weights& u) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t i = 0; i < 4; ++i) sum += v[row] * u[i] * patch[4 * row + i];
  return sum;
}

/// The patch's normal; where it degenerates to a point (knob, bottom), that of a point a little further in.
Vector3d patch_normal(const BezierPatch& patch, double u, double v) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    const Vector3d along_u = combine(patch, bernstein(v), bernstein_slope(u));
    const Vector3d along_v = combine(patch, bernstein_slope(v), bernstein(u));
    const Vector3d normal = along_u.cross(along_v);
    if (normal.norm() > 1e-6) return normal.normalized();
    u += 1e-3 * (0.5 - u);
    v += 1e-3 * (0.5 - v);
  }
  return Vector3d::UnitZ();
}

/// Vertices welded by position (to a 1e-5 of Newell's unit), their normals summed.
class Weld {
 public:
  std::uint32_t vertex(TriangleMesh& mesh, const Vector3d& position, const Vector3d& normal) {
    std::array<long, 3> key{};
    for (int axis = 0; axis < 3; ++axis)
      key[static_cast<std::size_t>(axis)] = std::lround(position[axis] * 1e5);
    const auto [entry, is_new] =
        numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh.positions_m.size()));
    if (is_new) {
      mesh.positions_m.push_back(position);
      mesh.normals.push_back(Vector3d::Zero());
    }
    mesh.normals[entry->second] += normal;
    return entry->second;
  }

 private:
  std::map<std::array<long, 3>, std::uint32_t> numbers_;
};

void add_patch(TriangleMesh& mesh, Weld& weld, const BezierPatch& patch, int steps) {
  std::vector<std::uint32_t> grid;
  for (int row = 0; row <= steps; ++row)
    for (int column = 0; column <= steps; ++column) {
      const double u = static_cast<double>(column) / steps;
      const double v = static_cast<double>(row) / steps;
      grid.push_back(
          weld.vertex(mesh, combine(patch, bernstein(v), bernstein(u)), patch_normal(patch, u, v)));
    }
  const auto stride = static_cast<std::size_t>(steps) + 1;
  const auto add = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  };
  for (std::size_t row = 0; row + 1 < stride; ++row)
    for (std::size_t column = 0; column + 1 < stride; ++column) {
      const std::size_t at = row * stride + column;
      add(grid[at], grid[at + 1], grid[at + stride + 1]);
      add(grid[at], grid[at + stride + 1], grid[at + stride]);
    }
}

}  // namespace
}  // namespace teapot_parts

TriangleMesh make_teapot(int steps) {
  using namespace teapot_parts;
  TriangleMesh mesh;
  Weld weld;
  for (const BezierPatch& patch : newell_teapot()) add_patch(mesh, weld, patch, steps);
  for (Vector3d& normal : mesh.normals) normal.normalize();
  Eigen::Affine3d to_y_up = Eigen::Affine3d::Identity();
  const double length = bounds(mesh).sizes().x();
  to_y_up.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  to_y_up.linear() /= length;
  return stood_on_ground(transformed(mesh, to_y_up));
}

}  // namespace seamline::scenes
