// Recordings: what was rendered is read again, and what is none is refused in one sentence.
#include "live/recording/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "live/recording/loaded_recording.h"
#include "live/recording/view_camera.h"
#include "small_world.h"
#include "support/files/atomic_file.h"
#include "tests/complaint.h"

namespace seamline::live {
namespace {

using testing::HasSubstr;

constexpr const char* head = "format = \"seamline recording 1\"\n";
constexpr const char* frame = "[[frame]]\ntime_s = 0\ndepth = \"d.exr\"\ncolour = \"c.png\"\n";

/// A rig whose cameras differ and whose depth is noisy and radial.
sensors::Rig noisy_rig() {
  sensors::Rig rig = test::exact_rig(48, 36);
  rig.colour = sensors::pinhole_of_field_of_view(64, 48, 50);
  rig.colour.distortion.k1 = -0.05;
  rig.colour_from_depth.translation() = Eigen::Vector3d(0.03, -0.01, 0);
  rig.noise = sensors::GenericNoise{
      .convention = sensors::DepthConvention::radial, .relative_sigma = 0.01, .dropout_share = 0.05};
  return rig;
}

TEST(Recording, AGeneratedOneReadBackHasTheSameFramesAndPoses) {
  const auto folder = test::fresh_folder("live-recording");
  const sensors::Rig rig = noisy_rig();
  MakeOptions options{.path = {.kind = PathKind::orbit, .angle_deg = 10}, .frames = 3};
  options.sense.key.seed = 5;
  options.sense.photograph = {.spp = 1, .seed = 5, .threads = 2};
  Recording made = make_recording(test::room(), test::definition_of(0.3), rig, "test", options, folder);
  Recording read = read_recording(folder);
  ASSERT_EQ(read.frames.size(), 3U);
  const LoadedRecording loaded = load_recording(read, {});
  read.has_light = made.has_light = false;  // directions are made unit again
  EXPECT_EQ(recording_text(read), recording_text(made));
  EXPECT_EQ(loaded.rig.colour, rig.colour);
  EXPECT_EQ(loaded.rig.depth_form.camera, rig.depth);
  EXPECT_EQ(loaded.rig.depth_form.convention, sensors::DepthConvention::radial);
  ASSERT_EQ(loaded.light.suns->size(), 1U);

  const renderer::SensedScene scene = renderer::sensed_scene(test::room(), test::definition_of(0.3), rig);
  CameraPath path = options.path;
  path.centre_m = Eigen::Vector3d(0, 0, -4);  // what the picture's middle shows
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Isometry3d pose = pose_on_path(path, scene.world_from_colour, static_cast<double>(i) / 2);
    ASSERT_TRUE(loaded.frames[i].world_from_colour);
    EXPECT_EQ(loaded.frames[i].world_from_colour->matrix(), made.frames[i].world_from_colour->matrix());
    EXPECT_TRUE(loaded.frames[i].world_from_colour->isApprox(pose, 1e-6));
    renderer::SenseSettings settings = options.sense;
    settings.key.frame += i;
    const renderer::SensedFrame sensed =
        renderer::sense_frame(scene, rig, *made.frames[i].world_from_colour, settings);
    EXPECT_EQ(loaded.frames[i].depth.depth_m, sensed.measured.frame.depth_m) << "bit for bit";
    EXPECT_EQ(loaded.frames[i].time_s, static_cast<double>(i) / 30);
  }
}

TEST(Recording, TextAndValuesAreTheSameBitForBit) {
  Recording recording;
  recording.frames.push_back({.time_s = 1.0 / 3, .depth_file = "a \"b\".exr", .colour_file = "c\\d.png"});
  recording.frames.push_back({.time_s = 0.7, .depth_file = "e.pgm", .colour_file = "f.png"});
  recording.frames.back().world_from_colour = sensors::pose_of({0.1, 1.0 / 7, -3e-9}, {1, 2, 3}, 33.3);
  const Recording read = parse_recording(recording_text(recording), "x/recording.toml");
  EXPECT_EQ(recording_text(read), recording_text(recording));
  EXPECT_EQ(read.frames[0].depth_file, "a \"b\".exr");
  EXPECT_EQ(read.frames[1].world_from_colour->matrix(), recording.frames[1].world_from_colour->matrix());
  EXPECT_FALSE(read.frames[0].world_from_colour);
  EXPECT_FALSE(read.has_light);
}

TEST(Recording, WhatIsNoneIsRefusedInOneSentence) {
  const auto said = [](const std::string& text) {
    return seamline::test::complaint_of([&] { (void)parse_recording(text, "r/recording.toml"); });
  };
  const std::string good = std::string(head) + frame;
  EXPECT_EQ(said(good), "no complaint");
  for (const auto& [text, names] : std::vector<std::pair<std::string, std::string>>{
           {"", "format"},
           {"format = \"seamline recording 2\"\n", "format"},
           {head, "frame"},
           {good + "speed = 1\n", "speed"},
           {std::string(head) + "up = [0, 0, 0]\n" + frame, "up"},
           {std::string(head) + "camera = \"../camera.toml\"\n" + frame, "camera"},
           {std::string(head) + "bounces = 2\n" + frame, "bounces"},
           {std::string(head) + "[[frame]]\ndepth = \"d.exr\"\ncolour = \"c.png\"\n", "frame[0].time_s"},
           {std::string(head) + "[[frame]]\ntime_s = nan\ndepth = \"d.exr\"\ncolour = \"c.png\"\n", "time_s"},
           {std::string(head) + "[[frame]]\ntime_s = 0\ndepth = \"/etc/passwd\"\ncolour = \"c.png\"\n",
            "frame[0].depth"},
           {std::string(head) + "[[frame]]\ntime_s = 0\ndepth = \"d.exr\"\ncolour = \"a/../../c.png\"\n",
            "frame[0].colour"},
           {std::string(head) + "[[frame]]\ntime_s = 1\ndepth = \"d\"\ncolour = \"c\"\n" + frame,
            "frame[1].time_s"},
           {good + "[frame.world_from_colour]\ntranslation_m = [0, 0]\n", "translation_m"},
           {good + "[frame.world_from_colour]\ntranslation_m = [0, 0, 0]\nrotation = [1, 0, 0, 0, 1, 0, 0, "
                   "0, 2]\n",
            "rotation"}}) {
    const std::string sentence = said(text);
    EXPECT_THAT(sentence, HasSubstr(names)) << text;
    EXPECT_NE(sentence, "no complaint") << text;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
}

TEST(Recording, FramesThatAreNotThereOrLeadOutAreRefused) {
  const auto folder = test::fresh_folder("live-links");
  write_file_atomically(folder / "camera.toml",
                        registration::camera_file_text(
                            [] {
                              registration::CameraFile cameras;
                              cameras.depth = cameras.colour = test::exact_rig(8, 6).depth;
                              cameras.colour_from_depth = Eigen::Isometry3d::Identity();
                              cameras.convention = sensors::DepthConvention::planar;
                              return cameras;
                            }(),
                            "test"));
  write_file_atomically(folder / recording_index, std::string(head) + frame);
  const auto said = [&] {
    return seamline::test::complaint_of([&] { (void)load_recording(read_recording(folder), {}); });
  };
  EXPECT_THAT(said(), HasSubstr("c.png"));
  std::filesystem::create_symlink("/etc/hostname", folder / "c.png");
  EXPECT_THAT(said(), HasSubstr("leads out of it"));
  EXPECT_THAT(seamline::test::complaint_of([&] { (void)read_recording(folder / "nowhere"); }),
              HasSubstr("recording.toml"));
}

TEST(Recording, AnotherSizeOfTheSameShapeScalesTheCameraAndAnotherShapeIsRefused) {
  const sensors::PinholeCamera colour = sensors::pinhole_of_field_of_view(640, 480, 57);
  const sensors::PinholeCamera view = view_camera(colour, 800, 600, "--size");
  EXPECT_DOUBLE_EQ(sensors::horizontal_field_of_view_deg(view),
                   sensors::horizontal_field_of_view_deg(colour));
  EXPECT_THAT(seamline::test::complaint_of([&] { (void)view_camera(colour, 800, 500, "--size"); }),
              HasSubstr("--size"));
}

}  // namespace
}  // namespace seamline::live
