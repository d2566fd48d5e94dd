// What a study file says of how pictures are shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

StudyDefinition shown(const std::string& tables, const std::string& keys = "") {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 512]\n" + keys +
                     tables + "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"all\"]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml");
}

std::string view_complaint(const std::string& tables, const std::string& keys = "") {
  return test::complaint_of([&] { (void)shown(tables, keys); });
}

const std::string three =
    "[view]\nseparation_m = 0.07\nzero_parallax_m = 3\n[[condition]]\nname = \"mono\"\n[[condition]]\n"
    "name = \"two\"\nview.kind = \"side_by_side\"\n[[condition]]\nname = \"five\"\n"
    "view = {kind = \"interleaved\", preset = \"five_views\", panel_px = [1920, 1080]}\n";

TEST(StudyFileView, WhatNamesNoViewIsAsItWas) {
  const StudyDefinition plain = shown("");
  EXPECT_TRUE(plain.scenes.front().view.is_mono());
  EXPECT_EQ(canonical_text(plain).find("view"), std::string::npos);
  EXPECT_EQ(study_hash(shown("[view]\nkind = \"mono\"\n")), study_hash(plain));
  EXPECT_EQ(list_truths(plain).front().truth, "room");
  EXPECT_EQ(stimulus_id(list_stimuli(plain).front()), "room-all-a-0064");
}

TEST(StudyFileView, HashesAreThoseOfBeforeThereWereViews) {
  // Taken from the version before: a study that keeps its meaning keeps its hash. The quick study had other
  // widths.
  StudyDefinition quick = read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "quick.toml",
                                     AssetCheck::not_needed);
  quick.level.values = {64, 256, 512, 1024, 4096};
  EXPECT_EQ(study_hash(quick), "fa2443562a1a7d3f6269bab6e9f2971a38d15006cc9b1001b9641cf65073beb1");
  EXPECT_EQ(
      study_hash(read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "realtime_methods.toml",
                            AssetCheck::not_needed)),
      "8f5577bc4dd12bf502b3ba28617d09b60cc6c647bdcd84ab5f71ea385c30d5a7");
}

TEST(StudyFileView, IsATruthOfItsOwn) {
  const StudyDefinition study = shown(three);
  const std::vector<SceneDefinition> truths = list_truths(study);
  ASSERT_EQ(truths.size(), 3U);
  EXPECT_EQ(truths[0].truth, "room-mono");
  EXPECT_EQ(truths[1].truth, "room-two");
  EXPECT_EQ(canonical_text(truths[1].view), "side_by_side, 2 views 0.07 m apart, zero parallax 3 m");
  EXPECT_EQ(canonical_text(truths[2].view),
            "interleaved, 5 views 0.07 m apart, zero parallax 3 m, pitch 5 slant 18.43494882292201 offset 0, "
            "panel 1920 x 1080");
  EXPECT_EQ(stimulus_id(list_stimuli(study)[2]), "room-all-a-two-0064");
  ASSERT_TRUE(panel_view(study));
  EXPECT_EQ(panel_view(study)->place_on_panel_px(study.width_px), (std::array{480, 0}));
}

TEST(StudyFileView, LensSheetsHaveAPresetAndKeysOfTheirOwn) {
  const StudyDefinition study = shown(
      "[view]\nkind = \"interleaved\"\nzero_parallax_m = 2\npanel_px = [1920, 1200]\nviews = 9\n"
      "pitch_subpixels = 4.5\nslant_deg = -9.46\noffset_subpixels = 1.5\n");
  const View& view = study.scenes.front().view;
  EXPECT_EQ(view.views, 9);
  EXPECT_EQ(view.sheet, (LensSheet{.pitch_subpixels = 4.5, .slant_deg = -9.46, .offset_subpixels = 1.5}));
  EXPECT_EQ(view.separation_m, 0.065);
}

TEST(StudyFileView, RefusesWhatNoEyeCouldSee) {
  const auto stereo = [](const std::string& keys) {
    return view_complaint("[view]\nkind = \"side_by_side\"\n" + keys);
  };
  EXPECT_THAT(stereo("zero_parallax_m = 2\nseparation_m = 0"), HasSubstr("view.separation_m"));
  EXPECT_THAT(stereo("zero_parallax_m = 2\nseparation_m = -0.065"), HasSubstr("view.separation_m"));
  EXPECT_THAT(stereo("zero_parallax_m = -2"), HasSubstr("in front of the eyes"));
  EXPECT_THAT(stereo(""), HasSubstr("the distance in metres at which the screen seems to be"));
  EXPECT_THAT(stereo("zero_parallax_m = nan"), HasSubstr("view.zero_parallax_m"));
  const auto sheet = [](const std::string& keys) {
    return view_complaint("[view]\nkind = \"interleaved\"\nzero_parallax_m = 2\n" + keys);
  };
  const std::string panel = "panel_px = [1920, 1080]\n";
  EXPECT_THAT(sheet("preset = \"five_views\""), HasSubstr("view.panel_px"));
  EXPECT_THAT(sheet(panel + "views = 1"), HasSubstr("view.views"));
  EXPECT_THAT(sheet(panel + "pitch_subpixels = 0"), HasSubstr("view.pitch_subpixels"));
  EXPECT_THAT(sheet(panel + "slant_deg = 90"), HasSubstr("view.slant_deg"));
  EXPECT_THAT(sheet(panel + "preset = \"six\""), HasSubstr("\"five_views\""));
  EXPECT_THAT(sheet("panel_px = [1920]"), HasSubstr("width and height of the screen"));
  EXPECT_THAT(sheet("panel_px = [640, 480]"), HasSubstr("at least the picture's 960 x 540"));
  EXPECT_THAT(view_complaint("[view]\nkind = \"2d_plus_depth\"\n"), HasSubstr("view.max_depth_m"));
  EXPECT_THAT(view_complaint("[view]\nkind = \"side_by_side\"\nzero_parallax_m = 2\n", "width_px = 321\n"),
              HasSubstr("an even width"));
  EXPECT_THAT(view_complaint("[view]\nkind = \"hologram\"\n"), HasSubstr("\"2d_plus_depth\""));
}

TEST(StudyFileView, RefusesKeysThatAreIgnored) {
  EXPECT_THAT(view_complaint("[view]\nkind = \"mono\"\nseparation_m = 0.065\n"),
              HasSubstr("\"side_by_side\" or \"anaglyph\" or \"interleaved\""));
  EXPECT_THAT(view_complaint("[view]\nkind = \"side_by_side\"\nzero_parallax_m = 2\nviews = 5\n"),
              HasSubstr("view.kind = \"interleaved\""));
  EXPECT_THAT(view_complaint("[view]\nkind = \"side_by_side\"\nzero_parallax_m = 2\nmatrix = \"dubois\"\n"),
              HasSubstr("\"anaglyph\""));
  EXPECT_THAT(view_complaint("[view]\nzero_parallax_m = 2\n[[condition]]\nname = \"a\"\n"
                             "view = {kind = \"anaglyph\", pitch_subpixels = 5}\n"),
              HasSubstr("condition[0].view.pitch_subpixels"));
  EXPECT_THAT(view_complaint("[view]\nkind = \"anaglyph\"\nzero_paralax_m = 2\n"),
              HasSubstr("zero_parallax_m"));
}

TEST(StudyFileView, RefusesWhatIsBoundToThePhotographsOwnPixels) {
  const std::string view = "[view]\nkind = \"side_by_side\"\nzero_parallax_m = 2\n";
  EXPECT_THAT(view_complaint(view, "mesh_albedo = \"photograph\"\n"), HasSubstr("mesh_albedo"));
  EXPECT_THAT(view_complaint(view + "[mitigation]\nocclusion = \"mask\"\n"),
              HasSubstr("mitigation.occlusion"));
  EXPECT_THAT(view_complaint(view + "[pipeline]\nocclusion = \"ghosts\"\n"), HasSubstr("pipeline.occlusion"));
  EXPECT_THAT(view_complaint(view + "[pipeline]\nnormals = \"cross_products\"\n"),
              HasSubstr("pipeline.normals"));
  EXPECT_EQ(view_complaint(view + "[pipeline]\nshadows = \"shadow_map\"\n"), "no complaint");
}

TEST(StudyFileView, OneStudyHasOneScreen) {
  EXPECT_THAT(view_complaint("[view]\nzero_parallax_m = 2\n[[condition]]\nname = \"a\"\n"
                             "view = {kind = \"anaglyph\", panel_px = [1920, 1080]}\n[[condition]]\n"
                             "name = \"b\"\nview = {kind = \"side_by_side\", panel_px = [1920, 1200]}\n"),
              HasSubstr("one screen for all conditions"));
}

}  // namespace
}  // namespace seamline
