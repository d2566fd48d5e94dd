// Studies whose level is a number of depth samples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

constexpr const char* levels = "[level]\nquantity = \"depth_samples\"\nvalues = [2048, 8192]\n";

StudyDefinition samples_study(const std::string& varied, const std::string& top = levels) {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\n" + top + varied +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml");
}

std::string complaint_of_budget(const std::string& varied, const std::string& top = levels) {
  return test::complaint_of([&] { (void)samples_study(varied, top); });
}

TEST(BudgetedStudy, ANumberOfSamplesIsThatOfAUniformMap) {
  const StudyDefinition study = samples_study(
      "[[condition]]\nname = \"uniform\"\n[[condition]]\nname = \"budgeted\"\ndepth.reduction = "
      "\"budgeted\"\n");
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  EXPECT_EQ(stimuli.front().depth, DepthSettings{.width_px = 64});  // the paper's exact panorama
  EXPECT_EQ(stimuli.front().level, 2048);
  EXPECT_EQ(stimuli[1].depth.width_px, 128);
  EXPECT_TRUE(is_budgeted(stimuli[2].depth.chain.value()));
  EXPECT_EQ(stimuli[2].depth.width_px, 64);
  EXPECT_EQ(stimulus_id(stimuli[2]), "room-receiver-a-budgeted-000002048");
}

TEST(BudgetedStudy, BudgetsAreOtherStudies) {
  const std::string plain = study_hash(samples_study(""));
  const std::string jumps = study_hash(samples_study("[depth]\nreduction = \"jumps\"\n"));
  const std::string budgeted = study_hash(samples_study("[depth]\nreduction = \"budgeted\"\n"));
  EXPECT_NE(plain, jumps);
  EXPECT_NE(jumps, budgeted);
}

TEST(BudgetedStudy, WhatItCannotHaveIsRefusedByName) {
  EXPECT_THAT(complaint_of_budget("", "[level]\nquantity = \"depth_samples\"\nvalues = [2000]\n"),
              HasSubstr("wanted W x W / 2 samples of an even width W, such as 2048 (64 x 32), found 2000"));
  const std::string budgeted = "[depth]\nreduction = \"budgeted\"\n";
  EXPECT_THAT(complaint_of_budget(budgeted + "reduction_factor = 4\n"),
              HasSubstr("depth.reduction_factor: wanted a reduction from a finer map"));
  EXPECT_THAT(complaint_of_budget(budgeted + "jumps = \"cut\"\n"),
              HasSubstr("beside reduction = \"budgeted\""));
  EXPECT_THAT(complaint_of_budget(budgeted + "repair = \"median\"\n"),
              HasSubstr("depth.repair: wanted \"none\""));
  EXPECT_THAT(complaint_of_budget(budgeted + "noise = { model = \"generic\", relative_sigma = 0.1 }\n"),
              HasSubstr("depth.noise: wanted no noise"));
  EXPECT_THAT(complaint_of_budget(budgeted + "range_m = [0.5, 5]\n"),
              HasSubstr("depth.range_m: wanted no range"));
  EXPECT_THAT(complaint_of_budget(budgeted, std::string("mesh = \"full\"\n") + levels),
              HasSubstr("mesh: wanted nothing beside"));
  EXPECT_THAT(complaint_of_budget("depth_width_px = 64\n"), HasSubstr("depth_width_px"));
  EXPECT_THAT(
      complaint_of_budget("[depth]\nsource = \"pinhole\"\nsize_px = [320, 240]\nfield_of_view_deg = 60\n"),
      HasSubstr("wanted a panorama, because depth_samples is the level"));
  EXPECT_THAT(complaint_of_budget(budgeted,
                                  "depth_width_px = 64\n[level]\nquantity = \"mesh_tolerance\"\nvalues = "
                                  "[0.001, 0.01]\n"),
              HasSubstr("wanted another level than mesh_tolerance"));
}

}  // namespace
}  // namespace seamline
