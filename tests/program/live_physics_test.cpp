// Things that fall in a recording, as people ask for it.
#include <array>
#include <cstring>

#include "physics/rigid_world.h"
#include "refusal.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::run_seamline;

/// A floor and what stands on it, seen by a small sensor.
fs::path recorded(const fs::path& folder) {
  const test::Outcome outcome = run_seamline(
      "record builtin:bedroom --preset tof_160x120 --frames 2 --spp 1 --bounces 0 --noise 0.1 --at 0.4 1.5 "
      "-1.5 --look-at 0.1 0.5 -4.2 --angle 2 --out " +
      (folder / "recording").string());
  if (outcome.status != 0) throw std::runtime_error(outcome.output);
  return folder / "recording";
}

TEST(LivePhysics, HasTheSamePosesAndPicturesForOneAndTwoThreads) {
  const fs::path folder = test::fresh_folder("live-physics");
  const std::string live = "live " + recorded(folder).string() +
                           " --object builtin:teapot --at 0.2 0 -4 --height 0.2 --size 200x150 "
                           "--headless ";
  const auto in = [&](const std::string& name) { return (folder / name).string(); };
  ASSERT_EQ(run_seamline(live + "--frames 2 --csv " + in("off.csv") + " --out " + in("off")).status, 0);
  EXPECT_EQ(test::read_text(folder / "off.csv").find("physics"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "off_poses.csv"));
  test::expect_refused(live + "--time --drop 0.2", "--physics beside it");
  if (!renderer::has_physics()) {
    test::expect_refused(live + "--time --physics", "built with Bullet");
    return;
  }
  const auto fall = [&](const std::string& name, const std::string& threads) {
    const test::Outcome outcome = run_seamline(live + "--physics --frames 40 --csv " + in(name + ".csv") +
                                               " --out " + in(name) + " --threads " + threads);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_THAT(outcome.output, testing::HasSubstr("physics"));
    EXPECT_THAT(outcome.output, testing::HasSubstr("teapot after 1."));
  };
  fall("one", "1");
  fall("two", "2");
  EXPECT_NE(test::read_text(folder / "one.csv").find("physics_ms"), std::string::npos);
  const std::string poses = test::read_text(folder / "one_poses.csv");
  EXPECT_EQ(std::count(poses.begin(), poses.end(), '\n'), 41);
  EXPECT_EQ(poses, test::read_text(folder / "two_poses.csv"));
  for (const char* picture : {"000000.png", "000020.png", "000039.png"})
    EXPECT_EQ(test::read_text(folder / "one" / picture), test::read_text(folder / "two" / picture));
  const test::Outcome nowhere =
      run_seamline("live " + in("recording") +
                   " --object builtin:teapot --at 0.3 0 -30 --height 0.2 --headless --time --physics");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_THAT(nowhere.output, testing::HasSubstr("seamline: --physics of builtin:teapot: wanted a surface"));
}

TEST(LivePhysics, WhatFallsPastASceneThatIsZUpIsToldSo) {
  const fs::path folder = test::fresh_folder("settle-z-up");
  // The floor of somebody whose Z is up: it stands upright.
  const std::array<float, 18> corners = {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, -2, 0, 2, 2, 0, -2, 2, 0};
  std::string bytes(sizeof corners, '\0');
  std::memcpy(bytes.data(), corners.data(), sizeof corners);
  test::write_text(folder / "a.bin", bytes);
  test::write_text(
      folder / "floor.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":72,"uri":"a.bin"}],"bufferViews":[{"buffer":0,"byteLength":72}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})");
  const auto settled = [&](const std::string& scene, const std::string& position) {
    return "settle " + scene + " --sensor tof_160x120 --ball 0.1 --position " + position +
           " --frames 2 --out " + (folder / "out").string();
  };
  const std::string floor = (folder / "floor.gltf").string();
  const std::string upright = settled(floor + " --at 0 0 3 --look-at 0 0 0", "0 0 1"),
                    beside = settled("builtin:bedroom", "60 0 0");
  if (!renderer::has_physics()) return test::expect_refused(upright, "built with Bullet");
  const auto lost = [&](const std::string& command) {
    const test::Outcome outcome = run_seamline(command);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_THAT(outcome.output, testing::HasSubstr("falls out of the scene in frame"));
    return outcome.output;
  };
  EXPECT_THAT(lost(upright), testing::HasSubstr(": glTF is Y-up, and the file may be Z-up"));
  EXPECT_THAT(lost(beside), testing::Not(testing::HasSubstr("Z-up")));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(LivePhysics, ProgressOfASettlingBodyEndsWithItsLastFrame) {
  const std::string command =
      "settle builtin:bedroom --sensor tof_160x120 --ball 0.1 --position 0 1 0 --frames 2 --frames-to-rest 0 "
      "--out " +
      (test::fresh_folder("settle-progress") / "out").string();
  if (!renderer::has_physics()) return test::expect_refused(command, "built with Bullet");
  const test::Outcome outcome = run_seamline(command);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  std::size_t ends = 0;
  for (std::size_t at = outcome.output.find("100 %"); at != std::string::npos;
       at = outcome.output.find("100 %", at + 1))
    ++ends;
  EXPECT_EQ(ends, 1U) << outcome.output;
}

}  // namespace
}  // namespace seamline
