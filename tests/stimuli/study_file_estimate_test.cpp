// Estimated depth in study files: files of estimates, one for each photograph, and stereo.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/stimulus.h"
#include "stimuli/set/depth_errors.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

StudyDefinition estimate_study(const std::string& depth, const std::string& top) {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\n" + top + "\n[depth]\n" + depth +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml");
}

constexpr const char* shares = "[level]\nquantity = \"estimate_share\"\nvalues = [0, 0.25, 1]";
constexpr const char* shares_of_panorama =
    "depth_width_px = 64\n[level]\nquantity = \"estimate_share\"\nvalues = [0, 0.25, 1]";
constexpr const char* camera = "size_px = [64, 48]\nfield_of_view_deg = 60\nconvention = \"planar\"\n";
constexpr const char* named = "source = \"file\"\nfile = \"e/{scene}-{object}.pfm\"\nvalue = \"inverse\"\n";

std::string estimate_complaint(const std::string& depth, const std::string& top = shares) {
  return test::complaint_of([&] { (void)estimate_study(depth, top); });
}

const FileSource& file_of(const Stimulus& stimulus) {
  return std::get<FileSource>(stimulus.depth.chain.value().sources.front());
}

TEST(StudyFileEstimate, EachStimulusHasItsOwnFile) {
  const auto study = estimate_study(std::string(named) + "align = \"least_squares\"\n" + camera, shares);
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  ASSERT_EQ(stimuli.size(), 9U);
  EXPECT_EQ(file_of(stimuli[1]).file, "e/room-a.pfm");
  EXPECT_EQ(file_of(stimuli[8]).file, "e/room-c.pfm");
  EXPECT_EQ(file_of(stimuli[1]).estimate->share, 0.25);
  EXPECT_EQ(stimulus_id(stimuli[1]), "room-receiver-a-0p2500");
}

TEST(StudyFileEstimate, AShareOfNothingIsTheExactSource) {
  const auto file = estimate_study(std::string(named) + "align = \"least_squares\"\n" + camera, shares);
  const auto exact = estimate_study(std::string("source = \"pinhole\"\n") + camera,
                                    "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.0001]");
  EXPECT_EQ(list_stimuli(file).front().depth, list_stimuli(exact).front().depth);
  const auto stereo = estimate_study(
      "source = \"stereo\"\nsize_px = [64, 48]\nfield_of_view_deg = 60\n"
      "baseline_m = 0.1\ndisparities_px = 16",
      shares);
  EXPECT_EQ(list_stimuli(stereo).front().depth, list_stimuli(exact).front().depth);
  const auto panorama = estimate_study(
      std::string(named) + "align = \"least_squares\"\nprojection = \"panorama\"", shares_of_panorama);
  EXPECT_FALSE(list_stimuli(panorama).front().depth.chain.has_value());
  EXPECT_TRUE(list_stimuli(panorama)[1].depth.chain.has_value());
}

TEST(StudyFileEstimate, WithoutAScaleItIsNoDistance) {
  EXPECT_THAT(estimate_complaint(std::string(named) + camera), HasSubstr("without a scale"));
  EXPECT_EQ(estimate_complaint(std::string(named) + "scale = 0.01\nshift = 0.1\n" + camera), "no complaint");
  EXPECT_THAT(estimate_complaint(std::string(named) + "align = \"least_squares\"\nscale = 2\n" + camera),
              HasSubstr("depth.scale"));
  EXPECT_THAT(estimate_complaint(std::string("source = \"file\"\nfile = \"d.png\"\nscale = 2\n") + camera),
              HasSubstr("value = \"inverse\""));
  EXPECT_THAT(estimate_complaint(std::string(named) + "scale = 2\nmetres_per_step = 0.001\n" + camera),
              HasSubstr("metres_per_step"));
}

TEST(StudyFileEstimate, WhatItCannotHaveIsRefused) {
  const std::string stereo =
      "source = \"stereo\"\nsize_px = [64, 48]\nfield_of_view_deg = 60\ndisparities_px = 16\n";
  EXPECT_THAT(estimate_complaint(stereo), HasSubstr("baseline_m"));
  EXPECT_THAT(estimate_complaint(stereo + "baseline_m = 0.1\nvalue = \"inverse\""), HasSubstr("value"));
  EXPECT_THAT(estimate_complaint(stereo + "baseline_m = 0.1\nblock_px = 4"), HasSubstr("odd"));
  EXPECT_THAT(estimate_complaint(stereo + "baseline_m = 0.1\nestimate_share = 0.5"),
              HasSubstr("estimate_share"));
  EXPECT_THAT(estimate_complaint(std::string("source = \"pinhole\"\n") + camera + "estimate_share = 0.5"),
              HasSubstr("estimate_share"));
  EXPECT_THAT(estimate_complaint(std::string("source = \"pinhole\"\n") + camera), HasSubstr("exact depth"));
  EXPECT_THAT(estimate_complaint(std::string(named) + "scale = 1\nprojection = \"panorama\"",
                                 "[level]\nquantity = \"depth_width_px\"\nvalues = [64, 128]"),
              HasSubstr("captured at any width"));
  EXPECT_THAT(estimate_complaint(std::string(named) + "scale = 1\nprojection = \"panorama\"",
                                 std::string("yaw_texels = 0.5\n") + shares_of_panorama),
              HasSubstr("yaw_texels"));
}

TEST(StudyFileEstimate, AFileOfDistancesMeansWhatItMeant) {
  const auto study = estimate_study(std::string("source = \"file\"\nfile = \"d.exr\"\n") + camera,
                                    "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.0001]");
  EXPECT_FALSE(file_of(list_stimuli(study).front()).estimate.has_value());
  EXPECT_EQ(canonical_text(study.depth.chain).find("value"), std::string::npos);
}

TEST(DepthErrors, AreTheMeansOfALevelAndLinearBetweenLevels) {
  Manifest manifest;
  for (const double level : {0.5, 1.0})
    for (const double of_object : {0.01, 0.03}) {
      ManifestStimulus record;
      record.stimulus.scene = "room";
      record.stimulus.quantity = Quantity::estimate_share;
      record.stimulus.level = level;
      record.mesh.depth_error = DepthErrorRecord{
          .compared = 10, .abs_rel = level * of_object, .rmse_m = level, .within_quarter = 1 - 0.1 * level};
      manifest.stimuli.push_back(record);
    }
  const std::vector<LevelDepthError> errors = depth_errors_of_set(manifest);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NEAR(errors[1].error.abs_rel, 0.02, 1e-12);
  EXPECT_EQ(errors[1].error.compared, 20);
  EXPECT_NEAR(depth_error_at(errors, "", 0.75)->abs_rel, 0.015, 1e-12);
  EXPECT_NEAR(depth_error_at(errors, "", 0.25)->abs_rel, 0.005, 1e-12);  // exact at 0
  EXPECT_NEAR(depth_error_at(errors, "", 0.25)->within_quarter, 0.975, 1e-12);
  EXPECT_FALSE(depth_error_at(errors, "", 1.5).has_value());
  EXPECT_FALSE(depth_error_at(errors, "other", 0.5).has_value());
  EXPECT_THAT(sentences(errors).at(0), HasSubstr("AbsRel 0.01, RMSE 0.5 m, delta < 1.25 95.0 % at 0.5; "));
}

}  // namespace
}  // namespace seamline
