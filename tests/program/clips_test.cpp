#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.h"
#include "running_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The small study's second scene as clips of three frames a quarter of a second apart; its left object
/// moves.
std::string moving_study(const std::string& depth, const std::string& speed_m_s) {
  return test::small_study_with(
      {{"depth_width_px = [64, 256, 512, 1024, 2048]",
        "depth_width_px = [64]\n" + depth + "[clip]\nframes = 3\nframes_per_s = 4\n"},
       {"position_m = [-3.0, 0.0, -7.0]",
        "position_m = [-3.0, 0.0, -7.0]\n  path = { kind = \"line\", to_m = [-2.0, 0.0, -7.0], speed_m_s = " +
            speed_m_s + " }"}});
}

std::string still_study(const std::string& x_m) {
  return test::small_study_with(
      {{"depth_width_px = [64, 256, 512, 1024, 2048]", "depth_width_px = [64]"},
       {"position_m = [-3.0, 0.0, -7.0]", "position_m = [" + x_m + ", 0.0, -7.0]"}});
}

/// Renders some stimuli of a study in a folder of its own; returns the set.
fs::path rendered(const std::string& name, const std::string& study,
                  const std::string& options = "--threads 2", const std::string& samples = "--spp 2") {
  const fs::path folder = test::fresh_folder("clips_" + name);
  test::write_small_study(folder, study);
  const auto ran =
      test::run_seamline("render " + (folder / "study.toml").string() + " --out " +
                         (folder / "set").string() + " " + samples + " --only gazebo-shadow-* " + options);
  EXPECT_EQ(ran.status, 0) << ran.output;
  return folder / "set";
}

std::string frame_of(const fs::path& set, const std::string& object, const std::string& frame) {
  return test::read_text(set / "stimuli" / ("gazebo-shadow-" + object + frame + "-0064.png"));
}

Json record_of(const fs::path& set, const std::string& object, const std::string& frame) {
  return Json::parse(test::read_text(set / "records" / ("gazebo-shadow-" + object + frame + "-0064.json")))
      .at("record");
}

}  // namespace

TEST(RenderedClips, FramesAreTheStillsAtTheirPlaces) {
  const fs::path clips = rendered("moving", moving_study("", "0.5"));
  const fs::path there = rendered("there", still_study("-2.75"));
  for (const std::string object : {"beast", "lion", "dragon"}) {
    const std::string frame = frame_of(clips, object, "@002");
    ASSERT_FALSE(frame.empty());
    EXPECT_TRUE(frame == frame_of(there, object, "")) << object;
    EXPECT_FALSE(frame == frame_of(clips, object, "@000")) << object;
  }
  EXPECT_EQ(test::run_seamline("verify " + clips.string()).status, 0);
  const Json list = Json::parse(test::read_text(clips / "clips.json"));
  EXPECT_EQ(list.at("stimuli").size(), 3U);
  const fs::path clip = clips / std::string(list.at("stimuli").at(1).at("file"));
  test::write_text(clip, test::read_text(clip) + "x");
  EXPECT_EQ(test::run_seamline("verify " + clips.string()).status, 1);
}

TEST(RenderedClips, AtSpeedZeroTheStillIsRenderedOnce) {
  const fs::path clips = rendered("zero", moving_study("", "0"));
  const fs::path still = rendered("still", still_study("-3.0"));
  EXPECT_TRUE(frame_of(clips, "lion", "@000") == frame_of(still, "lion", ""));
  EXPECT_FALSE(fs::exists(clips / "stimuli" / "gazebo-shadow-lion@001-0064.png"));
}

TEST(RenderedClips, WithAnErrorAClipOfAStillHasTheStillsBytes) {
  const fs::path clips = rendered("zero_error", moving_study("", "0"), "--threads 1", "--error 0.05");
  const fs::path still = rendered("still_error", still_study("-3.0"), "--threads 2", "--error 0.05");
  for (const std::string object : {"beast", "lion", "dragon"})
    EXPECT_TRUE(frame_of(clips, object, "@000") == frame_of(still, object, "")) << object;
}

TEST(RenderedClips, AnErrorIsReachedOverEachClipAndThatOfItsChangesIsTold) {
  const std::string study = moving_study("", "0.5");
  const fs::path whole = rendered("error", study, "--threads 1", "--error 0.05");
  for (const Json& clip : Json::parse(test::read_text(whole / "manifest.json")).at("stimuli"))
    EXPECT_LE(clip.at("rmse").get<double>(), 0.05 * 1.02) << clip.at("id");
  const std::string errors = test::read_text(whole / "errors.csv");
  EXPECT_NE(errors.find(",change_error,changes_known,changes\n"), std::string::npos) << errors;
  EXPECT_NE(errors.find(",2,2\n"), std::string::npos)
      << "two changes of three frames, both known: " << errors;
  const fs::path pieces = rendered("error_pieces", study, "--threads 2 --shard 2/2", "--error 0.05");
  const auto rest =
      test::run_seamline("render " + (pieces.parent_path() / "study.toml").string() + " --out " +
                         pieces.string() + " --error 0.05 --only gazebo-shadow-* --threads 2 --shard 1/2");
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_EQ(test::read_text(whole / "manifest.json"), test::read_text(pieces / "manifest.json"));
  EXPECT_EQ(test::read_text(whole / "clips.json"), test::read_text(pieces / "clips.json"));
  const auto by_path =
      test::run_seamline("render " + (whole.parent_path() / "study.toml").string() + " --out " +
                         (whole.parent_path() / "path").string() + " --error 0.05 --estimator path");
  EXPECT_EQ(by_path.status, 1);
  EXPECT_NE(by_path.output.find("--spp"), std::string::npos) << by_path.output;
}

TEST(RenderedClips, ADelayOfOneFrameHasTheMeshOfTheFrameBefore) {
  const fs::path late = rendered("late", moving_study("[depth]\ndelay_ms = 250\n", "0.5"));
  const fs::path now = rendered("now", moving_study("", "0.5"));
  const Json mesh = record_of(late, "lion", "@002").at("mesh");
  EXPECT_EQ(mesh, record_of(now, "lion", "@001").at("mesh"));
  EXPECT_NE(mesh, record_of(now, "lion", "@002").at("mesh"));
  EXPECT_TRUE(frame_of(late, "beast", "@002") == frame_of(now, "beast", "@002")) << "nothing real moves";
}

namespace {

/// A box of 1 m whose animation "Rise" lifts it by 1 m in 1 s and turns it by a half turn about the vertical.
void write_rising_box(const fs::path& path) {
  std::string bytes;
  const auto put = [&](const auto& values) {
    for (const auto value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (int corner = 0; corner < 8; ++corner)
    put(std::array<float, 3>{corner & 1 ? 0.5F : -0.5F, corner & 2 ? 1.0F : 0.0F, corner & 4 ? 0.5F : -0.5F});
  put(std::array<std::uint32_t, 36>{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
  put(std::array<float, 2>{0, 1});
  put(std::array<float, 6>{0, 0, 0, 0, 1, 0});
  put(std::array<float, 8>{0, 0, 0, 1, 0, 1, 0, 0});
  test::write_text(path.parent_path() / "box.bin", bytes);
  const auto view = [](int from, int length) {
    return "{\"buffer\":0,\"byteOffset\":" + std::to_string(from) +
           ",\"byteLength\":" + std::to_string(length) + "}";
  };
  const auto accessor = [](int of, int type, const char* kind, int count) {
    return "{\"bufferView\":" + std::to_string(of) + ",\"componentType\":" + std::to_string(type) +
           ",\"type\":\"" + kind + "\",\"count\":" + std::to_string(count) + "}";
  };
  test::write_text(
      path,
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":304,"uri":"box.bin"}],"bufferViews":[)" +
          view(0, 96) + "," + view(96, 144) + "," + view(240, 8) + "," + view(248, 24) + "," + view(272, 32) +
          R"(],"accessors":[)" + accessor(0, 5126, "VEC3", 8) + "," + accessor(1, 5125, "SCALAR", 36) + "," +
          accessor(2, 5126, "SCALAR", 2) + "," + accessor(3, 5126, "VEC3", 2) + "," +
          accessor(4, 5126, "VEC4", 2) +
          R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"nodes":[{"mesh":0}],)"
          R"("scenes":[{"nodes":[0]}],"animations":[{"name":"Rise","channels":[)"
          R"({"sampler":0,"target":{"node":0,"path":"translation"}},{"sampler":1,"target":{"node":0,"path":"rotation"}}],)"
          R"("samplers":[{"input":2,"output":3},{"input":2,"output":4}]}]})");
}

/// The small study's second scene with the box in the place of its left body; `more` goes into that object.
std::string study_with_box(const std::string& clip, const std::string& file, const std::string& more,
                           const std::string& camera) {
  const std::string left = "position_m = [-3.0, 0.0, -7.0]";
  std::string study = test::small_study_with(
      {{"depth_width_px = [64, 256, 512, 1024, 2048]", "depth_width_px = [64]\n" + clip},
       {left, left + "\n" + more}});
  const std::size_t scene = study.find("name = \"gazebo\"");
  const std::size_t body = study.find("cube.gltf", scene), first = study.find("[[scene.object]]", scene);
  study.replace(body, std::string("cube.gltf").size(), file);
  return study.insert(study.rfind('\n', first) + 1, camera);
}

}  // namespace

TEST(RenderedClips, AnAnimatedFrameIsTheStillOfThatMomentAndAMovedCameraTheStillFromThere) {
  const auto render_box = [](const std::string& name, const std::string& study, const std::string& only) {
    const fs::path folder = test::fresh_folder("clips_" + name);
    write_rising_box(folder / "box.gltf");
    test::write_small_study(folder, study);
    const auto ran =
        test::run_seamline("render " + (folder / "study.toml").string() + " --out " +
                           (folder / "set").string() + " --spp 2 --only " + only + " --threads 2");
    EXPECT_EQ(ran.status, 0) << ran.output;
    const bool is_clip = study.find("[clip]") != std::string::npos;
    EXPECT_NE(ran.output.find(is_clip ? " frames rendered" : " stimulus rendered"), std::string::npos)
        << ran.output;
    return folder / "set";
  };
  const std::string clip = "[clip]\nframes = 3\nframes_per_s = 4\n",
                    animation = "animation = { name = \"Rise\" }";
  const auto camera_at = [](const std::string& x_m) {
    return "[scene.camera]\nposition_m = [" + x_m + ", 1.6, 0]\nlook_at_m = [" + x_m + ", 1.2, -7]\n";
  };
  const std::string path =
      "path = { kind = \"keys\", keys = [{ time_s = 0, position_m = [0, 1.6, 0], look_at_m = [0, 1.2, -7] }, "
      "{ time_s = 1, position_m = [0.5, 1.6, 0], look_at_m = [0.5, 1.2, -7] }] }\n";
  const fs::path rising = render_box("rising", study_with_box(clip, "box.gltf", animation, camera_at("0")),
                                     "gazebo-shadow-beast*");
  const fs::path risen = render_box("risen", study_with_box("", "box.gltf#Rise@0.5", "", camera_at("0")),
                                    "gazebo-shadow-beast*");
  const fs::path going = render_box(
      "going", study_with_box(clip, "box.gltf", animation, camera_at("0") + path), "gazebo-shadow-beast*");
  const fs::path there = render_box("there", study_with_box("", "box.gltf#Rise@0.5", "", camera_at("0.25")),
                                    "gazebo-shadow-beast*");
  const std::string frame = frame_of(rising, "beast", "@002");
  ASSERT_FALSE(frame.empty());
  EXPECT_TRUE(frame == frame_of(risen, "beast", ""));
  EXPECT_FALSE(frame == frame_of(rising, "beast", "@000"));
  EXPECT_TRUE(frame_of(going, "beast", "@002") == frame_of(there, "beast", ""));
  EXPECT_FALSE(frame_of(going, "beast", "@002") == frame);
  EXPECT_TRUE(frame_of(going, "beast", "@000") == frame_of(rising, "beast", "@000"));
  const auto checked = test::run_seamline("check " + (rising.parent_path() / "study.toml").string());
  EXPECT_NE(checked.output.find("gazebo"), std::string::npos) << checked.output;
  EXPECT_EQ(checked.output.find("shown at rest"), std::string::npos) << checked.output;
}

TEST(RenderedClips, PiecesAndThreadsGiveTheSameBytes) {
  const std::string study = moving_study("", "0.5");
  const fs::path whole = rendered("whole", study, "--threads 1");
  const fs::path pieces = rendered("pieces", study, "--threads 2 --shard 1/2");
  const auto rest =
      test::run_seamline("render " + (pieces.parent_path() / "study.toml").string() + " --out " +
                         pieces.string() + " --spp 2 --only gazebo-shadow-* --threads 2 --shard 2/2");
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_EQ(test::read_text(whole / "manifest.json"), test::read_text(pieces / "manifest.json"));
  EXPECT_EQ(test::read_text(whole / "clips.json"), test::read_text(pieces / "clips.json"));
}

TEST(RenderedClips, AKilledRenderGoesOnToTheSameBytes) {
  const fs::path folder = test::fresh_folder("clips_killed");
  test::write_small_study(folder, moving_study("", "0.5"));
  const auto arguments = [&](const std::string& set) {
    return std::vector<std::string>{"render", (folder / "study.toml").string(),
                                    "--out",  (folder / set).string(),
                                    "--spp",  "2",
                                    "--only", "gazebo-shadow-*"};
  };
  const auto render = [&](const std::string& set) {
    std::string words;
    for (const std::string& word : arguments(set)) words += word + " ";
    const auto ran = test::run_built(words);
    EXPECT_EQ(ran.status, 0) << ran.output;
  };
  const test::Running killed = test::start(arguments("killed"), folder / "said.txt", 2000);
  ASSERT_TRUE(test::stands_still(killed)) << test::read_text(killed.output);
  EXPECT_EQ(test::status_after(killed, SIGKILL), 128 + SIGKILL);
  EXPECT_FALSE(fs::exists(folder / "killed" / "manifest.json"));
  EXPECT_FALSE(fs::is_empty(folder / "killed" / "records")) << "something was finished before";
  render("killed");
  render("whole");
  for (const char* file : {"manifest.json", "clips.json"})
    EXPECT_EQ(test::read_text(folder / "whole" / file), test::read_text(folder / "killed" / file));
}

TEST(RenderedClips, APageHoldsTheClipsAndWhereTheObjectsAreInEachFrame) {
  const fs::path set = rendered("page", moving_study("", "0.5"));
  const fs::path page = set.parent_path() / "web";
  const auto exported = test::run_seamline("export web " + set.string() + " " + page.string() + " --pilot");
  ASSERT_EQ(exported.status, 0) << exported.output;
  const Json study = Json::parse(test::read_text(page / "study.json"));
  EXPECT_EQ(study.at("clip").at("frames_per_s"), 4);
  EXPECT_EQ(study.at("clip").at("loops"), true);
  std::vector<std::string> shown, made;
  for (const Json& stimulus : study.at("stimuli")) shown.push_back(stimulus.at("sha256"));
  const Json list = Json::parse(test::read_text(set / "clips.json"));
  for (const Json& clip : list.at("stimuli")) made.push_back(clip.at("sha256"));
  std::sort(shown.begin(), shown.end());
  std::sort(made.begin(), made.end());
  EXPECT_EQ(shown, made);
  for (const Json& picture : study.at("pictures")) {
    const Json maps = Json::parse(test::read_text(page / std::string(picture.at("map"))));
    ASSERT_EQ(maps.size(), 3U);
    const Json& first = maps.at(0).at("frames").at(0);
    const Json& last = maps.at(2).at("frames").at(0);
    EXPECT_LT(first.at("x_px").get<int>(), last.at("x_px").get<int>()) << "the left object goes right";
  }
}

}  // namespace seamline
