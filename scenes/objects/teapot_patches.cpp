#include "scenes/objects/teapot_patches.h"

namespace seamline::scenes {
namespace {

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

}  // namespace

std::vector<BezierPatch> newell_teapot() {
  std::vector<BezierPatch> patches;
  for (const TurnedPart& part : turned_parts)
    for (int turn = 0; turn < 4; ++turn) patches.push_back(turned_patch(part, turn));
  for (const SectionPart& part : section_parts)
    for (const double side : {-1.0, 1.0}) patches.push_back(section_patch(part, side));
  return patches;
}

}  // namespace seamline::scenes
