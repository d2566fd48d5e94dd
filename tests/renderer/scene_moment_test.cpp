// Moments of animations of glTF files, beside the specification's own arithmetic (numbers by NumPy and
// SciPy's Slerp).
#include "raytracer/scene/scene_moment.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/renderer/gltf_bytes.h"

namespace seamline::renderer {
namespace {

using test::bytes_of;
using testing::ElementsAre;
using testing::HasSubstr;

/// Nodes 0 (a root) and 1 (its child, which has a triangle with a morph target), and animations.
class AnimatedFile : public testing::Test {
 protected:
  AnimatedFile() {
    add(bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), "VEC3", 3);
    add(bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}), "VEC3", 3);
  }

  int add(const std::string& bytes, const char* type, std::size_t count) {
    views_ += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})", accessors_ > 0 ? "," : "",
                          buffer_.size(), bytes.size());
    texts_ += fmt::format(R"({}{{"bufferView":{},"componentType":5126,"type":"{}","count":{}}})",
                          accessors_ > 0 ? "," : "", accessors_, type, count);
    buffer_ += bytes;
    return accessors_++;
  }

  /// A channel at 1 s, 2 s and 4 s.
  void animate(int node, const char* path, const char* by, const std::vector<float>& numbers,
               const char* type, std::size_t count) {
    if (times_ < 0) times_ = add(bytes_of<float>({1, 2, 4}), "SCALAR", 3);
    std::string bytes;
    for (const float number : numbers) bytes += bytes_of<float>({number});
    const int output = add(bytes, type, count);
    channels_ += fmt::format(R"({}{{"sampler":{},"target":{{"node":{},"path":"{}"}}}})", made_ > 0 ? "," : "",
                             made_, node, path);
    samplers_ += fmt::format(R"({}{{"input":{},"output":{},"interpolation":"{}"}})", made_ > 0 ? "," : "",
                             times_, output, by);
    ++made_;
  }

  std::filesystem::path gltf(const std::string& more = "", const std::string& of_root = "") {
    const std::filesystem::path path = folder_ / "moving.gltf";
    write_file_atomically(folder_ / "moving.bin", buffer_);
    write_file_atomically(
        path,
        fmt::format(
            R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{},"uri":"moving.bin"}}],)"
            R"("bufferViews":[{}],"accessors":[{}],"scenes":[{{"nodes":[0]}}],)"
            R"("nodes":{},"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{}}},"targets":[{{"POSITION":1}}]}}]}}],)"
            R"("animations":[{{"name":"Open","channels":[{}],"samplers":[{}]}}{}]}})",
            buffer_.size(), views_, texts_,
            nodes_.empty()
                ? fmt::format(R"([{{"children":[1]{}}},{{"mesh":0,"translation":[1,0,0]}}])", of_root)
                : nodes_,
            attributes_, channels_, samplers_, more));
    return path;
  }

  /// The triangle's second corner, (1, 0, 0) in its node.
  Eigen::Vector3d corner_at(double time_s, const std::string& name = "Open") {
    return read_scene_moment(gltf(), MaterialModel::diffuse, Transparency::refused, FileMoment{name, time_s})
        .meshes.at(0)
        .positions_m.at(1);
  }

  const TemporaryFolder folder_;
  std::string nodes_, attributes_;  ///< in place of the usual nodes, and beside the positions

 private:
  std::string buffer_, views_, texts_, channels_, samplers_;
  int accessors_ = 0, times_ = -1, made_ = 0;
};

// Turns of 16 bits have lengths that are off by 3e-5: three.js takes them so, this reader makes them 1.
TEST(SceneMoments, VerticesAreWhereThreeJsHasThem) {
  const std::filesystem::path data = std::filesystem::path(SEAMLINE_SOURCE_DIR) / "tests" / "data";
  const nlohmann::json theirs = nlohmann::json::parse(read_file(data / "animations.json"));
  std::size_t compared = 0;
  for (const auto& moment : theirs.at("moments")) {
    const SceneFile file = read_scene_moment(data / "animations.gltf", MaterialModel::diffuse,
                                             Transparency::refused, FileMoment{"All", moment.at("time_s")});
    ASSERT_EQ(file.meshes.size(), moment.at("meshes").size());
    for (std::size_t m = 0; m < file.meshes.size(); ++m) {
      const auto& mesh = moment.at("meshes").at(m);
      EXPECT_EQ(file.meshes[m].name, mesh.at("name"));
      ASSERT_EQ(file.meshes[m].positions_m.size(), mesh.at("positions").size());
      for (std::size_t i = 0; i < file.meshes[m].positions_m.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis, ++compared)
          EXPECT_NEAR(file.meshes[m].positions_m[i][static_cast<Eigen::Index>(axis)],
                      mesh.at("positions").at(i).at(axis).get<double>(), 1e-3)
              << moment.at("time_s") << " s, " << file.meshes[m].name << " " << i;
    }
  }
  EXPECT_EQ(compared, 6U * 2 * 9 * 3);
}

TEST_F(AnimatedFile, LinesStepsAndTurnsMoveTheNodesBelow) {
  animate(0, "translation", "LINEAR", {0, 0, 0, 2, 4, 6, 2, 4, 0}, "VEC3", 3);
  animate(1, "scale", "STEP", {1, 1, 1, 3, 3, 3, 5, 5, 5}, "VEC3", 3);
  // A half turn about Z from 2 s to 4 s, told the long way round: the shorter one is taken.
  animate(0, "rotation", "LINEAR", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -0.8F, -0.6F}, "VEC4", 3);
  EXPECT_TRUE(corner_at(0).isApprox(Eigen::Vector3d(2, 0, 0), 1e-6)) << "before its first key";
  EXPECT_TRUE(corner_at(1.5).isApprox(Eigen::Vector3d(3, 2, 3), 1e-6)) << corner_at(1.5).transpose();
  // Half of 2 atan2(0.8, 0.6) rad about Z at 3 s: (1 + 3) (0.6, 0.8) and (2, 4, 3).
  EXPECT_TRUE(corner_at(3).isApprox(Eigen::Vector3d(2 + 4 * 0.6, 4 + 4 * 0.8, 3), 1e-6))
      << corner_at(3).transpose();
  const double turned = 1 - 2 * 0.8 * 0.8, across = 2 * 0.8 * 0.6;
  EXPECT_TRUE(corner_at(9).isApprox(Eigen::Vector3d(2 + 6 * turned, 4 + 6 * across, 0), 1e-6))
      << "after its last";
}

TEST_F(AnimatedFile, CubicSplinesHaveTangentsPerSecond) {
  animate(0, "translation", "CUBICSPLINE",
          {0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0, 0, 3, 0, 0, 0, 0, 3, 1, 0, 0, 0, 0}, "VEC3", 9);
  // x at 1.25 s: h = 1 s, t = 0.25; x at 3 s: h = 2 s, t = 0.5; y likewise
  // (scipy.interpolate.CubicHermiteSpline).
  EXPECT_NEAR(corner_at(1.25).x(), 2 + 0.203125, 1e-6);
  EXPECT_NEAR(corner_at(1.25).y(), 0.15625, 1e-6);
  EXPECT_NEAR(corner_at(3).x(), 2 + 2.0, 1e-6);
  EXPECT_NEAR(corner_at(3).y(), 1.75, 1e-6);
  EXPECT_NEAR(corner_at(2).x(), 2 + 1.0, 1e-6);
}

TEST_F(AnimatedFile, MorphWeightsAreAnimated) {
  animate(1, "weights", "LINEAR", {0, 1, 0}, "SCALAR", 3);
  EXPECT_TRUE(corner_at(1.25).isApprox(Eigen::Vector3d(2, 0, 0.25), 1e-6));
  EXPECT_TRUE(corner_at(3, "").isApprox(Eigen::Vector3d(2, 0, 0.5), 1e-6)) << "the file's only animation";
}

TEST_F(AnimatedFile, AnAnimatedJointTakesItsPartOfASkinAlong) {
  const int joints = add(bytes_of<float>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}), "VEC4", 3);
  const int weights = add(bytes_of<float>({1, 0, 0, 0, 0.25F, 0.75F, 0, 0, 0, 1, 0, 0}), "VEC4", 3);
  animate(1, "translation", "LINEAR", {0, 0, 0, 0, 4, 0, 0, 4, 8}, "VEC3", 3);
  // The skin is node 1's, whose own place says nothing; its joints are the root and node 1.
  nodes_ = R"([{"children":[1]},{"mesh":0,"skin":0}])";
  attributes_ = fmt::format(R"(,"JOINTS_0":{},"WEIGHTS_0":{})", joints, weights);
  const std::filesystem::path path = gltf(R"(],"skins":[{"joints":[0,1]})");
  const auto corners =
      read_scene_moment(path, MaterialModel::diffuse, Transparency::refused, FileMoment{"Open", 3})
          .meshes.at(0)
          .positions_m;
  EXPECT_TRUE(corners.at(0).isApprox(Eigen::Vector3d(0, 0, 0)) || corners.at(0).norm() < 1e-9);
  EXPECT_TRUE(corners.at(1).isApprox(Eigen::Vector3d(1, 3, 3), 1e-6)) << corners.at(1).transpose();
  EXPECT_TRUE(corners.at(2).isApprox(Eigen::Vector3d(0, 5, 4), 1e-6)) << corners.at(2).transpose();
}

TEST_F(AnimatedFile, ANodeStandsWhereItIsPutAndWhatHangsOnItWithIt) {
  animate(0, "translation", "LINEAR", {9, 9, 9, 9, 9, 9, 9, 9, 9}, "VEC3", 3);
  const auto corners = [&](FileMoment moment) {
    return read_scene_moment(gltf("", R"(,"name":"leaf","rotation":[0,0,0.6,0.8])"), MaterialModel::diffuse,
                             Transparency::refused, moment)
        .meshes.at(0)
        .positions_m;
  };
  const FileMoment moved{.is_animated = false, .nodes = {{"leaf", {1, 2, 3}, {0, 90, 0}}}};
  // The child stands at (1, 0, 0) of the leaf, whose own turn takes that to (0.28, 0.96, 0), 90 degrees of
  // yaw to (0, 0.96, -0.28).
  EXPECT_TRUE(corners(moved).at(0).isApprox(Eigen::Vector3d(1, 2.96, 2.72), 1e-6)) << corners(moved).at(0);
  FileMoment both = moved;
  both.animation = "Open", both.is_animated = true;
  EXPECT_TRUE(corners(both).at(0).isApprox(Eigen::Vector3d(10, 11.96, 11.72), 1e-6)) << corners(both).at(0);
  const std::string unknown = test::complaint_of([&] {
    (void)corners({.is_animated = false, .nodes = {{"laef", {1, 0, 0}}}});
  });
  EXPECT_THAT(unknown, HasSubstr("node \"laef\""));
  EXPECT_THAT(unknown, HasSubstr("did you mean \"leaf\"?"));
}

TEST_F(AnimatedFile, AnimationsWithoutNamesHaveNumbers) {
  animate(0, "translation", "LINEAR", {1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3", 3);
  const std::filesystem::path path = gltf(
      R"(,{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],"samplers":[{"input":2,"output":3}]})");
  const auto corner = [&](const std::string& name) -> Eigen::Vector3d {
    return read_scene_moment(path, MaterialModel::diffuse, Transparency::refused, FileMoment{name, 0})
        .meshes.at(0)
        .positions_m.at(1);
  };
  EXPECT_TRUE(corner("0").isApprox(Eigen::Vector3d(3, 0, 0)));
  EXPECT_TRUE(corner("1").isApprox(Eigen::Vector3d(2, 0, 0)));
}

TEST_F(AnimatedFile, AtRestNothingIsPlayedAndWhatIsPlayedIsNotLeftOut) {
  animate(0, "translation", "LINEAR", {9, 9, 9, 9, 9, 9, 9, 9, 9}, "VEC3", 3);
  const SceneFile rest = read_scene_file(gltf());
  EXPECT_TRUE(rest.meshes.at(0).positions_m.at(0).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_THAT(rest.left_out, ElementsAre("1 animation (everything is shown at rest)"));
  EXPECT_THAT(read_scene_moment(gltf(), MaterialModel::diffuse, Transparency::refused, FileMoment{"Open", 1})
                  .left_out,
              ElementsAre());
}

TEST_F(AnimatedFile, WhatIsWrongIsSaidByName) {
  animate(0, "translation", "LINEAR", {0, 0, 0, 2, 4, 6, 2, 4, 0}, "VEC3", 3);
  const auto said = [&](const std::string& name, const std::string& more = "",
                        const std::string& of_root = "") {
    return test::complaint_of([&] {
      (void)read_scene_moment(gltf(more, of_root), MaterialModel::diffuse, Transparency::refused,
                              FileMoment{name, 1});
    });
  };
  EXPECT_THAT(said("Shut"), HasSubstr("animation \"Shut\": wanted one of \"Open\", found another name"));
  EXPECT_THAT(
      said(
          "Shut",
          R"(,{"name":"Shut","channels":[{"sampler":0,"target":{"node":7,"path":"scale"}}],"samplers":[{}]})"),
      HasSubstr("animations[1].channels[0].target.node: wanted a node that exists"));
  EXPECT_THAT(
      said(
          "Shut",
          R"(,{"name":"Shut","channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}],"samplers":[{"input":0,"output":0}]})"),
      HasSubstr("channels[0].input"));
  EXPECT_THAT(
      said(
          "Shut",
          R"(,{"name":"Shut","channels":[{"sampler":0,"target":{"node":0,"path":"scale"}}],"samplers":[{"input":2,"output":2}]})"),
      HasSubstr("channels[0].output"));
  EXPECT_THAT(said("Shut", R"(,{"name":"Shut","channels":{},"samplers":[]})"),
              HasSubstr("animations[1]: wanted channels"));
  EXPECT_THAT(said("Shut", R"(,7)"), HasSubstr("wanted one of"));
  EXPECT_THAT(said("Open", "", R"(,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])"),
              HasSubstr("found a matrix"));
}

}  // namespace
}  // namespace seamline::renderer
