// Recorded joints move a figure: the file that comes out is read as any glTF file.
// `tests/sensors/recorded_figure.py` does the same with a skinned figure of fifteen joints, by NumPy.
#include "sensors/skeleton/figure_motion.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <utility>

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
  /// A file of chunks: of text, of bytes, and one of a kind that nobody knows.
  [[nodiscard]] std::filesystem::path glb(std::string text, const std::string& binary = "",
                                          const std::string& unknown = "") const {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t number) {
      return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(number)});
    };
    std::string chunks = word(text.size()) + "JSON" + text;
    if (!binary.empty()) chunks += word(binary.size()) + std::string("BIN\0", 4) + binary;
    if (!unknown.empty()) chunks += word(unknown.size()) + "MINE" + unknown;
    write_file_atomically(folder_ / "arm.glb", "glTF" + word(2) + word(12 + chunks.size()) + chunks);
    return folder_ / "arm.glb";
  }

  [[nodiscard]] std::filesystem::path figure(const std::string& of_stand = "",
                                             const std::string& unknown = "") const {
    const std::string points = bytes_of<float>({0, 0, 0, 0.1F, 0, 0, 0, 0.1F, 0});
    const std::string text = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],)"
        R"("bufferViews":[{{"buffer":0,"byteLength":{}}}],"accessors":[{{"bufferView":0,"componentType":5126,)"
        R"("type":"VEC3","count":3,"min":[0,0,0],"max":[0.1,0.1,0]}}],"scenes":[{{"nodes":[0]}}],"nodes":[)"
        R"({{"name":"stand",{}"translation":[1,2,3],"rotation":[0,0.6,0,0.8],"children":[1]}},)"
        R"({{"name":"shoulder","rotation":[0,-0.6,0,0.8],"children":[2]}},)"
        R"({{"name":"elbow","translation":[0.3,0,0],"rotation":[0.6,0,0,0.8],"children":[3]}},)"
        R"({{"name":"hand","translation":[0.3,0,0],"mesh":0}}],)"
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}]}})",
        points.size(), points.size(), of_stand);
    return glb(text, points, unknown);
  }

  [[nodiscard]] RecordedMotion recorded(const std::string& rows) const {
    write_file_atomically(folder_ / "arm.csv", "time_s,joint,x_m,y_m,z_m\n" + rows);
    return read_recorded_motion(folder_ / "arm.csv");
  }

  /// The animation is written, and the hand read from it as from any file.
  [[nodiscard]] Eigen::Vector3d written_hand(FigureFile& file, const RecordedMotion& motion,
                                             const FigureMotion& moved, double time_s) const {
    file.add_animation(fmt::format("at {}", time_s), motion.times_s, moved.nodes);
    write_file_atomically(folder_ / "moved.glb", file.bytes());
    return renderer::read_scene_moment(folder_ / "moved.glb", MaterialModel::diffuse,
                                       renderer::Transparency::refused,
                                       FileMoment{fmt::format("at {}", time_s), time_s})
        .meshes.at(0)
        .positions_m.at(0)
        .cast<double>();
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
  // Bones stay as long as the figure's: the elbow is 0.3 m too high, the hand also too near.
  EXPECT_NEAR(moved.rms_m[0], std::sqrt((0.09 + 0.18) / 3), 1e-6);
  EXPECT_LT(moved.rms_m[1], 1e-6);
  const auto hand_at = [&](double time_s) { return written_hand(figure_file, motion, moved, time_s); };
  EXPECT_LT((hand_at(0) - Eigen::Vector3d(0, 0.7, 0.3)).norm(), 1e-5);
  EXPECT_LT((hand_at(1) - Eigen::Vector3d(0.5, 1, 0.6)).norm(), 1e-5);
}

/// Also where a scale of unlike sides bends the bones, so that no turn brings the hand there.
TEST_F(FigureArm, TheErrorIsThatOfTheFileThatIsWritten) {
  const RecordedMotion motion = recorded("0,shoulder,0,1,0\n0,hand,0,0.8,0.15\n");
  FigureFile figure_file(figure(R"("scale":[2,1,0.5],)"));
  const FigureMotion moved = move_figure(figure_file, motion);
  const double off_m = (written_hand(figure_file, motion, moved, 0) - Eigen::Vector3d(0, 0.8, 0.15)).norm();
  EXPECT_GT(off_m, 0.01);
  EXPECT_NEAR(moved.rms_m[0] * std::sqrt(2), off_m, 1e-4);
}

/// Rows of an arm that stays where it is, seen with errors of 1 mm.
std::string noisy_arm(int moments, const Eigen::Vector3d& hand_m, int hand_every) {
  std::mt19937 bits(7);
  const auto noise_m = [&] { return 0.001 * (static_cast<double>(bits()) / 2147483648.0 - 1); };
  std::string rows;
  for (int t = 0; t < moments; ++t)
    for (const auto& [name, at_m] : {std::pair<std::string, Eigen::Vector3d>{"shoulder", {0, 1, 0}},
                                     {"elbow", {0.3, 1, 0}},
                                     {"hand", hand_m}}) {
      if (name == "hand" && t % hand_every != 0) continue;
      const double x_m = at_m.x() + noise_m(), y_m = at_m.y() + noise_m(), z_m = at_m.z() + noise_m();
      rows += fmt::format("{},{},{},{},{}\n", 0.1 * t, name, x_m, y_m, z_m);
    }
  return rows;
}

/// Of a node: the largest turn from one moment to the next.
double largest_step_deg(const MovedNode& moved) {
  double most_rad = 0;
  for (std::size_t t = 1; t < moved.rotations.size(); ++t)
    most_rad = std::max(most_rad, moved.rotations[t].angularDistance(moved.rotations[t - 1]));
  return most_rad * 180 / std::numbers::pi;
}

TEST_F(FigureArm, NoiseDoesNotTurnAStraightArmAboutItself) {
  const FigureMotion moved = move_figure(FigureFile(figure()), recorded(noisy_arm(40, {0.6, 1, 0}, 1)));
  for (const std::size_t joint : {0U, 1U}) {
    ASSERT_EQ(moved.nodes[joint].rotations.size(), 40U);
    EXPECT_LT(largest_step_deg(moved.nodes[joint]), 3) << joint;
    EXPECT_GT(largest_step_deg(moved.nodes[joint]), 0.01) << joint;  // it follows what was recorded
  }
}

TEST_F(FigureArm, AHandThatWasNotSeenStaysBesideItsArm) {
  const FigureMotion moved = move_figure(FigureFile(figure()), recorded(noisy_arm(40, {0.3, 1, 0.3}, 2)));
  for (const std::size_t joint : {0U, 1U}) EXPECT_LT(largest_step_deg(moved.nodes[joint]), 3) << joint;
  for (std::size_t t = 0; t < 40; t += 2) EXPECT_EQ(moved.turned_deg[1][t], moved.turned_deg[1][t + 1]) << t;
}

TEST_F(FigureArm, BonesKeepTheirLengthWhereAnElbowWasNotSeen) {
  const RecordedMotion motion =
      recorded("0,shoulder,0,1,0\n0,elbow,0,0.4,0\n0,hand,0,0.4,0.6\n1,shoulder,0,1,0\n1,hand,0,0.4,0.6\n");
  const FigureMotion moved = move_figure(FigureFile(figure()), motion);
  EXPECT_NEAR(moved.turned_deg[1][0], 90, 1e-3);
  EXPECT_NEAR(moved.turned_deg[1][1], 90, 1e-3);  // bones of 0.3 m could reach so far only stretched
}

TEST_F(FigureArm, TimeBeginsWithTheFirstMoment) {
  const auto arm_at = [](const std::string& time) { return time + ",hand,0,1,0\n"; };
  // Unix time: as floats these two would be one.
  const RecordedMotion now = recorded(arm_at("1700000000.5") + arm_at("1700000000.75"));
  EXPECT_EQ(now.times_s, (std::vector<double>{0, 0.25}));
  FigureFile figure_file(figure());
  const FigureMotion moved = move_figure(figure_file, now);
  EXPECT_LT((written_hand(figure_file, now, moved, 0.25) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-6);
  EXPECT_EQ(recorded(arm_at("-2") + arm_at("-1.5")).times_s, (std::vector<double>{0, 0.5}));
  const auto says = [&](const std::string& rows) {
    return test::complaint_of([&] { (void)recorded(rows); });
  };
  EXPECT_NE(says(arm_at("5") + arm_at("6") + arm_at("6.00000001"))
                .find("line 4: time_s: wanted a time that 32 bits, counted from 5 s, tell from 6 s"),
            std::string::npos);
  EXPECT_NE(says(arm_at("0") + arm_at("1e300")).find("line 3: time_s: wanted at most ten years"),
            std::string::npos);
  EXPECT_NE(test::complaint_of([&] {
              figure_file.add_animation("back", {-1, 0}, moved.nodes);
            }).find("times from 0 s that rise"),
            std::string::npos);
}

TEST_F(FigureArm, WhatAFileHoldsBesidesStays) {
  FigureFile figure_file(figure("", "of mine!"));
  figure_file.add_animation("still", {0}, {});
  EXPECT_TRUE(figure_file.bytes().ends_with("MINEof mine!"));

  const FigureFile named(glb(R"({"nodes":[{}],"images":[{"uri":"data:image/png;base64,"},)"
                             R"({"uri":"https://a/b.png"},{"uri":"skins/a.png"}]})"));
  EXPECT_EQ(test::complaint_of([&] { named.need_place_of(folder_ / "new.glb"); }), "no complaint");
  EXPECT_NE(test::complaint_of([&] { named.need_place_of(folder_ / "below" / "new.glb"); })
                .find(R"(images: wanted no files beside it, because the new file is in another folder, )"
                      R"(found "skins/a.png")"),
            std::string::npos);
}

TEST_F(FigureArm, ChildrenMayStandBeforeTheirParents) {
  std::string text = R"({"nodes":[{"translation":[1,0,0]})";
  for (int i = 1; i < 2000; ++i) text += fmt::format(R"(,{{"translation":[1,0,0],"children":[{}]}})", i - 1);
  const FigureFile chain(glb(text + "]}"));
  EXPECT_EQ(chain.nodes()[0].world.translation().x(), 2000);
  EXPECT_NE(test::complaint_of([&] {
              const FigureFile ring(glb(R"({"nodes":[{"children":[1]},{"children":[0]},{}]})"));
            }).find("no node that is its own ancestor"),
            std::string::npos);
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
  const auto adds = [](FigureFile file, const std::string& name) {
    return test::complaint_of([&] { file.add_animation(name, {0}, {}); });
  };
  EXPECT_EQ(adds(FigureFile(figure()), "wave\xFF"), "the animation's name: wanted UTF-8, found wave\\xFF");
  EXPECT_NE(adds(FigureFile(glb(R"({"nodes":[{}],"bufferViews":[{"buffer":"0"}]})")), "wave")
                .find("bufferViews: wanted the number of a buffer in each"),
            std::string::npos);
}

}  // namespace
}  // namespace seamline::sensors
