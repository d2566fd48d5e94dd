// glTF files that ask for too much, or for what is not theirs.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "raytracer/scene/scene_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class GltfLimits : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "scene");
    write_file_atomically(folder_ / "scene" / "buffer.bin", std::string(48, '\0'));
    write_file_atomically(folder_ / "outside.bin", std::string(48, '\0'));
  }

  /// What is said to a glTF file of these bytes.
  std::string complaint(const std::string& bytes, const char* name = "scene.gltf") {
    write_file_atomically(folder_ / "scene" / name, bytes);
    try {
      (void)read_scene_file(folder_ / "scene" / name);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(name), HasSubstr(": wanted "), HasSubstr(", found ")));
      return error.what();
    }
    return "no complaint";
  }
  const TemporaryFolder folder_;
};

/// One triangle of zeros; the parts may be replaced.
struct GltfParts {
  std::string buffers = R"([{"byteLength":48,"uri":"buffer.bin"}])";
  std::string accessor = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":3})";
  std::string nodes = R"([{"mesh":0}])";
  std::string scene_nodes = "0";
  std::string more = {};
};

std::string gltf(const GltfParts& parts) {
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"buffers":{},"bufferViews":[{{"buffer":0,"byteLength":48}}],)"
      R"("accessors":[{}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"nodes":{},)"
      R"("scenes":[{{"nodes":[{}]}}]{}}})",
      parts.buffers, parts.accessor, parts.nodes, parts.scene_nodes, parts.more);
}

std::string glb(const std::string& json, const std::string& binary) {
  const auto number = [](std::size_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    std::string four(4, '\0');
    std::memcpy(four.data(), &narrow, 4);
    return four;
  };
  const std::string text = json + std::string((4 - json.size() % 4) % 4, ' ');
  return "glTF" + number(2) + number(28 + text.size() + binary.size()) + number(text.size()) + "JSON" + text +
         number(binary.size()) + std::string("BIN\0", 4) + binary;
}

TEST_F(GltfLimits, AGoodFileReads) {
  EXPECT_EQ(complaint(gltf({})), "no complaint");
  EXPECT_EQ(complaint("\xEF\xBB\xBF" + gltf({})), "no complaint");  // a mark of byte order
  EXPECT_EQ(complaint(glb(gltf({.buffers = R"([{"byteLength":48}])"}), std::string(48, '\0')), "scene.glb"),
            "no complaint");
}

TEST_F(GltfLimits, BuffersLieInTheFilesOwnFolder) {
  for (const std::string uri :
       {"../outside.bin", "%2e%2e/outside.bin", "/dev/zero", "../scene/../outside.bin"})
    EXPECT_THAT(complaint(gltf({.buffers = fmt::format(R"([{{"byteLength":48,"uri":"{}"}}])", uri)})),
                HasSubstr("which leads out of it"))
        << uri;
  fs::create_symlink(folder_ / "outside.bin", folder_ / "scene" / "link.bin");
  EXPECT_THAT(complaint(gltf({.buffers = R"([{"byteLength":48,"uri":"link.bin"}])"})),
              HasSubstr("which leads out of it"));
  EXPECT_EQ(complaint(gltf({.buffers = R"([{"byteLength":48,"uri":"no/such/folder/../../../buffer.bin"}])"})),
            "no complaint");
}

TEST_F(GltfLimits, ClaimsOfManyVerticesTakeNoMemory) {
  for (const char* count : {"2147483648", "40000001", "18446744073709551615", "5"}) {
    const std::string dense =
        fmt::format(R"({{"bufferView":0,"componentType":5126,"type":"VEC3","count":{}}})", count);
    EXPECT_THAT(complaint(gltf({.accessor = dense})), HasSubstr("meshes[0].primitives[0]")) << count;
  }
  // Zeros that no buffer holds are the claim that costs nothing to make.
  for (const char* count : {"2147483648", "40000001"}) {
    const std::string sparse = fmt::format(
        R"({{"componentType":5126,"type":"VEC3","count":{},"sparse":{{"count":1,"indices":{{"bufferView":0,)"
        R"("componentType":5121}},"values":{{"bufferView":0}}}}}})",
        count);
    EXPECT_THAT(complaint(gltf({.accessor = sparse})), HasSubstr("at most 40000000 placed vertices"))
        << count;
  }
}

TEST_F(GltfLimits, AMeshPlacedAgainAndAgainIsCountedEachTime) {
  const std::string sparse =
      R"({"componentType":5126,"type":"VEC3","count":1000000,"sparse":{"count":1,"indices":{"bufferView":0,)"
      R"("componentType":5121},"values":{"bufferView":0}}})";
  std::string nodes = "[", roots;
  for (int i = 0; i < 41; ++i) {
    nodes += i == 0 ? R"({"mesh":0})" : R"(,{"mesh":0})";
    roots += (i == 0 ? "" : ",") + std::to_string(i);
  }
  // Half the vertices are triangles without area; it is their number that counts.
  EXPECT_THAT(complaint(gltf({.accessor = sparse, .nodes = nodes + "]", .scene_nodes = roots})),
              HasSubstr("at most 40000000 placed vertices"));
}

TEST_F(GltfLimits, NodesAreATreeThatIsNotTooDeep) {
  EXPECT_THAT(complaint(gltf({.nodes = R"([{"mesh":0,"children":[0]}])"})), HasSubstr("a cycle"));
  EXPECT_THAT(complaint(gltf({.nodes = R"([{"children":[1]},{"children":[0]}])"})), HasSubstr("a cycle"));
  EXPECT_THAT(
      complaint(gltf({.nodes = R"([{"children":[2]},{"children":[2]},{"mesh":0}])", .scene_nodes = "0,1"})),
      HasSubstr("two parents"));
  const auto chain = [](int nodes) {
    std::string text = "[";
    for (int i = 1; i < nodes; ++i) text += fmt::format(R"({{"children":[{}]}},)", i);
    return text + R"({"mesh":0}])";
  };
  EXPECT_EQ(complaint(gltf({.nodes = chain(limits::deepest_node_tree)})), "no complaint");
  EXPECT_THAT(complaint(gltf({.nodes = chain(100000)})), HasSubstr("one too deep"));
}

TEST_F(GltfLimits, NestingIsBoundedBeforeAnythingParsesIt) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(complaint(gltf({.more = ",\"extras\":" + deep})), HasSubstr("at most 128 levels"));
}

TEST_F(GltfLimits, CopiesOfOneChunkAreBounded) {
  std::string many = "[";
  for (int i = 0; i < 1025; ++i) many += R"({"byteLength":48},)";
  many.back() = ']';
  EXPECT_THAT(complaint(glb(gltf({.buffers = many}), std::string(48, '\0')), "scene.glb"),
              HasSubstr("at most 1024 buffers"));
  for (const char* length : {"0", "-1", "1e3", "\"48\"", "4293918721"})
    EXPECT_THAT(complaint(glb(gltf({.buffers = fmt::format(R"([{{"byteLength":{}}}])", length)}),
                              std::string(48, '\0')),
                          "scene.glb"),
                HasSubstr("buffers[0]"))
        << length;
}

TEST_F(GltfLimits, PicturesAnimationsAndExtrasAreNotEvenLookedAt) {
  EXPECT_EQ(
      complaint(gltf({.more = R"(,"images":[{"uri":"/dev/zero"},{"bufferView":77,"mimeType":"image/png"}],)"
                              R"("textures":[3],"skins":"none","animations":[[]],"extras":[1])"})),
      "no complaint");
}

TEST_F(GltfLimits, FilesThatEndTooSoon) {
  const std::string whole = glb(gltf({.buffers = R"([{"byteLength":48}])"}), std::string(48, '\0'));
  for (std::size_t length = 0; length < whole.size(); length += 3)
    EXPECT_NE(complaint(whole.substr(0, length), "scene.glb"), "no complaint") << length;
}

}  // namespace
}  // namespace seamline::renderer
