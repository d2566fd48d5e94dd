#include <gtest/gtest.h>

#include "renderer/depth/adaptive_mesh_bound.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

using test::hole;
using test::make_map;

constexpr double loose = 0.1;  // a sixteenth of a turn of the unit sphere as one triangle is within it

/// A constant sphere of 256 x 128 vertices, of which one can be moved.
struct UnitSphere {
  DepthMap map = make_map(256, [](int, int) { return 1; });
  bool holds(const GridTriangle& t, float zenith_m = 1) const {
    DenseSphere sphere = make_dense_sphere(map, 0, 1, 256);
    sphere.zenith_m = zenith_m;
    return TriangleBound(sphere, loose).holds(t);
  }
  bool holds_with(int row, int column, float distance_m, const GridTriangle& t) const {
    UnitSphere moved = *this;
    moved.map.distance_m[static_cast<std::size_t>(row * 256 + column)] = distance_m;
    return moved.holds(t);
  }
};

// From row 0 to row 16 along a diagonal: in the grid half a square, on the sphere nearly a wedge.
constexpr GridTriangle polar = {{{16, 40}, {16, 56}, {0, 40}}};

TEST(TriangleBound, AsksEveryVertexThatARayCanHitNearThePole) {
  const UnitSphere unit;
  ASSERT_TRUE(unit.holds(polar));
  int asked_beyond_the_diagonal = 0;
  for (int row = 1; row < 16; ++row)
    for (int column = 41; column < 56; ++column) {
      const DenseSphere sphere = make_dense_sphere(unit.map, 0, 1, 256);
      const Eigen::Vector3d d = sphere.direction(row, column), top = sphere.direction(0, 40),
                            right = sphere.direction(16, 56);
      const bool under = top.cross(right).dot(d) * top.cross(right).dot(sphere.direction(16, 40)) > 0;
      if (!under) continue;  // the other edges are a meridian and the rounder side of a row
      EXPECT_FALSE(unit.holds_with(row, column, 2, polar)) << row << ", " << column;
      EXPECT_FALSE(unit.holds_with(row, column, hole, polar)) << row << ", " << column;
      if (column > 40 + row + 1) ++asked_beyond_the_diagonal;
    }
  EXPECT_GT(asked_beyond_the_diagonal, 20);
  EXPECT_TRUE(unit.holds_with(10, 39, 2, polar));
  EXPECT_TRUE(unit.holds_with(20, 48, 2, polar));
}

TEST(TriangleBound, AsksThePolesFan) {
  const UnitSphere unit;
  const GridTriangle along_row_0 = {{{8, 48}, {0, 56}, {0, 40}}};
  EXPECT_TRUE(unit.holds(along_row_0, 1));
  EXPECT_FALSE(unit.holds(along_row_0, 1e-3F));
  EXPECT_TRUE(unit.holds(along_row_0, hole));  // no pole, no fan
}

TEST(TriangleBound, AsksAllCornersOfCellsCoveredInPart) {
  const UnitSphere unit;
  const GridTriangle small = {{{62, 10}, {62, 12}, {60, 10}}};  // its diagonal goes from (60, 10) to (62, 12)
  ASSERT_TRUE(unit.holds(small));
  EXPECT_FALSE(unit.holds_with(61, 10, 2, small));
  EXPECT_FALSE(unit.holds_with(61, 11, 2, small));
  EXPECT_FALSE(unit.holds_with(60, 11, 2, small));
  EXPECT_FALSE(unit.holds_with(61, 12, hole, small));
  EXPECT_TRUE(unit.holds_with(60, 12, 2, small));
  EXPECT_TRUE(unit.holds_with(63, 11, 2, small));
}

TEST(TriangleBound, CrossesTheSeam) {
  const UnitSphere unit;
  const GridTriangle left = {{{62, 254}, {62, 256}, {60, 254}}};
  ASSERT_TRUE(unit.holds(left));
  EXPECT_FALSE(unit.holds_with(62, 0, 2, left));
  EXPECT_FALSE(unit.holds_with(61, 255, 2, left));
}

TEST(TriangleBound, SplitsTrianglesWithoutArea) {
  EXPECT_FALSE(UnitSphere{}.holds({{{60, 10}, {61, 10}, {62, 10}}}));
}

}  // namespace
}  // namespace seamline::renderer
