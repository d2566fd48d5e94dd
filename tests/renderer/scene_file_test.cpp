#include "raytracer/scene/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <numbers>

#include "raytracer/scene/truth_scene.h"
#include "support/text/error.h"
#include "tests/complaint.h"
#include "tests/renderer/gltf_bytes.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using testing::HasSubstr;

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 3; ++j)
      word = word << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > bytes.size() ? '=' : digits[word >> (18 - 6 * j) & 63];
  }
  return text;
}

/// A .gltf with four corners of a square, 16-bit indices 0 1 2 0 2 3, and whatever else a test says.
class GltfFile : public testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::temp_directory_path() / ("seamline-scene-" + std::to_string(::getpid()) + ".gltf");
  }
  void TearDown() override { fs::remove(path_); }

  static std::string square() {
    return bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
           bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
  }

  SceneFile read(const std::string& nodes,
                 const std::string& primitive = R"({"attributes":{"POSITION":0},"indices":1})",
                 const std::string& more = "", const std::string& bytes = square()) {
    std::ofstream(path_)
        << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" << nodes
        << R"(,"meshes":[{"primitives":[)" << primitive << R"(]}],"buffers":[{"byteLength":)" << bytes.size()
        << R"(,"uri":"data:application/octet-stream;base64,)" << base64(bytes)
        << R"("}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
        << R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},)"
        << R"({"bufferView":1,"componentType":5123,"type":"SCALAR","count":6}])" << more << "}";
    return read_scene_file(path_);
  }

  template <class... Arguments>
  std::string complaint(const Arguments&... arguments) {
    return test::complaint_of([&] { (void)read(arguments...); });
  }
  fs::path path_;
};

TEST_F(GltfFile, IndexedMeshUnderTranslationRotationAndScale) {
  const SceneFile file = read(
      R"([{"name":"square","mesh":0,"translation":[10,0,0],"rotation":[0,0,0.70710678,0.70710678],"scale":[2,2,2]}])");
  ASSERT_EQ(file.meshes.size(), 1U);
  EXPECT_EQ(file.meshes[0].name, "square");
  EXPECT_EQ(file.meshes[0].triangles.size(), 2U);
  EXPECT_TRUE(
      file.meshes[0].positions_m[1].isApprox(Eigen::Vector3d(10, 2, 0), 1e-7));  // x turned into y, doubled
  EXPECT_FALSE(file.meshes[0].albedo);
}

TEST_F(GltfFile, ParentTransformsMultiplyAndMatricesAreColumnMajor) {
  const SceneFile file = read(
      R"([{"children":[1],"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,5,0,1]},{"mesh":0,"translation":[1,0,0]}])");
  EXPECT_TRUE(file.meshes[0].positions_m[0].isApprox(Eigen::Vector3d(1, 5, 0)));
}

TEST_F(GltfFile, MeshesWithoutIndicesStripsAndFans) {
  EXPECT_EQ(read(R"([{"mesh":0}])", R"({"attributes":{"POSITION":0}})").meshes[0].triangles.size(), 1U);
  const SceneFile strip = read(R"([{"mesh":0}])", R"({"attributes":{"POSITION":0},"mode":5})");
  EXPECT_EQ(strip.meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
  const SceneFile fan = read(R"([{"mesh":0}])", R"({"attributes":{"POSITION":0},"mode":6})");
  EXPECT_EQ(fan.meshes[0].triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(read(R"([{"mesh":0}])", R"({"attributes":{"POSITION":0},"mode":1})").meshes.empty());  // lines
}

TEST_F(GltfFile, NormalsFollowNonUniformScaleAndMirrors) {
  const std::string normal = bytes_of<float>({0.6F, 0.8F, 0, 0.6F, 0.8F, 0, 0.6F, 0.8F, 0, 0.6F, 0.8F, 0});
  const SceneFile file =
      read(R"([{"mesh":0,"scale":[3,1,1]}])", R"({"attributes":{"POSITION":0,"NORMAL":0}})", "",
           normal + square().substr(48));
  // A normal transforms with the inverse transpose: (0.6 / 3, 0.8, 0).
  EXPECT_TRUE(file.meshes[0].normals[0].isApprox(Eigen::Vector3f(0.2F, 0.8F, 0).normalized(), 1e-5F));
}

TEST_F(GltfFile, CameraSunAndBaseColour) {
  const SceneFile file = read(
      R"([{"children":[1,2,3]},{"mesh":0},{"camera":0,"translation":[0,1,5]},{"rotation":[-0.70710678,0,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":0}}}])",
      R"({"attributes":{"POSITION":0},"indices":1,"material":0})",
      R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1}}],"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.2,0.3,0.4,1]}}],)"
      R"("extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":6830,"color":[1,0.5,0.25]}]}})");
  ASSERT_TRUE(file.camera);
  EXPECT_TRUE(file.camera->position_m.isApprox(Eigen::Vector3d(0, 1, 5)));
  EXPECT_DOUBLE_EQ(file.camera->vertical_fov_rad, 0.8);
  ASSERT_EQ(file.suns.size(), 1U);
  // The light shines along the node's -Z, which the rotation turns to straight down: the sun stands at the
  // zenith.
  EXPECT_TRUE(file.suns[0].to_sun.isApprox(Eigen::Vector3d::UnitY(), 1e-6));
  EXPECT_TRUE((file.suns[0].irradiance_w_m2 - Rgb(10, 5, 2.5F)).abs().maxCoeff() < 1e-4F);
  EXPECT_TRUE(file.meshes[0].albedo->isApprox(Rgb(0.2F, 0.3F, 0.4F)));
}

TEST_F(GltfFile, WrongFilesAreTheUsersInput) {
  const std::string mesh = R"([{"mesh":0}])";
  EXPECT_THAT(complaint(R"([{"children":[1]},{"children":[0]}])"), HasSubstr("cycle"));
  EXPECT_THAT(complaint(R"([{"children":[1,1]},{}])"), HasSubstr("two parents"));
  EXPECT_THAT(complaint(R"([{"mesh":7}])"), HasSubstr("nodes[0]"));
  EXPECT_THAT(complaint(mesh, R"({"attributes":{"NORMAL":0}})"), HasSubstr("POSITION"));
  EXPECT_THAT(complaint(mesh, R"({"attributes":{"POSITION":9}})"), HasSubstr("accessor that exists"));
  EXPECT_THAT(complaint(mesh, R"({"attributes":{"POSITION":1}})"), HasSubstr("3 components"));
  EXPECT_THAT(complaint(mesh, R"({"attributes":{"POSITION":0},"indices":0})"), HasSubstr("1 components"));
  const std::string far_index = square().substr(0, 48) + bytes_of<std::uint16_t>({0, 1, 200, 0, 2, 3});
  EXPECT_THAT(complaint(mesh, R"({"attributes":{"POSITION":0},"indices":1})", "", far_index),
              HasSubstr("indices under 4, found 200"));
  EXPECT_THAT(
      complaint(mesh, R"({"attributes":{"POSITION":0}})", R"(,"extensionsRequired":["KHR_texture_basisu"])"),
      HasSubstr("\"KHR_texture_basisu\" (pictures in KTX2; `gltf-transform ktxdecompress"));
  std::string not_a_number = square();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(not_a_number.data(), &nan, 4);
  EXPECT_THAT(complaint(mesh, R"({"attributes":{"POSITION":0}})", "", not_a_number), HasSubstr("finite"));
  EXPECT_THROW((void)read_scene_file("no/such/file.glb"), InputError);
}

TEST_F(GltfFile, HostileOffsetsStayInsideTheBuffer) {
  for (
      const char* accessor :
      {R"({"bufferView":0,"byteOffset":18446744073709551580,"componentType":5126,"type":"VEC3","count":3})",
       R"({"bufferView":0,"byteOffset":44,"componentType":5126,"type":"VEC3","count":1})",
       R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":150000000})",
       R"({"componentType":5126,"type":"VEC3","count":2,"sparse":{"count":1,"indices":{"bufferView":1,"byteOffset":-2,"componentType":5123},"values":{"bufferView":0}}})"}) {
    std::ofstream(path_)
        << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        << R"("buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)" << base64(square())
        << R"("}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],"accessors":[)"
        << accessor << "]}";
    EXPECT_THROW((void)read_scene_file(path_), InputError) << accessor;
  }
}

TEST(Placement, RollThenPitchThenYawThenPosition) {
  ObjectDefinition object;
  object.position_m = {1, 2, 3};
  object.rotation_deg = {0, 90, 0};
  object.scale = 2;
  // Yaw by 90 degrees about +Y takes -Z to -X.
  EXPECT_TRUE(
      (object_placement(object) * Eigen::Vector3d(0, 0, -1)).isApprox(Eigen::Vector3d(-1, 2, 3), 1e-12));
}

TEST(Placement, FarOriginsLoseNothing) {
  SceneFile file;
  file.meshes.resize(1);
  file.meshes[0].positions_m = {Eigen::Vector3d(1e6 + 0.001, 2, 3)};
  const auto parts = place_meshes(file, Eigen::Affine3d::Identity(), Eigen::Vector3d(1e6, 2, 0), 0.5, 0);
  EXPECT_NEAR(parts[0]->positions_m[0].x(), 0.001, 1e-9);
  EXPECT_FLOAT_EQ(parts[0]->positions_m[0].z(), 3.0F);
}

}  // namespace
}  // namespace seamline::renderer
