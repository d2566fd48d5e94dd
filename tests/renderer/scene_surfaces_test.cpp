// Whether a file shows anything, and which way is up in it.
#include "raytracer/scene/scene_surfaces.h"

#include <gtest/gtest.h>

#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

SceneFile scene_of_triangles(const Corners& corners_m) {
  FileMesh mesh;
  mesh.positions_m = corners_m;
  for (std::uint32_t i = 0; i + 2 < corners_m.size(); i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  SceneFile scene;
  scene.meshes.push_back(std::move(mesh));
  return scene;
}

std::string surface_complaint(const SceneFile& scene) {
  return test::complaint_of([&] { require_surface(scene, "a.glb", "a scene"); });
}

TEST(SceneSurfaces, OneTriangleThatHasAnAreaIsEnough) {
  EXPECT_EQ(surface_complaint({}), "a.glb: wanted a scene with triangles, found none");
  const Corners line = {{0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}},
                point = {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}};
  Corners both = line;
  both.insert(both.end(), point.begin(), point.end());
  EXPECT_EQ(surface_complaint(scene_of_triangles(both)),
            "a.glb: wanted a scene with triangles that have an area, found 2 triangles without any");
  EXPECT_EQ(test::complaint_of([&] { require_triangles(scene_of_triangles(point), "a.glb", "a scene"); }),
            "no complaint");
  for (const double size_m : {1e-6, 1.0, 1e6}) {  // a needle, too
    Corners more = both;
    for (const Eigen::Vector3d& corner : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), {1, 1e-6, 0}})
      more.push_back(size_m * corner);
    EXPECT_EQ(surface_complaint(scene_of_triangles(more)), "no complaint") << size_m;
  }
}

TEST(SceneSurfaces, ZMayBeUpWhereNothingFacesYOrTheCameraSaysSo) {
  const Corners facing_z = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, facing_y = {{0, 0, 0}, {0, 0, 4}, {4, 0, 4}},
                facing_x = {{0, 0, 0}, {0, 4, 0}, {0, 4, 4}};
  EXPECT_TRUE(may_be_z_up(scene_of_triangles(facing_z)));
  EXPECT_FALSE(may_be_z_up(scene_of_triangles(facing_y)));
  EXPECT_FALSE(may_be_z_up(scene_of_triangles(facing_x)));
  Corners room = facing_z;
  room.insert(room.end(), facing_y.begin(), facing_y.end());
  SceneFile scene = scene_of_triangles(room);
  EXPECT_FALSE(may_be_z_up(scene)) << "a floor and a wall";
  FileCamera camera;
  camera.axes << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // right, up and back: it looks along Y, with Z above
  scene.camera = camera;
  EXPECT_TRUE(may_be_z_up(scene));
  camera.axes << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // straight down in a file that is Y-up
  scene.camera = camera;
  EXPECT_FALSE(may_be_z_up(scene));
}

}  // namespace
}  // namespace seamline::renderer
