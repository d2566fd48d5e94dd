#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "stimuli/definition/clip_frames.h"
#include "stimuli/definition/moving/file_moment.h"
#include "stimuli/set/clip_file.h"
#include "stimuli/study_file/moving/study_file_late_frames.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

/// A study of one scene whose left object moves; `more` goes into the top of the file, `path` into the
/// object.
std::string clip_study(const std::string& level, const std::string& path, const std::string& more = "") {
  std::string text = "format = \"seamline study 1\"\nname = \"moving\"\n" + level + "\n" + more +
                     "\n[[scene]]\nname = \"room\"\nfile = \"room.glb\"\nartifacts = [\"shadow\"]\n";
  for (const char* name : {"left", "middle", "right"}) {
    text += std::string("[[scene.object]]\nname = \"") + name + "\"\nfile = \"cube.gltf\"\n";
    if (name == std::string("left")) text += path;
  }
  return text;
}

const std::string widths = "depth_width_px = [64, 128]";
const std::string clip_table = "[clip]\nframes = 4\nframes_per_s = 2\n";
const std::string line = "path = { kind = \"line\", to_m = [1, 0, 0], speed_m_s = 0.5 }\n";

StudyDefinition read_clips(const std::string& text) {
  return read_study_text(text, "moving.toml");
}

std::string complaint_of_clip(const std::string& text) {
  try {
    static_cast<void>(read_clips(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Clips, ALineGoesThereAndBackAtItsSpeed) {
  const ObjectMotion motion = LineMotion{.to_m = {3, 4, 0}, .speed_m_s = 2.5};
  const auto at = [&](double time_s) { return pose_at(motion, {}, time_s, std::nullopt).position_m; };
  EXPECT_TRUE(at(0).isZero());
  EXPECT_TRUE(at(1).isApprox(Eigen::Vector3d(1.5, 2, 0)));
  EXPECT_TRUE(at(2).isApprox(Eigen::Vector3d(3, 4, 0)));
  EXPECT_TRUE(at(3).isApprox(Eigen::Vector3d(1.5, 2, 0)));
  EXPECT_TRUE(at(4).isZero());
  EXPECT_TRUE(at(-1).isApprox(at(1)));
  const ObjectMotion stops = LineMotion{.to_m = {3, 4, 0}, .speed_m_s = 2.5, .comes_back = false};
  EXPECT_TRUE(pose_at(stops, {}, 9, std::nullopt).position_m.isApprox(Eigen::Vector3d(3, 4, 0)));
  EXPECT_TRUE(pose_at(motion, {}, 1, 0).position_m.isZero()) << "the level's speed stands for the line's";
}

TEST(Clips, KeysAreMetAndJoinedByStraightLines) {
  const ObjectMotion motion = KeyedMotion{.keys = {{.time_s = 0, .pose = {{0, 0, 0}, {0, 0, 0}}},
                                                   {.time_s = 2, .pose = {{2, 0, 0}, {0, 90, 0}}},
                                                   {.time_s = 3, .pose = {{2, 1, 0}, {0, 90, 0}}}}};
  const auto at = [&](double time_s) { return pose_at(motion, {}, time_s, std::nullopt); };
  EXPECT_TRUE(at(1).position_m.isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_DOUBLE_EQ(at(1).rotation_deg.y(), 45);
  EXPECT_TRUE(at(2).position_m.isApprox(Eigen::Vector3d(2, 0, 0)));
  EXPECT_TRUE(at(-1).position_m.isZero());
  EXPECT_TRUE(at(99).position_m.isApprox(Eigen::Vector3d(2, 1, 0)));
}

TEST(Clips, AnAnimationPlaysToItsEndOrAgainAndAgain) {
  const FileAnimation once{.name = "Open", .from_s = 1, .to_s = 3, .speed = 2};
  const FileAnimation again{.name = "Open", .from_s = 1, .to_s = 3, .repeats = true, .speed = 2};
  for (const auto& [time_s, stands_s, turns_s] :
       {std::array{0.0, 1.0, 1.0}, {0.5, 2.0, 2.0}, {1.25, 3.0, 1.5}, {-0.25, 1.0, 2.5}}) {
    EXPECT_DOUBLE_EQ(animation_time_s(once, time_s), stands_s) << time_s;
    EXPECT_DOUBLE_EQ(animation_time_s(again, time_s), turns_s) << time_s;
  }
  EXPECT_DOUBLE_EQ(animation_time_s({}, 7), 7);
}

TEST(Clips, AFileIsNamedWithTheMomentOfItsAnimation) {
  const NamedFile named = split_moment("a#b/door.GLB#Open #2@up@0.25");
  EXPECT_EQ(named.file, "a#b/door.GLB");
  ASSERT_TRUE(named.moment);
  EXPECT_EQ(named.moment->animation, "Open #2@up");
  EXPECT_EQ(named.moment->time_s, 0.25);
  EXPECT_EQ(with_moment("door.glb#Open@1", {"Shut", 1.0 / 3}), "door.glb#Shut@0.3333333333333333");
  for (const char* file : {"door#2.obj@1", "door.glb#Open", "door.glb#Open@now", "door.glb",
                           "door.glb#Open@1s", "door.glb#Open@inf"}) {
    EXPECT_EQ(split_moment(file).file, file);
    EXPECT_FALSE(split_moment(file).moment) << file;
  }
}

TEST(Clips, NodesOfAFileStandWhereItsNameSays) {
  const std::string moved = with_node("room.glb#Open@0.25", {"leaf 2", {0.1, 0, -2}, {0, 90, 0}});
  EXPECT_EQ(moved, "room.glb#leaf 2@[0.1 0 -2 0 90 0]#Open@0.25");
  const NamedFile named = split_moment(moved);
  EXPECT_EQ(named.file, "room.glb");
  ASSERT_TRUE(named.moment);
  EXPECT_EQ(named.moment->animation, "Open");
  EXPECT_EQ(node_of(moved, "leaf 2").position_m, Eigen::Vector3d(0.1, 0, -2));
  EXPECT_TRUE(node_of(moved, "leaf").stands());
  EXPECT_EQ(with_moment(moved, {"Shut", 1}), "room.glb#leaf 2@[0.1 0 -2 0 90 0]#Shut@1");
  EXPECT_EQ(with_node(moved, {"leaf 2"}), "room.glb#Open@0.25");
  const std::string room = with_node("builtin:room", {"leaf", {1, 0, 0}});
  EXPECT_EQ(split_moment(room).file, "builtin:room");
  EXPECT_FALSE(split_moment(room).moment->is_animated);
  EXPECT_EQ(with_node(room, {"leaf"}), "builtin:room");
  for (const char* file :
       {"room.glb#leaf@[1 2 3]", "room.glb#leaf@[1 2 3 4 5 6", "room.glb#leaf@[1 2 3 4 5 x]",
        "room.glb#leaf@[1 2 3 4 5 6 7]", "room.glb#leaf@[0 0 0 0 0 inf]"})
    EXPECT_FALSE(split_moment(file).moment) << file;
}

TEST(Clips, ANodeOfTheBackgroundMovesOnItsPathAsStillsHaveItThere) {
  const auto study = [](const std::string& node, const std::string& clip) {
    return clip_study(widths, "", clip) + "\n[[scene.node]]\nname = \"leaf\"\n" + node;
  };
  const std::string path = "path = { kind = \"line\", to_m = [0.6, 0, 0], speed_m_s = 0.2 }\n";
  const std::vector<SceneDefinition> frames = list_truths(still_study(read_clips(study(path, clip_table))));
  ASSERT_EQ(frames.size(), 4U);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double moved_m = node_of(frames[k].file, "leaf").position_m.x();
    EXPECT_NEAR(moved_m, 0.1 * static_cast<double>(k), 1e-12);
    const StudyDefinition still = read_clips(study(fmt::format("position_m = [{}, 0, 0]\n", moved_m), ""));
    EXPECT_EQ(frames[k].file, list_truths(still).front().file) << k;
  }
  EXPECT_EQ(frames[0].file, "room.glb");
  const std::string stands = "path = { kind = \"turn\", speed_deg_s = 0 }\n";
  for (const SceneDefinition& truth : list_truths(still_study(read_clips(study(stands, clip_table)))))
    EXPECT_EQ(truth.file, "room.glb");
  EXPECT_EQ(list_truths(still_study(read_clips(study("rotation_deg = [0, 30, 0]\npath = { kind = \"turn\", "
                                                     "speed_deg_s = 20 }\n",
                                                     clip_table))))[3]
                .file,
            "room.glb#leaf@[0 0 0 0 60 0]");
  const auto complaint = [&](const std::string& node, const std::string& clip) {
    return complaint_of_clip(study(node, clip));
  };
  EXPECT_NE(complaint(path, "").find("a table [clip]"), std::string::npos) << complaint(path, "");
  const std::string twice = "[[scene.node]]\nname = \"leaf\"\n";
  EXPECT_NE(complaint(path + twice, clip_table).find("each node once"), std::string::npos);
  const std::string right = "position_m = [1, 0, 0]\n";
  EXPECT_NE(complaint(right + "[[scene.node]]\nname = \"a@b\"\n", "").find("without any of #@[]"),
            std::string::npos);
  EXPECT_NE(complaint("", "").find("position_m, rotation_deg or a path"), std::string::npos);
  const auto of_room = [&](const std::string& file) {
    std::string text = study(right, "");
    return complaint_of_clip(text.replace(text.find("room.glb"), 8, file));
  };
  EXPECT_NE(of_room("room.bin").find("a glTF file (.gltf, .glb) or a built-in one"), std::string::npos);
  EXPECT_NE(of_room("room.glb#leaf@[0 0 0 0 9 0]").find("[[scene.node]] for nodes"), std::string::npos);
}

TEST(Clips, FramesHaveTheMomentsOfAnimationsAndTheCamerasPlaces) {
  const std::string text =
      clip_study(widths, "animation = { name = \"Open\", to_s = 1, repeats = true }\n", clip_table) +
      "[scene.camera]\npath = { kind = \"keys\", keys = [{ time_s = 0, position_m = [0, 1, 0], look_at_m = [0, 1, -1] },"
      " { time_s = 2, position_m = [2, 1, 0], look_at_m = [2, 1, -5] }] }\n";
  const std::vector<SceneDefinition> truths = list_truths(still_study(read_clips(text)));
  ASSERT_EQ(truths.size(), 4U) << "the camera moves where the animation repeats";
  EXPECT_EQ(truths[1].objects[0].file, "cube.gltf#Open@0.5");
  EXPECT_EQ(truths[3].objects[0].file, "cube.gltf#Open@0.5");
  EXPECT_EQ(truths[0].objects[1].file, "cube.gltf");
  EXPECT_TRUE(truths[3].camera->position_m.isApprox(Eigen::Vector3d(1.5, 1, 0)));
  EXPECT_TRUE(truths[3].camera->look_at_m.isApprox(Eigen::Vector3d(1.5, 1, -4)));
  const std::string door = "\nanimation = { name = \"Door\" }\n";
  const auto of_background = [&](std::string of) {
    return of.replace(of.find("file = \"room.glb\""), 0, door);
  };
  EXPECT_EQ(list_truths(still_study(read_clips(of_background(clip_study(widths, "", clip_table)))))[2].file,
            "room.glb#Door@1");
  const std::string still = complaint_of_clip(of_background(clip_study(widths, "")));
  EXPECT_NE(still.find("FILE.glb#NAME@SECONDS"), std::string::npos) << still;
  const std::string late = complaint_of_clip(text + "\n[depth]\ndelay_ms = 40\n");
  EXPECT_NE(late.find("a camera that moves, found late or held depth"), std::string::npos) << late;
  std::string up = text;
  up.replace(up.find("look_at_m = [2, 1, -5]"), 22, "look_at_m = [2, 9, 0.0]");
  EXPECT_NE(complaint_of_clip(up).find("straight above"), std::string::npos) << complaint_of_clip(up);
  const std::string endless =
      complaint_of_clip(clip_study(widths, "animation = { repeats = true }\n", clip_table));
  EXPECT_NE(endless.find("where in the animation it begins anew"), std::string::npos) << endless;
}

TEST(Clips, DepthIsHeldBetweenCapturesAndNeverYoungerThanItsDelay) {
  const DepthClock clock{.frames_per_s = 8, .delay_ms = 40};
  for (int frame = 0; frame < 240; ++frame) {
    const double now_s = frame / 24.0, then_s = capture_time_s(clock, now_s);
    EXPECT_LE(then_s, now_s - 0.04 + 1e-9);
    EXPECT_GT(then_s, now_s - 0.04 - 1.0 / 8);
    EXPECT_NEAR(then_s * 8, std::round(then_s * 8), 1e-9);
  }
  EXPECT_EQ(capture_time_s({}, 0.375), 0.375);
  EXPECT_EQ(capture_time_s({.frames_per_s = 8}, 9 / 24.0), 3 / 8.0) << "a capture at the frame's own time";
}

TEST(Clips, FramesAreStillsNamedByTheirNumber) {
  const StudyDefinition study = read_clips(clip_study(widths, line, clip_table));
  const StudyDefinition frames = still_study(study);
  const std::vector<Clip> clips = list_clips(study);
  ASSERT_EQ(clips.size(), list_stimuli(study).size());
  for (std::size_t i = 0; i < clips.size(); ++i) {
    EXPECT_EQ(stimulus_id(clips[i].shown), stimulus_id(list_stimuli(study)[i]));
    ASSERT_EQ(clips[i].frames.size(), 4U);
  }
  EXPECT_EQ(stimulus_id(clips[0].shown), "room-shadow-left-0064");
  EXPECT_EQ(stimulus_id(clips[0].frames[3]), "room-shadow-left@003-0064");
  EXPECT_EQ(clips[0].frames[3].truth, "room@003");
  std::vector<double> places_m;
  for (const SceneDefinition& truth : list_truths(frames))
    places_m.push_back(truth.objects[0].position_m.x());
  EXPECT_EQ(places_m, (std::vector<double>{0, 0.25, 0.5, 0.75}));
}

TEST(Clips, AFrameIsTheStillAtThatPlace) {
  const StudyDefinition frames = still_study(read_clips(clip_study(widths, line, clip_table)));
  const StudyDefinition still = read_clips(clip_study(widths, "position_m = [0.5, 0, 0]\n"));
  SceneDefinition frame = list_truths(frames).at(2);
  EXPECT_EQ(canonical_text(frame), canonical_text(list_truths(still).at(0)));
}

TEST(Clips, WhatStandsStillIsOneFrame) {
  const StudyDefinition study =
      read_clips(clip_study("depth_width_px = 64\n[level]\nquantity = \"object_speed_m_s\"\nvalues = [0, 1]",
                            "path = { kind = \"line\", to_m = [1, 0, 0] }\n", "[clip]\nframes = 4\n"));
  const std::vector<Clip> clips = list_clips(study);
  std::set<std::string> still, moving;
  for (const Stimulus& frame : clips[0].frames) still.insert(stimulus_id(frame));
  for (const Stimulus& frame : clips[1].frames) moving.insert(stimulus_id(frame));
  EXPECT_EQ(still.size(), 1U);
  EXPECT_EQ(moving.size(), 4U);
}

TEST(Clips, ADelayOfOneFrameIsTheDepthOfTheFrameBefore) {
  const StudyDefinition frames = still_study(
      read_clips(clip_study("depth_width_px = [64]", line, clip_table + "[depth]\ndelay_ms = 500\n")));
  int late = 0;
  for (const Stimulus& stimulus : list_stimuli(frames)) {
    const std::optional<SceneDefinition> captured = captured_scene(frames, stimulus);
    if (stimulus.object == "left") {
      EXPECT_FALSE(captured) << "nothing real moves";
    } else if (stimulus.truth != "room@000") {
      ASSERT_TRUE(captured);
      const int before = std::stoi(stimulus.truth.substr(5)) - 1;
      EXPECT_EQ(canonical_text(*captured),
                canonical_text(list_truths(frames).at(static_cast<std::size_t>(before))));
      ++late;
    }
  }
  EXPECT_EQ(late, 6);
}

TEST(Clips, NoiseIsNewInEveryCaptureAndHeldAsLongAsThatIs) {
  const std::string noisy = "[depth]\nnoise = { model = \"generic\", relative_sigma = 0.01 }\n";
  const auto seeds_of = [&](const std::string& clock) {
    std::vector<std::set<std::uint64_t>> seeds;
    for (const Clip& clip :
         list_clips(read_clips(clip_study("depth_width_px = [64]", "", clip_table + noisy + clock)))) {
      std::set<std::uint64_t> of_clip;
      for (const Stimulus& frame : clip.frames) of_clip.insert(frame.depth.chain->seed);
      EXPECT_EQ(clip.frames.front().depth.chain->seed, clip.shown.depth.chain->seed)
          << "the first capture has the noise of a still";
      seeds.push_back(of_clip);
    }
    return seeds;
  };
  for (const auto& seeds : seeds_of("")) EXPECT_EQ(seeds.size(), 4U);
  for (const auto& seeds : seeds_of("frames_per_s = 1\n"))
    EXPECT_EQ(seeds.size(), 2U) << "two frames a capture";
  for (const auto& seeds : seeds_of("frames_per_s = 0.1\n")) EXPECT_EQ(seeds.size(), 1U);
  const std::string sun = "[level]\nquantity = \"sun_radius_deg\"\nvalues = [0.5, 1]";
  const std::string wrong_pose =
      "[depth]\nsource = \"pinhole\"\npreset = \"tof_160x120\"\ncalibration_error_deg = 1\n";
  EXPECT_NE(complaint_of_clip(clip_study(sun, line, clip_table + wrong_pose)).find("one seed draws both"),
            std::string::npos);
}

TEST(Clips, WhatCannotBeIsRefusedByName) {
  EXPECT_NE(complaint_of_clip(clip_study(widths, line)).find("[clip]"), std::string::npos);
  EXPECT_NE(complaint_of_clip(clip_study(widths, "", clip_table)).find("an object with a path"),
            std::string::npos);
  EXPECT_NE(
      complaint_of_clip(clip_study(widths, "rest = true\n" + line, clip_table)).find("one of rest and path"),
      std::string::npos);
  EXPECT_NE(
      complaint_of_clip(clip_study(widths, line, "[clip]\nquestion = \"after\"\n")).find("a loop has no end"),
      std::string::npos);
  EXPECT_NE(
      complaint_of_clip(
          clip_study("depth_width_px = 64\n[level]\nquantity = \"depth_frames_per_s\"\nvalues = [1, 2]", ""))
          .find("[clip]"),
      std::string::npos);
}

TEST(Clips, LateTrialsAreNoPartOfTheHashAndRefusedWhereThereAreNone) {
  const std::string late = "[analysis]\nlate_frames_most = 0.2\nlate_trials = \"left_out\"\n";
  const std::string text = clip_study(widths, line, clip_table + late);
  EXPECT_EQ(study_hash(read_clips(text)), study_hash(read_clips(clip_study(widths, line, clip_table))));
  EXPECT_EQ(*read_late_frames_text(text, "moving.toml"),
            (LateFrames{.most_share = 0.2, .trials = LateTrials::left_out}));
  EXPECT_EQ(*read_late_frames_text(clip_study(widths, line, clip_table), "moving.toml"), LateFrames{});
  EXPECT_FALSE(read_late_frames_text(clip_study(widths, ""), "moving.toml"));
  EXPECT_NE(complaint_of_clip(clip_study(widths, "", late)).find("analysis.late_frames_most: wanted nothing"),
            std::string::npos);
  const std::string placed = widths + "\nprocedure = \"quest_plus\"";
  EXPECT_NE(complaint_of_clip(
                clip_study(placed, line, clip_table + "[quest_plus]\nmax_shows_per_image = 2\n" + late))
                .find("placed by every answer"),
            std::string::npos);
}

TEST(Clips, AFileGivesBackEveryPixelOfEveryFrame) {
  const fs::path path = fs::path(SEAMLINE_TEST_OUTPUT) / "clip_file.clip";
  fs::create_directories(path.parent_path());
  ClipWriter writer({.width_px = 31, .height_px = 17, .channels = 3, .frames_per_s = 24});
  std::vector<ByteImage> frames;
  for (unsigned k = 0; k < 9; ++k) {
    ByteImage frame{31, 17, 3, {}};
    for (unsigned i = 0; i < 31 * 17 * 3; ++i)
      frame.values.push_back(static_cast<std::uint8_t>((i * 2654435761U * (k + 1)) >> 13));
    writer.add(frame);
    frames.push_back(frame);
  }
  const std::string bytes = writer.bytes();
  write_file_atomically(path, bytes);
  ClipReader reader(path);
  ASSERT_EQ(reader.frames(), 9);
  for (int round = 0; round < 2; ++round)
    for (const ByteImage& frame : frames) EXPECT_EQ(reader.decode().values, frame.values);
  for (const std::size_t at : {bytes.size() - 1, bytes.size() / 2, std::size_t{3}}) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write_file_atomically(path, damaged);
    EXPECT_THROW(
        {
          ClipReader broken(path);
          for (int k = 0; k < 9; ++k) static_cast<void>(broken.decode());
        },
        InputError)
        << at;
  }
}

}  // namespace seamline
