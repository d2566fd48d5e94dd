// Triangles paired for the search tree stay the same surface.
#include "raytracer/tracing/quads.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "raytracer/tracing/triangle_neighbours.h"
#include "renderer/depth/adaptive_mesh.h"
#include "renderer/depth/full_mesh.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

/// From its smallest corner on, so that the same triangle is the same array.
Triangle turned(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::vector<Quad> quads_of(const DepthMesh& mesh) {
  return pair_into_quads(mesh.vertices_m, mesh.triangles,
                         triangle_neighbours(mesh.vertices_m.size(), mesh.triangles));
}

/// The triangles that Embree makes of quads, sorted.
std::vector<Triangle> triangles_of(const std::vector<Quad>& quads) {
  std::vector<Triangle> triangles;
  for (const Quad& q : quads) {
    if (q[2] == q[3]) {
      triangles.push_back(turned({q[0], q[1], q[2]}));
    } else {
      triangles.push_back(turned({q[0], q[1], q[3]}));
      triangles.push_back(turned({q[2], q[3], q[1]}));
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void expect_the_same_triangles(const DepthMesh& mesh) {
  std::vector<Triangle> wanted = mesh.triangles;
  std::transform(wanted.begin(), wanted.end(), wanted.begin(), turned);
  std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(triangles_of(quads_of(mesh)), wanted);
}

TEST(Quads, AreTheSameTrianglesWithTheSameWinding) {
  expect_the_same_triangles(build_depth_mesh(test::room_map(256), {}));
  expect_the_same_triangles(build_full_mesh(make_dense_sphere(test::room_map(64), 0, 1, 64), 1));
  std::mt19937_64 random(9);
  for (int i = 0; i < 20; ++i)  // with holes, so that triangles are left alone
    expect_the_same_triangles(
        build_adaptive_mesh(make_dense_sphere(test::random_map(32, random), 0, 1, 256), 1e-4, 1));
}

TEST(Quads, PairNearlyAllTrianglesOfARoom) {
  const DepthMesh mesh = build_depth_mesh(test::room_map(512), {});
  EXPECT_LT(static_cast<double>(quads_of(mesh).size()), 0.58 * static_cast<double>(mesh.triangles.size()));
}

TEST(Quads, OfNothingAreNone) {
  EXPECT_TRUE(quads_of({}).empty());
}

TEST(TriangleNeighbours, LieBeyondTheEdgeTheyAreToldFor) {
  const DepthMesh mesh = build_depth_mesh(test::room_map(128), {});
  const auto neighbours = triangle_neighbours(mesh.vertices_m.size(), mesh.triangles);
  std::size_t inner = 0;
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (neighbours[i][k] == no_neighbour) continue;
      ++inner;
      const Triangle &here = mesh.triangles[i], &there = mesh.triangles[neighbours[i][k]];
      const auto shared = std::find(there.begin(), there.end(), here[(k + 1) % 3]) - there.begin();
      ASSERT_LT(shared, 3);
      EXPECT_EQ(there[static_cast<std::size_t>(shared + 1) % 3], here[k]);
    }
  EXPECT_EQ(inner, 3 * neighbours.size());  // a closed room
}

}  // namespace
}  // namespace seamline::renderer
