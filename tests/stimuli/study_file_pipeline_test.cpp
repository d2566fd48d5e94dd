// What a study file says of methods of real time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

StudyDefinition piped(const std::string& tables, const std::string& artifacts = "\"all\"",
                      const std::string& widths = "[64, 512]") {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = " + widths + "\n" +
                     tables + "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [" + artifacts +
                     "]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml");
}

std::string pipeline_complaint(const std::string& tables, const std::string& artifacts = "\"all\"",
                               const std::string& widths = "[64, 512]") {
  return test::complaint_of([&] { (void)piped(tables, artifacts, widths); });
}

TEST(StudyFilePipeline, IsTheStudysOrAConditions) {
  EXPECT_EQ(piped("").depth.pipeline, Pipeline{});
  const StudyDefinition study = piped(
      "[pipeline]\nshadows = \"shadow_map\"\nshadow_map_px = 256\n[[condition]]\nname = "
      "\"a\"\n[[condition]]\n"
      "name = \"b\"\npipeline.shadow_filter = \"pcf\"\npipeline.occlusion = \"ghosts\"\n[[condition]]\n"
      "name = \"c\"\npipeline = {shadows = \"traced\", lights = \"median_cut\", light_count = 8, "
      "normals = \"cross_products\", compositing = \"dark_layer\"}\n");
  EXPECT_EQ(canonical_text(study.conditions[0].depth.pipeline), "shadows shadow_map none 256 px bias 1");
  EXPECT_EQ(canonical_text(study.conditions[1].depth.pipeline),
            "occlusion ghosts, shadows shadow_map pcf 256 px bias 1");
  EXPECT_EQ(canonical_text(study.conditions[2].depth.pipeline),
            "normals cross_products, lights median_cut 8, compositing dark_layer 0.5");
  EXPECT_EQ(list_truths(study).size(), 1U);
}

TEST(StudyFilePipeline, ChangesTheHashWhereItIsNotTraced) {
  EXPECT_EQ(study_hash(piped("[pipeline]\nshadows = \"traced\"\nlights = \"as_given\"")),
            study_hash(piped("")));
  EXPECT_NE(study_hash(piped("[pipeline]\nshadows = \"shadow_map\"")), study_hash(piped("")));
  EXPECT_NE(study_hash(piped("[pipeline]\nshadows = \"shadow_map\"")),
            study_hash(piped("[pipeline]\nshadows = \"shadow_map\"\nshadow_bias_texels = 2")));
}

TEST(StudyFilePipeline, LevelsAreOfAMethodThatEveryConditionUses) {
  const std::string maps =
      "[pipeline]\nshadows = \"shadow_map\"\n[level]\nquantity = \"shadow_map_px\"\n"
      "values = [64, 256]\n";
  const std::vector<Stimulus> stimuli = list_stimuli(piped(maps, "\"all\"", "512"));
  ASSERT_EQ(stimuli.size(), 6U);
  EXPECT_EQ(stimuli[0].depth.pipeline.shadow_map_px, 64);
  EXPECT_EQ(stimuli[1].depth.pipeline.shadow_map_px, 256);
  EXPECT_EQ(stimulus_id(stimuli[1]), "room-all-a-0256");
  const std::string lights = "[level]\nquantity = \"light_count\"\nvalues = [1, 4]\n[pipeline]\n";
  EXPECT_EQ(list_stimuli(piped(lights + "lights = \"median_cut\"\n", "\"all\"", "512"))[1]
                .depth.pipeline.light_count,
            4);
  EXPECT_THAT(pipeline_complaint(lights, "\"all\"", "512"), HasSubstr("median_cut"));
  EXPECT_THAT(pipeline_complaint("[level]\nquantity = \"light_count\"\nvalues = [3]\n[pipeline]\nlights = "
                                 "\"median_cut\"\n",
                                 "\"all\"", "512"),
              HasSubstr("powers of two"));
  EXPECT_THAT(pipeline_complaint(maps + "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\n"
                                        "pipeline.shadows = \"traced\"\n",
                                 "\"all\"", "512"),
              HasSubstr("condition b"));
  EXPECT_THAT(
      pipeline_complaint("[pipeline]\nshadows = \"shadow_map\"\nshadow_map_px = 64\n[level]\nquantity = "
                         "\"shadow_map_px\"\nvalues = [64, 256]\n",
                         "\"all\"", "512"),
      HasSubstr("is the level"));
}

TEST(StudyFilePipeline, RefusesWhatWouldBeIgnored) {
  const auto refuses = [](const char* key, const std::string& table, const std::string& artifacts) {
    EXPECT_THAT(pipeline_complaint("[pipeline]\n" + table, artifacts), HasSubstr(key)) << table;
  };
  refuses("shadow_filter", "shadow_filter = \"pcf\"", "\"all\"");
  refuses("shadow_map_px", "shadow_map_px = 64", "\"all\"");
  refuses("shadow_bias_texels", "shadow_bias_texels = 2", "\"all\"");
  refuses("light_count", "light_count = 4", "\"all\"");
  refuses("power of two", "lights = \"median_cut\"\nlight_count = 5", "\"all\"");
  refuses("shadow_opacity", "shadow_opacity = 0.2", "\"all\"");
  refuses("\"traced\" or \"shadow_map\"", "shadows = \"soft\"", "\"all\"");
  refuses("pipeline.occlusion", "occlusion = \"ghosts\"", "\"receiver\"");
  refuses("pipeline.shadows", "shadows = \"shadow_map\"", "\"occlusion\"");
  refuses("pipeline.normals", "normals = \"truth\"", "\"shadow\"");
  refuses("pipeline.lights", "lights = \"median_cut\"", "\"bounce\"");
  refuses("pipeline.compositing", "compositing = \"additive\"", "\"shadow\"");
  refuses("pipeline.compositing", "compositing = \"dark_layer\"", "\"bounce\"");
  EXPECT_THAT(pipeline_complaint("[pipeline]\nocclusion = \"ghosts\"\n[depth]\nocclusion = \"depth_test\""),
              HasSubstr("depth test"));
  EXPECT_THAT(pipeline_complaint("[pipeline]\nocclusion = \"ghosts\"\n[mitigation]\nocclusion = \"mask\""),
              HasSubstr("mitigation"));
  EXPECT_THAT(pipeline_complaint("[pipeline]\nshadows = \"shadow_map\"\n[mitigation]\nshadow = \"matte\""),
              HasSubstr("mitigation"));
}

TEST(StudyFilePipeline, FieldsHaveBandsAndShellsAndNoDarkLayer) {
  EXPECT_EQ(
      canonical_text(piped("[pipeline]\nshadows = \"occlusion_field\"\nfield_bands = 6").depth.pipeline),
      "shadows occlusion_field 6 bands 8 shells");
  EXPECT_THAT(pipeline_complaint("[pipeline]\nfield_bands = 2"), HasSubstr("occlusion_field"));
  EXPECT_THAT(pipeline_complaint("[pipeline]\nshadows = \"occlusion_field\"\nfield_bands = 9"),
              HasSubstr("field_bands"));
  EXPECT_THAT(pipeline_complaint("[pipeline]\nshadows = \"occlusion_field\"", "\"overlap\""),
              HasSubstr("pipeline.shadows"));
  EXPECT_THAT(pipeline_complaint("[pipeline]\nshadows = \"occlusion_field\"\ncompositing = \"dark_layer\""),
              HasSubstr("pipeline.compositing"));
}

TEST(StudyFilePipeline, OfTheReadyStudyHasATruthForEachSun) {
  const StudyDefinition study =
      read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / "realtime_methods.toml",
                 AssetCheck::not_needed);
  EXPECT_EQ(study.conditions.size(), 14U);
  EXPECT_EQ(list_truths(study).size(), 2U) << "one sun is hard and one soft";
}

}  // namespace
}  // namespace seamline
