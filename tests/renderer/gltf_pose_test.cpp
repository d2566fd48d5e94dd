// Where the vertices of other people's files come to lie: skins, morph weights, instances and mirrored nodes,
// beside their own arithmetic.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "raytracer/tracing/geometry.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/renderer/gltf_bytes.h"

namespace seamline::renderer {
namespace {

using test::bytes_of;
using testing::ElementsAre;
using testing::HasSubstr;

/// A triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) that looks to +Z, and further accessors.
class GltfPosed : public testing::Test {
 protected:
  GltfPosed() {
    add(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), 5126, "VEC3", 3);
    add(bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}), 5126, "VEC3", 3);
  }

  /// Adds an accessor; its number.
  int add(const std::string& bytes, int component_type, const char* type, int count,
          bool normalised = false) {
    views_ += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})", accessors_ > 0 ? "," : "",
                          buffer_.size(), bytes.size());
    accessor_texts_ +=
        fmt::format(R"({}{{"bufferView":{},"componentType":{},"type":"{}","count":{},"normalized":{}}})",
                    accessors_ > 0 ? "," : "", accessors_, component_type, type, count, normalised);
    buffer_ += bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
    return accessors_++;
  }

  /// The file with these nodes, the first a root, and a mesh of one primitive.
  std::filesystem::path gltf(const std::string& nodes, const std::string& attributes,
                             const std::string& more_of_primitive = "", const std::string& more = "") {
    const std::filesystem::path path = folder_ / "posed.gltf";
    write_file_atomically(folder_ / "posed.bin", buffer_);
    write_file_atomically(
        path,
        fmt::format(
            R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{},"uri":"posed.bin"}}],)"
            R"("bufferViews":[{}],"accessors":[{}],"nodes":{},"scenes":[{{"nodes":[0]}}],)"
            R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{}}}{}}}],"weights":[0.5]}}]{}}})",
            buffer_.size(), views_, accessor_texts_, nodes, attributes, more_of_primitive, more));
    return path;
  }

  static void expect_corners(const FileMesh& mesh, const std::vector<Eigen::Vector3d>& wanted) {
    ASSERT_EQ(mesh.positions_m.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_TRUE(mesh.positions_m[i].isApprox(wanted[i], 1e-6))
          << i << ": " << mesh.positions_m[i].transpose();
  }

  const TemporaryFolder folder_;

 private:
  std::string buffer_, views_, accessor_texts_;
  int accessors_ = 0;
};

TEST_F(GltfPosed, ASkinPlacesEachVertexByItsJointsAndNotByItsNode) {
  // The second joint is bound at (0, 1, 0) and stands at (0, 3, 0), turned by a quarter about Z.
  const int joints = add(bytes_of<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}), 5121, "VEC4", 3);
  const int weights = add(bytes_of<float>({1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 0, 2, 0, 0}), 5126, "VEC4", 3);
  const int bound = add(bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                         1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}),
                        5126, "MAT4", 2);
  const std::string nodes =
      R"([{"children":[1,2,3]},{"mesh":0,"skin":0,"translation":[50,0,0]},{"translation":[2,0,0]},)"
      R"({"translation":[0,3,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])";
  const SceneFile file = read_scene_file(
      gltf(nodes, fmt::format(R"(,"NORMAL":1,"JOINTS_0":{},"WEIGHTS_0":{})", joints, weights), "",
           fmt::format(R"(,"skins":[{{"joints":[2,3],"inverseBindMatrices":{}}}])", bound)));
  ASSERT_EQ(file.meshes.size(), 1U);
  // (1, 0, 0): half of (3, 0, 0), half of (0, 3, 0) + R (1, -1, 0) = (1, 4, 0). (0, 1, 0): R 0 + (0, 3, 0).
  expect_corners(file.meshes[0], {{2, 0, 0}, {2, 2, 0}, {0, 3, 0}});
  EXPECT_TRUE(file.meshes[0].normals[1].isApprox(Eigen::Vector3f::UnitZ(), 1e-6F));
  EXPECT_THAT(
      test::complaint_of([&] {
        (void)read_scene_file(gltf(nodes, fmt::format(R"(,"JOINTS_0":{},"WEIGHTS_0":{})", joints, weights),
                                   "", R"(,"skins":[{"joints":[2]}])"));
      }),
      HasSubstr("joints under 1, found 1"));
}

TEST_F(GltfPosed, MorphWeightsAreTheNodesElseTheMeshs) {
  const int moved = add(bytes_of<float>({0, 0, 2, 0, 0, 0, 0, 4, 0}), 5126, "VEC3", 3);
  const std::string targets = fmt::format(R"(,"targets":[{{"POSITION":{}}}])", moved);
  expect_corners(read_scene_file(gltf(R"([{"mesh":0}])", "", targets)).meshes[0],
                 {{0, 0, 1}, {1, 0, 0}, {0, 3, 0}});
  expect_corners(
      read_scene_file(gltf(R"([{"mesh":0,"weights":[0.25],"scale":[2,2,2]}])", "", targets)).meshes[0],
      {{0, 0, 1}, {2, 0, 0}, {0, 4, 0}});
}

TEST_F(GltfPosed, InstancesStandWhereTheirAttributesSay) {
  const int translations = add(bytes_of<float>({0, 0, 0, 5, 0, 0}), 5126, "VEC3", 2);
  const int rotations = add(bytes_of<std::int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}), 5122, "VEC4", 2, true);
  const int scales = add(bytes_of<float>({1, 1, 1, 2, 2, 2}), 5126, "VEC3", 2);
  const auto nodes = [&](int rotation) {
    return fmt::format(
        R"([{{"mesh":0,"translation":[0,10,0],"extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":)"
        R"({{"TRANSLATION":{},"ROTATION":{},"SCALE":{}}}}}}}}}])",
        translations, rotation, scales);
  };
  const SceneFile file = read_scene_file(gltf(nodes(rotations), ""));
  ASSERT_EQ(file.meshes.size(), 2U);
  expect_corners(file.meshes[0], {{0, 10, 0}, {1, 10, 0}, {0, 11, 0}});
  // Half a turn about Z, twice as large.
  expect_corners(file.meshes[1], {{5, 10, 0}, {3, 10, 0}, {5, 8, 0}});
  const int too_many = add(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}), 5126, "VEC4", 3);
  EXPECT_THAT(test::complaint_of([&] { (void)read_scene_file(gltf(nodes(too_many), "")); }),
              HasSubstr("wanted as many of every attribute, found 2 and 3"));
}

/// A mirrored surface looks the same as one that was modelled so: its outside stays outside, and its
/// picture's right and up are mirrored with it.
TEST_F(GltfPosed, AMirroredNodeKeepsItsOutsideAndItsNormalMap) {
  const int tangents = add(bytes_of<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}), 5126, "VEC4", 3);
  const int uvs = add(bytes_of<float>({0, 1, 1, 1, 0, 0}), 5126, "VEC2", 3);
  write_png(folder_ / "map.png", {1, 1, 3, {218, 218, 128}});  // leans right and up
  const std::string material =
      R"(,"images":[{"uri":"map.png"}],"textures":[{"source":0}],"materials":)"
      R"([{"normalTexture":{"index":0},"pbrMetallicRoughness":{"metallicFactor":0}}])";
  for (const std::string& given :
       {fmt::format(R"(,"NORMAL":1,"TEXCOORD_0":{},"TANGENT":{})", uvs, tangents),
        fmt::format(R"(,"NORMAL":1,"TEXCOORD_0":{})", uvs), fmt::format(R"(,"TEXCOORD_0":{})", uvs)}) {
    const SceneFile file = read_scene_file(
        gltf(R"([{"mesh":0,"scale":[-1,1,1]}])", given, R"(,"material":0)", material), MaterialModel::gltf);
    const FileMesh& mesh = file.meshes[0];
    const Eigen::Vector3d across =
        (mesh.positions_m[mesh.triangles[0][1]] - mesh.positions_m[mesh.triangles[0][0]])
            .cross(mesh.positions_m[mesh.triangles[0][2]] - mesh.positions_m[mesh.triangles[0][0]]);
    EXPECT_GT(across.z(), 0);
    for (const Eigen::Vector3f& normal : mesh.normals) EXPECT_TRUE(normal.isApprox(Eigen::Vector3f::UnitZ()));
    const Geometry geometry(place_meshes(file, Eigen::Affine3d::Identity(), Eigen::Vector3d::Zero(), 0.5, 0));
    const auto point = geometry.nearest({{-0.2F, 0.2F, 1}, {0, 0, -1}});
    ASSERT_TRUE(point);
    EXPECT_GT(point->normal.dot(Eigen::Vector3f(-1, 1, 0).normalized()), 0.99F) << given;
  }
}

TEST_F(GltfPosed, VertexColoursAreThereWithAndWithoutAlphaAndMaterial) {
  const int bytes =
      add(bytes_of<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255}), 5121, "VEC4", 3, true);
  const int floats = add(bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 1}), 5126, "VEC3", 3);
  for (const int colours : {bytes, floats}) {
    const SceneFile file = read_scene_file(gltf(R"([{"mesh":0}])", fmt::format(R"(,"COLOR_0":{})", colours)));
    const Geometry geometry(place_meshes(file, Eigen::Affine3d::Identity(), Eigen::Vector3d::Zero(), 0.5, 0));
    const auto point = geometry.nearest({{0.25F, 0.5F, 1}, {0, 0, -1}});
    ASSERT_TRUE(point);
    EXPECT_TRUE(point->albedo.isApprox(Rgb(0.25F, 0.25F, 0.5F), 1e-5F));
  }
}

TEST_F(GltfPosed, WhatIsLeftOutIsSaidInPlainWords) {
  const SceneFile file = read_scene_file(
      gltf(R"([{"children":[1,2]},{"mesh":0},{"camera":0}])", "", "",
           R"(,"animations":[{},{}],"extensionsUsed":["EXT_gadget","KHR_materials_variants"],)"
           R"("cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":9,"znear":0.1}}])"));
  EXPECT_FALSE(file.camera);
  EXPECT_THAT(file.left_out, ElementsAre("2 animations (everything is shown at rest)", "EXT_gadget",
                                         "a camera that is orthographic",
                                         "variants of materials (the first look is shown)"));
  EXPECT_THAT(left_out_sentence(file, {"its lamp"}), HasSubstr("posed.gltf: left out: 2 animations"));
  const SceneFile lines = read_scene_file(gltf(R"([{"mesh":0}])", "", R"(,"mode":1)"));
  EXPECT_TRUE(lines.meshes.empty());
  EXPECT_THAT(lines.left_out, ElementsAre("points and lines"));
}

}  // namespace
}  // namespace seamline::renderer
