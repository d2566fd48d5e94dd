// Meshes that Draco and meshoptimizer compressed. The bytes were made by the two libraries' own encoders
// (Debian 12: Draco 1.5.5, meshoptimizer 0.18) of one rectangle: (0, 0), (1, 0), (1, 2), (0, 2) at z = 0.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "raytracer/scene/gltf/draco_mesh.h"
#include "raytracer/scene/gltf/meshopt_view.h"
#include "raytracer/scene/scene_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

using testing::HasSubstr;

constexpr const char* draco_bytes =
    "RFJBQ08CAgEBAAAABAIBAgAAAR//ARH/AREC/wAAAAAAAQAJAwAAAAECAgQAAQEAAAAAAAAAAAAAAAAAAIA/AAAAQAAAAAAAAAAAAAAAQAAAAAAAA"
    "IA/AAAAAAAAAAABAQEAAwMBMAEQAwAkgikxAgAAAAD/AAAA";

class GltfCompressed : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const std::filesystem::path path = folder_ / "compressed.gltf";
    write_file_atomically(path, text);
    return path;
  }
  /// The area of the rectangle that a file holds, and that every corner is one of it.
  static double area_m2(const SceneFile& file) {
    double area = 0;
    for (const FileMesh& mesh : file.meshes)
      for (const Triangle& t : mesh.triangles) {
        const Eigen::Vector3d across = (mesh.positions_m[t[1]] - mesh.positions_m[t[0]])
                                           .cross(mesh.positions_m[t[2]] - mesh.positions_m[t[0]]);
        EXPECT_GT(across.z(), 0);
        area += 0.5 * across.norm();
      }
    return area;
  }
  std::string draco(const std::string& bytes, int byte_length) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_draco_mesh_compression"],)"
        R"("extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],)"
        R"("buffers":[{{"byteLength":{0},"uri":"data:;base64,{1}"}}],"bufferViews":[{{"buffer":0,"byteLength":{0}}}],)"
        R"("accessors":[{{"componentType":5126,"type":"VEC3","count":4}},)"
        R"({{"componentType":5121,"normalized":true,"type":"VEC4","count":4}},)"
        R"({{"componentType":5123,"type":"SCALAR","count":6}}],"meshes":[{{"primitives":[{{"attributes":)"
        R"({{"POSITION":0,"COLOR_0":1}},"indices":2,"extensions":{{"KHR_draco_mesh_compression":)"
        R"({{"bufferView":0,"attributes":{{"POSITION":0,"COLOR_0":1}}}}}}}}]}}]}})",
        byte_length, bytes);
  }
  static std::string meshopt(const std::string& stride) {
    return R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_meshopt_compression"],)"
           R"("extensionsRequired":["EXT_meshopt_compression"],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],)"
           R"("buffers":[{"byteLength":62,"uri":"data:;base64,oAAAATMAAAD//wEzAAAAfn0AAAABDAAAAIAAAAAAAAAAAAAAAAAAAA)"
           R"(AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA="},{"byteLength":19,"uri":"data:;base64,4fAAAHaHVmd4qYZliWiYAWkAAA=="},)"
           R"({"byteLength":60}],"bufferViews":[{"buffer":2,"byteLength":48,"extensions":{"EXT_meshopt_compression":)"
           R"({"buffer":0,"byteLength":62,"byteStride":)" +
           stride +
           R"(,"mode":"ATTRIBUTES","count":4}}},{"buffer":2,"byteOffset":48,"byteLength":12,"extensions":)"
           R"({"EXT_meshopt_compression":{"buffer":1,"byteLength":19,"byteStride":2,"mode":"TRIANGLES","count":6}}}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},)"
           R"({"bufferView":1,"componentType":5123,"type":"SCALAR","count":6}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}]})";
  }
  const TemporaryFolder folder_;
};

TEST_F(GltfCompressed, DracosMeshIsDecodedOrItsLibraryNamed) {
  const std::filesystem::path path = write(draco(draco_bytes, 120));
  if (!has_draco()) {
    EXPECT_THAT(test::complaint_of([&] { (void)read_scene_file(path); }),
                HasSubstr("KHR_draco_mesh_compression: wanted Seamline built with Draco"));
    return;
  }
  const SceneFile file = read_scene_file(path);
  EXPECT_DOUBLE_EQ(area_m2(file), 2.0);
  ASSERT_EQ(file.meshes.size(), 1U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& at = file.meshes[0].positions_m[i];
    const Eigen::Array4f& colour = file.meshes[0].colours[i];
    EXPECT_EQ(colour[0], at.x() == at.y() / 2 && at.x() == 0 ? 1.0F : colour[0]);
    EXPECT_EQ(colour[3], 1.0F);
  }
}

TEST_F(GltfCompressed, MeshoptimizersViewsAreDecodedOrTheirLibraryNamed) {
  const std::filesystem::path path = write(meshopt("12"));
  if (!has_meshopt()) {
    EXPECT_THAT(test::complaint_of([&] { (void)read_scene_file(path); }),
                HasSubstr("EXT_meshopt_compression: wanted Seamline built with meshoptimizer"));
    return;
  }
  EXPECT_DOUBLE_EQ(area_m2(read_scene_file(path)), 2.0);
}

TEST_F(GltfCompressed, DamagedBytesNameTheExtension) {
  EXPECT_THAT(
      test::complaint_of([&] { (void)read_scene_file(write(draco("RFJBQ08AAAAAAAAAAAAAAA==", 16))); }),
      HasSubstr("KHR_draco_mesh_compression"));
  EXPECT_THAT(test::complaint_of([&] { (void)read_scene_file(write(meshopt("16"))); }),
              HasSubstr("EXT_meshopt_compression"));
  for (const char* stride : {"0", "-4", "257", "9223372036854775807"})
    EXPECT_THAT(test::complaint_of([&] { (void)read_scene_file(write(meshopt(stride))); }),
                HasSubstr("compressed.gltf: "))
        << stride;
}

}  // namespace
}  // namespace seamline::renderer
