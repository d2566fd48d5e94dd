// What is written can be read back; what is shipped is what the study files count on.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <regex>
#include <set>

#include "scenes/builtin.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::scenes {
namespace {

std::filesystem::path output(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "scenes";
  std::filesystem::create_directories(folder);
  return folder / name;
}

class Scenes : public testing::TestWithParam<std::string_view> {};

TEST_P(Scenes, RoundTrips) {
  const SceneContents written = builtin_scene(GetParam());
  const auto path = output(std::string(GetParam()) + ".glb");
  write_glb(path, written);
  const SceneContents read = read_glb(path);
  ASSERT_EQ(read.parts.size(), written.parts.size());
  for (std::size_t i = 0; i < read.parts.size(); ++i) {
    const ScenePart& a = written.parts[i];
    const ScenePart& b = read.parts[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    ASSERT_EQ(a.mesh.positions_m.size(), b.mesh.positions_m.size());
    for (std::size_t v = 0; v < a.mesh.positions_m.size(); ++v) {
      ASSERT_LT((a.mesh.positions_m[v] - b.mesh.positions_m[v]).norm(), 1e-5);
      ASSERT_LT((a.mesh.normals[v] - b.mesh.normals[v]).norm(), 1e-6);
    }
  }
  ASSERT_TRUE(read.camera.has_value());
  EXPECT_LT((read.camera->position_m - written.camera->position_m).norm(), 1e-12);
  const auto sight = [](const SceneCamera& camera) {
    return (camera.look_at_m - camera.position_m).normalized();
  };
  EXPECT_LT((sight(*read.camera) - sight(*written.camera)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(read.camera->vertical_fov_rad, written.camera->vertical_fov_rad);
  ASSERT_EQ(read.lamp.has_value(), written.lamp.has_value());
  if (read.lamp) {
    EXPECT_LT((read.lamp->position_m - written.lamp->position_m).norm(), 1e-12);
    EXPECT_NEAR(read.lamp->intensity_w_sr, written.lamp->intensity_w_sr, 1e-9);
  }
  ASSERT_EQ(read.sun.has_value(), written.sun.has_value());
  if (read.sun) {
    EXPECT_LT((read.sun->to_sun - written.sun->to_sun).norm(), 1e-9);
    EXPECT_NEAR(read.sun->irradiance_w_m2, written.sun->irradiance_w_m2, 1e-9);
  }
}

TEST_P(Scenes, NamesEachPartOnceAndHasSoundTriangles) {
  std::set<std::string> names;
  for (const ScenePart& part : builtin_scene(GetParam()).parts) {
    EXPECT_TRUE(names.insert(part.name).second) << part.name;
    for (const auto& [a, b, c] : part.mesh.triangles) {
      const auto& p = part.mesh.positions_m;
      const Eigen::Vector3d normal = (p[b] - p[a]).cross(p[c] - p[a]);
      ASSERT_GT(normal.norm(), 1e-9) << part.name;
      ASSERT_GT(normal.normalized().dot(part.mesh.normals[a]), 0.0) << part.name;
    }
  }
}

TEST_P(Scenes, HasASunUnlessItsLightIsAmbientOcclusion) {
  const SceneContents scene = builtin_scene(GetParam());
  EXPECT_EQ(scene.sun.has_value(), !GetParam().starts_with("atrium") && !GetParam().starts_with("loft"));
  ASSERT_TRUE(scene.camera.has_value());
  if (scene.sun) {
    EXPECT_GT(scene.sun->to_sun.y(), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Scenes, testing::ValuesIn(builtin_scene_names),
                         [](const auto& each) { return std::string(each.param); });

/// What times are compared on across renderers (a published room of this kind took minutes a picture).
TEST(FurnishedRoom, HasSixtyPiecesOfFurnitureOneOpenSideAndALowSun) {
  const SceneContents room = builtin_scene("furnished_room");
  int pieces = 0;
  for (const ScenePart& part : room.parts) {
    EXPECT_NE(part.name, "wall_left");
    pieces += part.name.find_last_of("0123456789") == part.name.size() - 1 ? 1 : 0;
  }
  EXPECT_GE(pieces, 60);
  EXPECT_NEAR(std::asin(room.sun->to_sun.y()) * 180 / std::numbers::pi, 24, 1e-9);
  EXPECT_EQ(room.sun->irradiance_w_m2, 8);
  const double horizontal_rad = 2 * std::atan(std::tan(room.camera->vertical_fov_rad / 2) * camera_aspect);
  EXPECT_NEAR(horizontal_rad * 180 / std::numbers::pi, 70, 1e-9);
}

TEST(SceneFiles, WritesTheSameBytesTwice) {
  const SceneContents scene = builtin_scene("gazebo");
  write_glb(output("first.glb"), scene);
  write_glb(output("second.glb"), scene);
  EXPECT_EQ(read_file(output("first.glb")), read_file(output("second.glb")));
}

TEST(SceneFiles, RefusesAPlaceThatCannotBeWrittenTo) {
  EXPECT_THROW(write_glb("/proc/nowhere/bedroom.glb", builtin_scene("bedroom")), InputError);
}

/// The shipped objects, as the build wrote them, are as fine as the paper's comparison needs.
TEST(ShippedObjects, HaveTwentyThousandTriangles) {
  for (const std::string_view name : builtin_object_names) {
    const auto path = resolve_named_file("builtin:" + std::string(name), "file");
    const SceneContents object = read_glb(path);
    ASSERT_EQ(object.parts.size(), 1U);
    EXPECT_GE(object.parts[0].mesh.triangles.size(), 20000U) << name;
    EXPECT_NEAR(bounds(object.parts[0].mesh).min().y(), 0.0, 1e-6) << name;
  }
}

TEST(BuiltinObjects, AreOnTheReferencePageWithTheirSizes) {
  std::ifstream page(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "documentation/reference/study_file.md");
  const std::regex row(R"(^\| `builtin:([a-z_]+)` \| ([0-9.]+) \| ([0-9.]+) \| ([0-9.]+) \|.*)");
  std::set<std::string> listed, made(builtin_object_names.begin(), builtin_object_names.end());
  made.insert(builtin_furniture_names.begin(), builtin_furniture_names.end());
  for (std::string line; std::getline(page, line);) {
    std::smatch cells;
    if (!std::regex_match(line, cells, row)) continue;
    const std::string name = cells[1];
    listed.insert(name);
    Eigen::AlignedBox3d box;
    for (const ScenePart& part : read_glb(resolve_named_file("builtin:" + name, "")).parts)
      box.extend(bounds(part.mesh));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(std::stod(cells[2 + static_cast<std::size_t>(axis)]), box.sizes()[axis], 0.0051)
          << name << " along axis " << axis;
  }
  EXPECT_EQ(listed, made);
}

}  // namespace
}  // namespace seamline::scenes
