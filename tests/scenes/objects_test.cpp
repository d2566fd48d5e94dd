// Laws of the built-in objects: closed, outward, standing on the ground, the same for any number of threads.
#include <gtest/gtest.h>

#include <map>

#include "scenes/builtin.h"

namespace seamline::scenes {
namespace {

/// Coarser than what is shipped, so that the tests are quick; the laws do not depend on it. Each is made
/// once.
const TriangleMesh& coarse_object(std::string_view name) {
  static std::map<std::string_view, TriangleMesh> made;
  if (!made.contains(name)) made[name] = builtin_object(name, {.coarseness = 2.0, .threads = 2});
  return made[name];
}

class Objects : public testing::TestWithParam<std::string_view> {};

std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  return edges;
}

/// Among triangles that are not slivers, the share whose winding agrees with its vertices' normals.
double share_facing_their_normals(const TriangleMesh& mesh) {
  double agree = 0, area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d normal =
        (mesh.positions_m[b] - mesh.positions_m[a]).cross(mesh.positions_m[c] - mesh.positions_m[a]);
    area += normal.norm();
    if (normal.dot(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) > 0) agree += normal.norm();
  }
  return agree / area;
}

TEST_P(Objects, StandsOnTheGroundWithUnitNormalsFacingOut) {
  const TriangleMesh& mesh = coarse_object(GetParam());
  const Eigen::AlignedBox3d box = bounds(mesh);
  EXPECT_NEAR(box.min().y(), 0.0, 1e-9);
  EXPECT_NEAR(box.center().x(), 0.0, 1e-9);
  EXPECT_NEAR(box.center().z(), 0.0, 1e-9);
  EXPECT_GT(enclosed_volume_m3(mesh), 0.01);
  ASSERT_EQ(mesh.normals.size(), mesh.positions_m.size());
  for (const Eigen::Vector3d& normal : mesh.normals) ASSERT_NEAR(normal.norm(), 1.0, 1e-9);
  EXPECT_GT(share_facing_their_normals(mesh), 0.97)
      << "feathers and curls thinner than a cell face both ways";
}

TEST_P(Objects, IsAClosedManifold) {
  const TriangleMesh& mesh = coarse_object(GetParam());
  const auto edges = directed_edges(mesh);
  int open = 0;
  for (const auto& [edge, uses] : edges) {
    ASSERT_EQ(uses, 1) << "edge " << edge.first << " to " << edge.second;
    if (!edges.contains({edge.second, edge.first})) ++open;
  }
  if (GetParam() == "teapot") {
    EXPECT_GT(open, 0) << "Newell's patches are open at the spout and under the lid";
    return;
  }
  EXPECT_EQ(open, 0) << "edges of one triangle alone";
  EXPECT_EQ(largest_piece(mesh).triangles.size(), mesh.triangles.size()) << "more than one piece";
}

TEST_P(Objects, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh one = builtin_object(GetParam(), {.coarseness = 4.0, .threads = 1});
  const TriangleMesh two = builtin_object(GetParam(), {.coarseness = 4.0, .threads = 2});
  EXPECT_EQ(one.positions_m, two.positions_m);
  EXPECT_EQ(one.normals, two.normals);
  EXPECT_EQ(one.triangles, two.triangles);
}

INSTANTIATE_TEST_SUITE_P(Every, Objects, testing::ValuesIn(builtin_object_names),
                         [](const auto& each) { return std::string(each.param); });

TEST(Teapot, HasNewellsProportions) {
  // Newell's teapot with Blinn's scaling: 6.5 long (the curves stay inside their control points), 3.15 tall,
  // 4 across.
  const Eigen::Vector3d size = bounds(builtin_object("teapot")).sizes();
  EXPECT_NEAR(size.x(), 1.0, 1e-9);
  EXPECT_NEAR(size.y(), 3.15 / 6.43, 0.01);
  EXPECT_NEAR(size.z(), 4.0 / 6.43, 0.01);
}

TEST(Teapot, SharesEdgesBetweenPatches) {
  int open = 0;
  const auto edges = directed_edges(builtin_object("teapot"));
  for (const auto& [edge, uses] : edges) {
    ASSERT_EQ(uses, 1);
    open += edges.contains({edge.second, edge.first}) ? 0 : 1;
  }
  EXPECT_LT(open, 0.02 * static_cast<double>(edges.size())) << "only rims are open";
}

TEST(Builtin, RefusesAnUnknownName) {
  EXPECT_THROW((void)builtin_object("kettle"), std::invalid_argument);
  EXPECT_THROW((void)builtin_scene("kitchen"), std::invalid_argument);
}

}  // namespace
}  // namespace seamline::scenes
