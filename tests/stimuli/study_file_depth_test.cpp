// `[depth]` of a study file and of its conditions: how depth is captured.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/stimuli/study_of_depth.h"

namespace seamline {
namespace {

using test::depth_complaint;
using test::levels_complaint;
using test::levels_study;
using test::plain;
using test::sensor_study;
using test::study_of_depth;
using testing::AllOf;
using testing::HasSubstr;

const PinholeSource& pinhole_of(const DepthSettings& depth) {
  return std::get<PinholeSource>(depth.chain.value().sources.front());
}

TEST(StudyFileDepth, NamingTheUsualPanoramaChangesNothing) {
  const StudyDefinition usual = study_of_depth("");
  EXPECT_FALSE(usual.depth.chain.has_value());
  for (const char* text :
       {"[depth]", "[depth]\nsource = \"panorama\"", "[depth]\njumps = \"stretch\"\nrepair = \"none\"",
        "[depth]\nreduction = \"sample\"\nregistration = \"none\"", "[depth]\nocclusion = \"mesh\"",
        "[depth]\nnoise = { model = \"generic\", relative_sigma = 0.1, scale = 0 }"}) {
    const StudyDefinition same = study_of_depth(text);
    EXPECT_FALSE(same.depth.chain.has_value()) << text;
    EXPECT_EQ(study_hash(same), study_hash(usual)) << text;
  }
  EXPECT_NE(study_hash(study_of_depth("[depth]\njumps = \"cut\"")), study_hash(usual));
}

TEST(StudyFileDepth, APinholeHasItsOwnSize) {
  const StudyDefinition study = sensor_study(plain);
  EXPECT_EQ(study.depth.width_px, 320);
  EXPECT_EQ(study.depth.height_px(), 240);
  const PinholeSource& pinhole = pinhole_of(study.depth);
  EXPECT_NEAR(sensors::horizontal_field_of_view_deg(pinhole.camera), 60, 1e-9);
  EXPECT_EQ(pinhole.camera.cx_px, 160);
  EXPECT_FALSE(pinhole.noise.has_value());
  for (const Stimulus& stimulus : list_stimuli(study)) EXPECT_EQ(stimulus.depth.width_px, 320);
  EXPECT_THAT(depth_complaint("source = \"pinhole\"\nsize_px = [320, 240]\n"),
              HasSubstr("depth.fx: wanted fx,"));
  EXPECT_THAT(depth_complaint("source = \"pinhole\"\nfx = 200\n"),
              HasSubstr("depth.size_px: wanted width and height"));
  EXPECT_THAT(test::complaint_of([] {
                (void)study_of_depth(
                    std::string("[depth]\n") + plain,
                    "depth_width_px = 512\n[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.1]");
              }),
              HasSubstr("depth_width_px: wanted a panorama"));
  EXPECT_THAT(test::complaint_of([] { (void)study_of_depth(std::string("[depth]\n") + plain); }),
              HasSubstr("depth: wanted a panorama, because depth_width_px is the level, found a pinhole"));
}

TEST(StudyFileDepth, APresetIsItsNumbersAndKeysBesideItChangeThem) {
  const StudyDefinition preset = sensor_study("source = \"pinhole\"\npreset = \"tof_160x120\"");
  const PinholeSource& pmd = pinhole_of(preset.depth);
  EXPECT_EQ(pmd.camera.width_px, 160);
  EXPECT_EQ(pmd.range.farthest_m, 7.5);
  EXPECT_EQ(pmd.convention, sensors::DepthConvention::radial);
  EXPECT_EQ(pmd.pose.position_m[1], 0.06);
  ASSERT_TRUE(pmd.noise.has_value());
  EXPECT_EQ(word(pmd.noise->model), "time_of_flight");
  const StudyDefinition half = sensor_study(
      "source = \"pinhole\"\npreset = \"tof_160x120\"\nsize_px = [80, 60]\nnoise = { scale = 2 }");
  EXPECT_EQ(pinhole_of(half.depth).camera.fx_px, pmd.camera.fx_px / 2);
  EXPECT_EQ(pinhole_of(half.depth).noise->scale, 2);
  const StudyDefinition azure = sensor_study("source = \"pinhole\"\npreset = \"tof_640x576\"");
  EXPECT_NEAR(pinhole_of(azure.depth).pose.rotation_deg[0], -6, 1e-9);
  EXPECT_NEAR(pinhole_of(azure.depth).pose.rotation_deg[1], 0, 1e-9);
  const StudyDefinition quiet =
      sensor_study("source = \"pinhole\"\npreset = \"tof_160x120\"\nnoise = \"none\"");
  EXPECT_FALSE(pinhole_of(quiet.depth).noise.has_value());
  EXPECT_THAT(depth_complaint("source = \"pinhole\"\npreset = \"tof_160x12\""),
              AllOf(HasSubstr("study.toml"), HasSubstr("depth.preset: wanted one of tof_160x120"),
                    HasSubstr("did you mean \"tof_160x120\"?")));
  EXPECT_THAT(depth_complaint("source = \"pinhole\"\npreset = \"scanner_360\""),
              HasSubstr("wanted a sensor that is a pinhole"));
}

TEST(StudyFileDepth, ScaleZeroIsNoNoise) {
  const char* noisy = "noise = { model = \"generic\", relative_sigma = 0.01 }\nconvention = \"radial\"";
  const char* zero =
      "noise = { model = \"generic\", relative_sigma = 0.01, scale = 0 }\nconvention = \"radial\"";
  EXPECT_EQ(sensor_study(std::string(plain) + zero).depth,
            sensor_study(std::string(plain) + "convention = \"radial\"").depth);
  EXPECT_NE(sensor_study(std::string(plain) + noisy).depth, sensor_study(std::string(plain) + zero).depth);
}

TEST(StudyFileDepth, ConditionsChangeLinksByTheirDottedNames) {
  const StudyDefinition study =
      sensor_study(std::string(plain) + "jumps = \"cut\"\njump_ratio = 1.2",
                   "[[condition]]\nname = \"sheets\"\ndepth.jumps = \"stretch\"\n"
                   "[[condition]]\nname = \"gaps\"\n"
                   "[[condition]]\nname = \"wide\"\ndepth.field_of_view_deg = 90\n"
                   "[[condition]]\nname = \"exact\"\ndepth.source = \"panorama\"\ndepth.jumps = \"stretch\"\n"
                   "depth_width_px = 1024\n");
  ASSERT_EQ(study.conditions.size(), 4U);
  EXPECT_EQ(study.conditions[0].depth.chain->jumps, Jumps::stretch);
  EXPECT_EQ(study.conditions[1].depth.chain->jump_ratio, 1.2);
  EXPECT_NEAR(sensors::horizontal_field_of_view_deg(pinhole_of(study.conditions[2].depth).camera), 90, 1e-9);
  EXPECT_FALSE(study.conditions[3].depth.chain.has_value());
  EXPECT_EQ(study.conditions[3].depth.width_px, 1024);
  EXPECT_THAT(
      depth_complaint(plain,
                      "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\ndepth.jumps = \"stretch\""),
      HasSubstr("condition[1].name: wanted settings that no other condition has"));
  EXPECT_THAT(depth_complaint(plain, "[[condition]]\nname = \"a\"\ndepth.source = \"panorama\""),
              HasSubstr("condition[0].depth_width_px: wanted the width of the condition's panorama"));
  EXPECT_THAT(depth_complaint(plain, "[[condition]]\nname = \"a\"\ndepth.jump = \"cut\""),
              HasSubstr("condition[0].depth.jump: wanted a known key; did you mean \"jumps\"?"));
}

TEST(StudyFileDepth, SeveralSourcesAreAListOfTables) {
  const StudyDefinition study = study_of_depth(
      "[[depth.source]]\nkind = \"pinhole\"\npreset = \"tof_160x120\"\n"
      "[[depth.source]]\nkind = \"pinhole\"\nsize_px = [64, 48]\nfx = 50\npose = { position_m = [1, 0, 0] "
      "}\n",
      "[level]\nquantity = \"depth_noise\"\nvalues = [0, 1]");
  ASSERT_EQ(study.depth.chain->sources.size(), 2U);
  EXPECT_EQ(study.depth.width_px, 160);
  EXPECT_THAT(test::complaint_of([] {
                (void)study_of_depth("[[depth.source]]\nkind = \"panorama\"\n",
                                     "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.1]");
              }),
              HasSubstr("depth.source[0].kind: wanted \"pinhole\", \"file\" or \"stereo\""));
  EXPECT_THAT(test::complaint_of([] {
                (void)study_of_depth(
                    "[depth]\nfx = 3\n[[depth.source]]\nkind = \"pinhole\"\nsize_px = [64, 48]\nfx = 50\n",
                    "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.1]");
              }),
              HasSubstr("depth.fx: wanted such keys in each of the list's tables"));
}

TEST(StudyFileDepth, LevelsChangeTheChain) {
  const auto depths = [](const StudyDefinition& study) {
    std::vector<DepthSettings> found;
    for (const Stimulus& stimulus : list_stimuli(study))
      if (stimulus.object_index == 1) found.push_back(stimulus.depth);
    return found;
  };
  const std::string pmd = "source = \"pinhole\"\npreset = \"tof_160x120\"";
  const auto noise = depths(levels_study("depth_noise", "[0, 0.5, 2]", pmd));
  EXPECT_EQ(pinhole_of(noise[0]).noise->scale, 0);  // the same camera, with its holes
  EXPECT_EQ(pinhole_of(noise[1]).noise->scale, 0.5);
  EXPECT_EQ(pinhole_of(noise[2]).noise->scale, 2);
  const auto outliers = depths(levels_study("outlier_share", "[0, 0.01]", pmd));
  EXPECT_EQ(std::get<sensors::TimeOfFlightNoise>(pinhole_of(outliers[1]).noise->model).outliers.share, 0.01);
  EXPECT_EQ(depths(levels_study("calibration_error_deg", "[0, 2]", plain))[1].chain->calibration_error_deg,
            2);
  EXPECT_EQ(depths(levels_study("calibration_error_m", "[0, 0.1]", plain))[1].chain->calibration_error_m,
            0.1);
  const auto late =
      depths(levels_study("depth_delay_ms", "[0, 40]", std::string(plain) + "velocity_m_s = [1, 0, 0]"));
  EXPECT_EQ(late[0], depths(levels_study("calibration_error_m", "[0]", plain))[0]);
  EXPECT_EQ(late[1].chain->delay_ms, 40);
  EXPECT_EQ(late[1].chain->velocity_m_s[0], 1);
  const auto fields = depths(levels_study("depth_field_of_view_deg", "[30, 60, 90]",
                                          "source = \"pinhole\"\nsize_px = [320, 240]\nfx = 300"));
  for (const DepthSettings& depth : fields) EXPECT_EQ(pinhole_of(depth).camera.fx_px, 300);
  EXPECT_EQ(fields[1].width_px, 346);
  EXPECT_EQ(pinhole_of(fields[1]).camera.height_px, 260);
  EXPECT_EQ(pinhole_of(fields[1]).camera.cx_px, 173);
  EXPECT_NEAR(sensors::horizontal_field_of_view_deg(pinhole_of(fields[2]).camera), 90, 0.2);
}

TEST(StudyFileDepth, TexelsPerDegreeOfAPinholeKeepItsView) {
  const StudyDefinition study = levels_study("texels_per_degree", "[1, 2]", plain);
  for (const Stimulus& stimulus : list_stimuli(study)) {
    const sensors::PinholeCamera& camera = pinhole_of(stimulus.depth).camera;
    EXPECT_NEAR(sensors::horizontal_field_of_view_deg(camera), 60, 1e-9);
    EXPECT_NEAR(camera.fx_px * 3.14159265 / 180, stimulus.level, 0.02);
    EXPECT_EQ(stimulus.depth.width_px, camera.width_px);
  }
}

TEST(StudyFileDepth, LevelsNeedSomethingToChange) {
  EXPECT_THAT(
      levels_complaint("depth_noise", "[1]", plain),
      HasSubstr("depth: wanted a source with a noise model, because depth_noise is the level, found none"));
  EXPECT_THAT(levels_complaint("depth_delay_ms", "[1]", plain),
              HasSubstr("velocity_m_s, because depth_delay_ms"));
  EXPECT_THAT(levels_complaint(
                  "depth_noise", "[1]",
                  std::string(plain) + "noise = { model = \"generic\", relative_sigma = 0.1, scale = 2 }"),
              HasSubstr("depth.noise.scale: wanted nothing, because depth_noise is the level"));
  EXPECT_THAT(levels_complaint("calibration_error_m", "[1]", std::string(plain) + "calibration_error_m = 1"),
              HasSubstr("depth.calibration_error_m: wanted nothing, because"));
  EXPECT_THAT(levels_complaint("depth_field_of_view_deg", "[170]",
                               "source = \"pinhole\"\nsize_px = [320, 240]\nfx = 3000"),
              HasSubstr("wanted a depth map of 2 to 8192 pixels at 170 degrees"));
}

TEST(StudyFileDepth, WhatNothingWouldLookAtIsRefused) {
  const std::string pinhole = plain;
  EXPECT_THAT(depth_complaint("source = \"pinhole\"\nsize_px = [320, 240]\nfx = 0"),
              HasSubstr("depth.fx: wanted a number from 0.001 to 1000000 pixels, found 0"));
  EXPECT_THAT(depth_complaint(pinhole + "noise = { scale = 2 }"),
              HasSubstr("depth.noise.model: wanted \"generic\""));
  EXPECT_THAT(depth_complaint(pinhole + "noise = { model = \"generic\", modulation_hz = 1e7 }"),
              HasSubstr("depth.noise.modulation_hz: wanted"));
  EXPECT_THAT(depth_complaint(pinhole + "reduction = \"minimum\""),
              HasSubstr("depth.reduction: wanted a panorama"));
  EXPECT_THAT(depth_complaint(pinhole + "jump_ratio = 2"),
              HasSubstr("depth.jump_ratio: wanted jumps = \"cut\""));
  EXPECT_THAT(depth_complaint(pinhole + "jumps = \"cut\"\njump_ratio = 1"),
              HasSubstr("depth.jump_ratio: wanted a ratio above 1, found 1"));
  EXPECT_THAT(depth_complaint(pinhole + "jumps = \"cut\"\nlayer_px = 4"),
              HasSubstr("depth.layer_px: wanted jumps = \"layer\""));
  EXPECT_THAT(depth_complaint(pinhole + "border_extrusion_px = 4"),
              HasSubstr("depth.border_extrusion_px: wanted registration"));
  EXPECT_THAT(depth_complaint(pinhole + "delay_ms = 4"),
              HasSubstr("depth.delay_ms: wanted velocity_m_s beside it"));
  EXPECT_THAT(depth_complaint(pinhole + "velocity_m_s = [1, 0, 0]"),
              HasSubstr("depth.velocity_m_s: wanted delay_ms beside it"));
  EXPECT_THAT(depth_complaint(pinhole + "noise_sigmas = 2"),
              HasSubstr("depth.noise_sigmas: wanted a source with noise"));
  EXPECT_THAT(depth_complaint(pinhole + "projector_m = [1, 0, 0]"),
              HasSubstr("depth.projector_m: wanted the noise model"));
  EXPECT_THAT(depth_complaint(pinhole + "fx = 100"), HasSubstr("depth.field_of_view_deg: wanted one of"));
  EXPECT_THAT(depth_complaint(pinhole + "range_m = [3, 1]"),
              HasSubstr("depth.range_m: wanted two distances"));
  EXPECT_THAT(depth_complaint(pinhole + "repair = { radius_px = 2 }"),
              HasSubstr("depth.repair.method: wanted"));
  EXPECT_THAT(depth_complaint(pinhole + "repair = { method = \"nearest\", radius_px = 2 }"),
              HasSubstr("depth.repair.radius_px: wanted"));
  EXPECT_THAT(depth_complaint(pinhole + "fov = 3"), HasSubstr("depth.fov: wanted"));
  EXPECT_THAT(depth_complaint("source = \"file\"\nfile = \"a.png\"\nsize_px = [320, 240]\nfx = 100\n"),
              HasSubstr("depth.convention: wanted \"radial\" or \"planar\", which a file does not say"));
  EXPECT_THAT(
      depth_complaint(
          "source = \"file\"\nfile = \"a.png\"\nsize_px = [320, 240]\nfx = 100\nconvention = \"planar\"\n"
          "noise = { model = \"generic\" }"),
      HasSubstr("depth.noise: wanted nothing: the depths of a file have their noise already"));
  const auto panorama = [](const std::string& depth) {
    return test::complaint_of([&] { (void)study_of_depth("[depth]\n" + depth); });
  };
  EXPECT_THAT(panorama("registration = \"mesh\""),
              HasSubstr("depth.registration: wanted a pinhole or a file"));
  EXPECT_THAT(panorama("jumps = \"layer\""), HasSubstr("depth.jumps: wanted a pinhole or a file"));
  EXPECT_THAT(panorama("repair = \"planes\""), HasSubstr("depth.repair: wanted a pinhole or a file"));
  EXPECT_THAT(panorama("fx = 100"), HasSubstr("depth.fx: wanted nothing: a panorama"));
  EXPECT_THAT(panorama("calibration_error_m = 1"),
              HasSubstr("depth.calibration_error_m: wanted a pinhole or a file"));
  EXPECT_THAT(panorama("reduction_factor = 2"), HasSubstr("depth.reduction_factor: wanted a reduction"));
  EXPECT_THAT(panorama("reduction = \"median\"\nreduction_factor = 64"),
              HasSubstr("depth.reduction_factor: wanted a finer map of at most 16384 px, found 64 x 512 px"));
}

TEST(StudyFileDepth, TheOrderAndTheGuideOfARepairNeedWhatTheyOrder) {
  const std::string pinhole = plain;
  const StudyDefinition after =
      sensor_study(pinhole + "repair = \"nearest\"\nregistration = \"points\"\nrepair_after = true",
                   "[[condition]]\nname = \"after\"\n"
                   "[[condition]]\nname = \"before\"\ndepth.repair_after = false\n"
                   "[[condition]]\nname = \"unregistered\"\ndepth.registration = \"none\"\n");
  EXPECT_TRUE(after.conditions[0].depth.chain->repair_after);
  EXPECT_FALSE(after.conditions[1].depth.chain->repair_after);
  EXPECT_FALSE(after.conditions[2].depth.chain->repair_after);  // inherited where it means nothing
  EXPECT_THAT(depth_complaint(pinhole + "repair_after = true\nregistration = \"mesh\""),
              HasSubstr("depth.repair_after: wanted a repair beside it, found repair = \"none\""));
  EXPECT_THAT(depth_complaint(pinhole + "repair = \"nearest\"\nrepair_after = true"),
              HasSubstr("depth.repair_after: wanted registration = \"points\" or \"mesh\""));
  EXPECT_THAT(
      depth_complaint(pinhole + "repair = \"median\"\nrepair_guide = \"photograph\""),
      HasSubstr(
          "depth.repair_guide: wanted repair = \"joint_bilateral\" beside it, found repair = \"median\""));
  EXPECT_THAT(test::complaint_of([] {
                (void)study_of_depth("[depth]\nrepair = \"joint_bilateral\"\nrepair_guide = \"photograph\"");
              }),
              HasSubstr("depth.repair_guide: wanted a pinhole or a file"));
}

TEST(StudyFileDepth, BoxesAreAReductionOfAPanorama) {
  const StudyDefinition study = study_of_depth("[depth]\nreduction = \"boxes\"\n");
  EXPECT_TRUE(has_boxes(study.depth.chain.value()));
  EXPECT_EQ(std::get<PanoramaSource>(study.depth.chain->sources.front()).reduction_factor, 4);
  EXPECT_NE(study_hash(study), study_hash(study_of_depth("[depth]\nreduction = \"median\"\n")));
  EXPECT_THAT(depth_complaint(std::string(plain) + "reduction = \"boxes\""),
              HasSubstr("depth.reduction: wanted a panorama"));
}

TEST(StudyFileDepth, TheTextOfAChainTellsDifferentOnesApart) {
  std::set<std::string> texts;
  int chains = 0;
  for (const char* more : {"",
                           "skew = 1",
                           "distortion = [0.1, 0, 0, 0, 0]",
                           "range_m = [1, 2]",
                           "pose = { rotation_deg = [1, 0, 0] }",
                           "convention = \"radial\"",
                           "repair = \"nearest\"",
                           "repair = \"median\"",
                           "repair = { method = \"median\", fills = true }",
                           "repair = \"joint_bilateral\"",
                           "repair = \"joint_bilateral\"\nrepair_guide = \"photograph\"",
                           "repair = \"nearest\"\nregistration = \"points\"",
                           "repair = \"nearest\"\nregistration = \"points\"\nrepair_after = true",
                           "registration = \"points\"",
                           "registration = \"mesh\"",
                           "registration = \"mesh\"\nborder_extrusion_px = 2",
                           "jumps = \"cut\"",
                           "jumps = \"cut\"\njump_ratio = 1.3",
                           "jumps = \"layer\"",
                           "occlusion = \"depth_test\"",
                           "occlusion = \"depth_buffer\"",
                           "occlusion = \"depth_buffer\"\nbuffer_bits = 16",
                           "occlusion = \"depth_buffer\"\nbuffer_near_m = 0.2",
                           "occlusion = \"depth_buffer\"\nbuffer_far_m = 20",
                           "calibration_error_deg = 1",
                           "calibration_error_m = 1",
                           "delay_ms = 1\nvelocity_m_s = [1, 0, 0]",
                           "noise = { model = \"generic\", relative_sigma = 0.1 }",
                           "noise = { model = \"generic\", relative_sigma = 0.1, scale = 2 }",
                           "noise = { model = \"generic\", relative_sigma = 0.1 }\nnoise_sigmas = 1",
                           "noise = { model = \"time_of_flight\" }",
                           "noise = { model = \"structured_light\" }",
                           "noise = { model = \"structured_light\" }\nprojector_m = [0.1, 0, 0]"}) {
    texts.insert(canonical_text(sensor_study(std::string(plain) + more).depth.chain));
    ++chains;
  }
  EXPECT_EQ(static_cast<int>(texts.size()), chains);
}

}  // namespace
}  // namespace seamline
