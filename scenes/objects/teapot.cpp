#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "scenes/objects/objects.h"

namespace seamline::scenes {
namespace teapot_parts {
namespace {

/// Sixteen control points of a bicubic Bezier patch, rows along v, in Newell's units with z up.
using BezierPatch = std::array<Eigen::Vector3d, 16>;

using Vector3d = Eigen::Vector3d;

/// A row of control points on a circle: Newell put the inner two of a quarter at 0.56 of the radius.
struct TurnedRow {
  double radius = 0;
  double height = 0;
  double quarter = 0.56;
};
using TurnedPart = std::array<TurnedRow, 4>;

/// A row of control points on half a section of handle or spout: two sides in the plane of symmetry, and the
/// half width.
struct SectionRow {
  double side_a_x = 0;
  double side_a_height = 0;
  double side_b_x = 0;
  double side_b_height = 0;
  double half_width = 0;
};
using SectionPart = std::array<SectionRow, 4>;

constexpr std::array<TurnedPart, 6> turned_parts = {{
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},  // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2.0, 1.35}, {2.0, 0.9}}},            // upper body
    {{{2.0, 0.9}, {2.0, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},            // lower body
    {{{0.0, 3.15}, {0.8, 3.15, 0.5625}, {0.0, 2.85}, {0.2, 2.7}}},     // knob
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},              // lid
    {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0.0}, {0.0, 0.0}}},           // bottom
}};

constexpr std::array<SectionPart, 4> section_parts = {{
    {{{-1.6, 2.025, -1.5, 2.25, 0.3},
      {-2.3, 2.025, -2.5, 2.25, 0.3},
      {-2.7, 2.025, -3.0, 2.25, 0.3},
      {-2.7, 1.8, -3.0, 1.8, 0.3}}},
    {{{-2.7, 1.8, -3.0, 1.8, 0.3},
      {-2.7, 1.575, -3.0, 1.35, 0.3},
      {-2.5, 1.125, -2.65, 0.9375, 0.3},
      {-2.0, 0.9, -1.9, 0.6, 0.3}}},
    {{{1.7, 1.425, 1.7, 0.6, 0.66},
      {2.6, 1.425, 3.1, 0.825, 0.66},
      {2.3, 2.1, 2.4, 2.025, 0.25},
      {2.7, 2.4, 3.3, 2.4, 0.25}}},
    {{{2.7, 2.4, 3.3, 2.4, 0.25},
      {2.8, 2.475, 3.525, 2.49375, 0.25},
      {2.9, 2.475, 3.45, 2.5125, 0.15},
      {2.8, 2.4, 3.2, 2.4, 0.15}}},
}};

/// The part's quarter number `turn` (0 to 3), going around the z axis.
BezierPatch turned_patch(const TurnedPart& part, int turn) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const auto [radius, height, quarter] = part[row];
    std::array<Vector3d, 4> points = {
        Vector3d(radius, 0, height), Vector3d(radius, -quarter * radius, height),
        Vector3d(quarter * radius, -radius, height), Vector3d(0, -radius, height)};
    for (std::size_t i = 0; i < 4; ++i) {
      Vector3d point = points[i];
      for (int quarter_turn = 0; quarter_turn < turn; ++quarter_turn)
        point = Vector3d(point.y(), -point.x(), point.z());
      patch[4 * row + i] = point;
    }
  }
  return patch;
}

/// Half a tube; `side` is -1 or 1, the sign of y. Both halves go around the same way.
BezierPatch section_patch(const SectionPart& part, double side) {
  BezierPatch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    const SectionRow& s = part[row];
    const Vector3d a(s.side_a_x, 0, s.side_a_height);
    const Vector3d b(s.side_b_x, 0, s.side_b_height);
    const Vector3d out(0, side * s.half_width, 0);
    const std::array<Vector3d, 4> points = {a, a + out, b + out, b};
    for (std::size_t i = 0; i < 4; ++i) patch[4 * row + i] = side < 0 ? points[i] : points[3 - i];
  }
  return patch;
}

/// Martin Newell's 32 patches (1975): rim, body, lid and bottom four times around, handle and spout on both
/// sides.
std::vector<BezierPatch> newell_teapot() {
  std::vector<BezierPatch> patches;
  for (const TurnedPart& part : turned_parts)
    for (int turn = 0; turn < 4; ++turn) patches.push_back(turned_patch(part, turn));
  for (const SectionPart& part : section_parts)
    for (const double side : {-1.0, 1.0}) patches.push_back(section_patch(part, side));
  return patches;
}

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
