// Recorded joints move a figure: the file that comes out is read as any glTF file.
// `tests/sensors/recorded_figure.py` does the same with a skinned figure of fifteen joints, by NumPy.
#include "sensors/skeleton/figure_motion.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "raytracer/scene/scene_moment.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/renderer/gltf_bytes.h"

namespace seamline::sensors {
namespace {

using test::bytes_of;

/// An arm of bones of 0.3 m along x, each node with axes of its own, and a triangle that begins at the hand.
class FigureArm : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path figure() const {
    const std::string points = bytes_of<float>({0, 0, 0, 0.1F, 0, 0, 0, 0.1F, 0});
    std::string text = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],)"
        R"("bufferViews":[{{"buffer":0,"byteLength":{}}}],"accessors":[{{"bufferView":0,"componentType":5126,)"
        R"("type":"VEC3","count":3,"min":[0,0,0],"max":[0.1,0.1,0]}}],"scenes":[{{"nodes":[0]}}],"nodes":[)"
        R"({{"name":"stand","translation":[1,2,3],"rotation":[0,0.6,0,0.8],"children":[1]}},)"
        R"({{"name":"shoulder","rotation":[0,-0.6,0,0.8],"children":[2]}},)"
        R"({{"name":"elbow","translation":[0.3,0,0],"rotation":[0.6,0,0,0.8],"children":[3]}},)"
        R"({{"name":"hand","translation":[0.3,0,0],"mesh":0}}],)"
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}]}})",
        points.size(), points.size());
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t number) {
      return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(number)});
    };
    const std::string chunks =
        word(text.size()) + "JSON" + text + word(points.size()) + std::string("BIN\0", 4) + points;
    write_file_atomically(folder_ / "arm.glb", "glTF" + word(2) + word(12 + chunks.size()) + chunks);
    return folder_ / "arm.glb";
  }

  [[nodiscard]] RecordedMotion recorded(const std::string& rows) const {
    write_file_atomically(folder_ / "arm.csv", "time_s,joint,x_m,y_m,z_m\n" + rows);
    return read_recorded_motion(folder_ / "arm.csv");
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
};

/// At 0 s the arm hangs from (0, 1, 0) with its hand forwards, of bones twice as long; at 1 s it is stretched
/// along z.
constexpr const char* arm_rows =
    "0,shoulder,0,1,0\n0,elbow,0,0.4,0\n0,hand,0,0.4,0.6\n"
    "1,shoulder,0.5,1,0\n1,elbow,0.5,1,0.3\n1,hand,0.5,1,0.6\n";

TEST_F(FigureArm, IsWhereItsJointsWereRecorded) {
  const RecordedMotion motion = recorded(arm_rows);
  FigureFile figure_file(figure());
  const FigureMotion moved = move_figure(figure_file, motion);
  EXPECT_LT(moved.rms_m[0], 1e-6);
  EXPECT_LT(moved.rms_m[1], 1e-6);
  figure_file.add_animation("recorded", motion.times_s, moved.nodes);
  write_file_atomically(folder_ / "moved.glb", figure_file.bytes());
  const auto hand_at = [&](double time_s) -> Eigen::Vector3d {
    return renderer::read_scene_moment(folder_ / "moved.glb", MaterialModel::diffuse,
                                       renderer::Transparency::refused, FileMoment{"recorded", time_s})
        .meshes.at(0)
        .positions_m.at(0)
        .cast<double>();
  };
  // Bones stay as long as the figure's.
  EXPECT_LT((hand_at(0) - Eigen::Vector3d(0, 0.7, 0.3)).norm(), 1e-5);
  EXPECT_LT((hand_at(1) - Eigen::Vector3d(0.5, 1, 0.6)).norm(), 1e-5);
}

TEST_F(FigureArm, AGestureLastsAsLongAsItsAngles) {
  const RecordedMotion motion = recorded(arm_rows);
  const FigureMotion moved = move_figure(FigureFile(figure()), motion);
  ASSERT_EQ(motion.joints, (std::vector<std::string>{"shoulder", "elbow", "hand"}));
  EXPECT_NEAR(moved.turned_deg[0][0], 90, 1e-3);
  EXPECT_NEAR(moved.turned_deg[1][0], 90, 1e-3);
  EXPECT_NEAR(moved.turned_deg[1][1], 0, 1e-3);
  write_file_atomically(folder_ / "gestures.toml",
                        "format = \"seamline gestures 1\"\n[[gesture]]\nname = \"bent\"\n"
                        "turned_deg = { elbow = [60, 120] }\n[[gesture]]\nname = \"folded\"\n"
                        "turned_deg = { elbow = [150, 180], shoulder = [0, 180] }\n");
  const std::vector<Gesture> gestures = read_gestures(folder_ / "gestures.toml", motion.joints);
  ASSERT_EQ(gestures.size(), 2U);
  EXPECT_EQ(times_of(gestures[0], moved, motion.times_s), (std::vector<std::pair<double, double>>{{0, 0}}));
  EXPECT_TRUE(times_of(gestures[1], moved, motion.times_s).empty());
}

TEST_F(FigureArm, AJointThatWasNotSeenHangsOnTheOthers) {
  const RecordedMotion motion =
      recorded("0,shoulder,0,1,0\n0,elbow,0,0.7,0\n0,hand,0,0.4,0\n1,hand,0,0.4,0\n");
  const FigureMotion moved = move_figure(FigureFile(figure()), motion);
  EXPECT_LT(moved.rms_m[1], 1e-4);
  EXPECT_NEAR(moved.turned_deg[0][1], 90, 1);
}

TEST_F(FigureArm, WhatIsWrongIsNamed) {
  const auto says = [&](const std::string& rows) {
    return test::complaint_of([&] { (void)move_figure(FigureFile(figure()), recorded(rows)); });
  };
  EXPECT_EQ(says("0,knee,0,1,0\n"), "joint \"knee\": wanted a node of its name in the figure, found none");
  EXPECT_NE(says("1,hand,0,1,0\n0,hand,0,1,0\n").find("line 3: time_s: wanted no time before 1 s"),
            std::string::npos);
  EXPECT_NE(says("0,hand,0,1,0\n0,hand,0,1,0\n").find("a joint once in a moment"), std::string::npos);
  write_file_atomically(folder_ / "no.glb", "glTF, it says");
  EXPECT_NE(
      test::complaint_of([&] { FigureFile no(folder_ / "no.glb"); }).find("wanted a .glb file (glTF 2.0)"),
      std::string::npos);
}

}  // namespace
}  // namespace seamline::sensors
