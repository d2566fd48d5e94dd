// What a study file says of light: environment maps, suns and lamps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/stimulus.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

std::string lit_text(const std::string& light, const std::string& tables = "") {
  std::string text =
      "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 512]\n" + tables +
      "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n" + light;
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return text;
}

StudyDefinition lit_study(const std::string& light, const std::string& tables = "",
                          IdleSettings idle = IdleSettings::refused) {
  return read_study_text(lit_text(light, tables), "study.toml", idle);
}

std::string light_complaint(const std::string& light, const std::string& tables = "") {
  return test::complaint_of([&] { (void)lit_study(light, tables); });
}

TEST(StudyFileLight, WhatIsNotNamedLeavesTheHashAsItIs) {
  const std::string text = canonical_text(lit_study("").scenes[0]);
  for (const char* word : {"map", "suns", "lamp"}) EXPECT_EQ(text.find(word), std::string::npos) << text;
  EXPECT_NE(study_hash(lit_study("environment = \"sky.hdr\"")), study_hash(lit_study("")));
  EXPECT_NE(study_hash(lit_study("lamps = []")), study_hash(lit_study("")))
      << "no lamps are fewer than the file's own";
}

TEST(StudyFileLight, SetsAndLogsKeepSettingsThatWereAcceptedWhenTheyWereMade) {
  for (const char* idle : {"ao_distance_m = 3", "ambient_occlusion = true\nbounces = 2",
                           "ambient_occlusion = true\n[scene.sun]\nto_sun = [0, 1, 0]\n"}) {
    EXPECT_NE(light_complaint(idle), "no complaint") << idle;
    EXPECT_EQ(lit_study(idle, "", IdleSettings::kept).scenes.size(), 1U) << idle;
  }
  const std::string tolerance = "mesh = \"full\"\nmesh_tolerance = 0.01\n";
  EXPECT_NE(light_complaint("", tolerance), "no complaint");
  EXPECT_EQ(lit_study("", tolerance, IdleSettings::kept).scenes.size(), 1U);
}

TEST(StudyFileLight, ASetWithAnIdleSettingIsReadWhereItsStudyFileIsRefused) {
  const TemporaryFolder folder;
  const std::string idle = "ao_distance_m = 3\n";
  const std::string text = lit_text(idle);
  write_file_atomically(folder.path() / "study.toml", text);
  Manifest manifest;
  manifest.study_file = "study.toml";
  manifest.study_hash = study_hash(lit_study(idle, "", IdleSettings::kept));
  EXPECT_EQ(study_of_set(folder.path(), manifest).scenes[0].ao_distance_m, 3);
  EXPECT_THAT(
      test::complaint_of([&] { (void)read_study(folder.path() / "study.toml", AssetCheck::not_needed); }),
      HasSubstr("ao_distance_m: wanted ambient_occlusion = true beside it"));
  EXPECT_EQ(read_study_text(text, "a log's study").scenes[0].ao_distance_m, 3);
}

TEST(StudyFileLight, WhatOneConditionUsesIsNotIdle) {
  const StudyDefinition study = lit_study(
      "ambient_occlusion = true\nbounces = 4\n[scene.sun]\nto_sun = [0, 1, 0]\n",
      "[[condition]]\nname = \"ao\"\n[[condition]]\nname = \"traced\"\nambient_occlusion = false\n");
  EXPECT_FALSE(study.conditions[1].scenes[0].ambient_occlusion);
  EXPECT_EQ(study.conditions[1].scenes[0].bounces, 4);
  EXPECT_EQ(
      lit_study("ao_distance_m = 3\n",
                "[[condition]]\nname = \"far\"\nambient_occlusion = true\n[[condition]]\nname = \"no\"\n")
          .conditions[0]
          .scenes[0]
          .ao_distance_m,
      3);
}

TEST(StudyFileLight, ConditionsThatDifferInIdleSettingsAloneAreOne) {
  const std::string first = "[[condition]]\nname = \"one\"\nambient_occlusion = true\n[[condition]]\nname = ";
  const std::string sky = "environment = \"sky.hdr\"";
  for (const char* idle : {"bounces = 0", "environment_radiance = [1, 1, 1]", "environment_strength = 2"})
    EXPECT_THAT(light_complaint(sky, first + "\"other\"\nambient_occlusion = true\n" + idle + "\n"),
                testing::EndsWith("condition[1].name: wanted settings that no other condition has, found "
                                  "those of \"one\" under the name \"other\""))
        << idle;
  for (const char* used : {"ambient_occlusion = true\nao_distance_m = 3", "bounces = 0",
                           "ambient_occlusion = true\nenvironment_radiance = [2, 2, 2]",
                           "ambient_occlusion = true\nbounces = 0\nmesh = \"full\""})
    EXPECT_EQ(light_complaint(sky, first + "\"other\"\n" + used + "\n"), "no complaint") << used;
}

TEST(StudyFileLight, LampsSunsAndMapsAreRead) {
  const SceneDefinition scene =
      lit_study(
          "environment = \"sky.hdr\"\nenvironment_rotation_deg = 90\nenvironment_strength = 0.5\n"
          "suns = [{to_sun = [0, 2, 0], irradiance_w_m2 = [1, 2, 3]}, {to_sun = [1, 0, 0]}]\n"
          "lamps = [{position_m = [1, 2, 3], intensity_w_sr = [4, 5, 6]}, {position_m = [0, 3, 0], "
          "intensity_w_sr = [1, 1, 1], shines_along = [0, -2, 0], inner_deg = 10, outer_deg = 20}]")
          .scenes[0];
  EXPECT_EQ(scene.environment->file, "sky.hdr");
  EXPECT_EQ(scene.environment->rotation_deg, 90);
  EXPECT_EQ(scene.environment->strength, 0.5);
  ASSERT_EQ(scene.suns->size(), 2U);
  EXPECT_EQ((*scene.suns)[0].to_sun.y(), 1);
  ASSERT_EQ(scene.lamps->size(), 2U);
  EXPECT_FALSE((*scene.lamps)[0].is_spot);
  EXPECT_TRUE((*scene.lamps)[1].is_spot);
  EXPECT_EQ((*scene.lamps)[1].shines_along.y(), -1);
  EXPECT_EQ((*scene.lamps)[1].outer_deg, 20);
}

TEST(StudyFileLight, ConditionsChangeTheLightAndHaveTruthsOfTheirOwn) {
  const StudyDefinition study =
      lit_study("environment = \"sky.hdr\"",
                "[[condition]]\nname = \"sky\"\n[[condition]]\nname = \"constant\"\n"
                "environment_radiance = [1, 1, 1]\n[[condition]]\nname = \"turned\"\n"
                "environment_rotation_deg = 45\n[[condition]]\nname = \"two\"\n"
                "suns = [{to_sun = [0, 1, 0]}, {to_sun = [1, 1, 0]}]\n");
  EXPECT_EQ(list_truths(study).size(), 4U);
  EXPECT_TRUE(study.conditions[0].scenes[0].environment);
  EXPECT_FALSE(study.conditions[1].scenes[0].environment);
  EXPECT_EQ(study.conditions[2].scenes[0].environment->rotation_deg, 45);
  EXPECT_EQ(study.conditions[3].scenes[0].suns->size(), 2U);
}

TEST(StudyFileLight, WhatWouldBeIgnoredIsRefused) {
  EXPECT_THAT(light_complaint("environment = \"sky.hdr\"\nenvironment_radiance = [1, 1, 1]"),
              HasSubstr("not both"));
  EXPECT_THAT(light_complaint("environment_strength = 2"), HasSubstr("an environment map to change"));
  EXPECT_THAT(light_complaint("suns = [{to_sun = [0, 1, 0]}]\n[scene.sun]\nto_sun = [0, 1, 0]\n"),
              HasSubstr("one of sun and suns"));
  EXPECT_THAT(light_complaint("lamps = [{position_m = [0, 0, 0]}]"), HasSubstr("intensity_w_sr"));
  EXPECT_THAT(
      light_complaint("lamps = [{position_m = [0, 0, 0], intensity_w_sr = [1, 1, 1], outer_deg = 20}]"),
      HasSubstr("outer_deg"));
  EXPECT_THAT(
      light_complaint("lamps = [{position_m = [0, 0, 0], intensity_w_sr = [1, 1, 1], shines_along = [0, "
                      "-1, 0], inner_deg = 30, outer_deg = 20}]"),
      HasSubstr("inner_deg"));
  EXPECT_THAT(light_complaint("ambient_occlusion = true\nenvironment = \"sky.hdr\""),
              HasSubstr("ambient_occlusion"));
  EXPECT_THAT(light_complaint("bounces = 0.28"), testing::EndsWith("found 0.28"));
  EXPECT_THAT(light_complaint("bounces = []"), testing::EndsWith("found an empty array"));
  EXPECT_THAT(light_complaint("ao_distance_m = 3"),
              HasSubstr("ao_distance_m: wanted ambient_occlusion = true beside it"));
  EXPECT_THAT(light_complaint("", "[[condition]]\nname = \"far\"\nao_distance_m = 3\n"),
              HasSubstr("ao_distance_m: wanted ambient_occlusion = true beside it"));
  EXPECT_EQ(
      light_complaint("ambient_occlusion = true",
                      "[[condition]]\nname = \"near\"\n[[condition]]\nname = \"far\"\nao_distance_m = 3\n"),
      "no complaint");
  EXPECT_THAT(light_complaint("ambient_occlusion = true",
                              "[[condition]]\nname = \"none\"\n[[condition]]\nname = \"two\"\nbounces = 2\n"),
              HasSubstr("which has no bounce, found 2"));
  EXPECT_THAT(light_complaint("ambient_occlusion = true\nbounces = 2"),
              HasSubstr("which has no bounce, found 2"));
  EXPECT_THAT(light_complaint("ambient_occlusion = true\n[scene.sun]\nto_sun = [0, 1, 0]\n"),
              HasSubstr("sun: wanted no sun beside ambient_occlusion"));
}

StudyDefinition painted_study(const std::string& key, const std::string& artifact = "bounce",
                              const std::string& tables = "") {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 512]\n" + key +
                     tables + "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"" +
                     artifact + "\"]\n";
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml");
}

TEST(StudyFileMeshAlbedo, IsTheStudysOrAConditions) {
  EXPECT_EQ(painted_study("").depth.albedo, MeshAlbedo::constant);
  EXPECT_EQ(painted_study("mesh_albedo = \"truth\"").depth.albedo, MeshAlbedo::truth);
  const StudyDefinition study = painted_study("", "bounce",
                                              "[[condition]]\nname = \"grey\"\n[[condition]]\nname = "
                                              "\"photograph\"\nmesh_albedo = \"photograph\"\n");
  EXPECT_EQ(study.conditions[0].depth.albedo, MeshAlbedo::constant);
  EXPECT_EQ(study.conditions[1].depth.albedo, MeshAlbedo::photograph);
  EXPECT_EQ(list_truths(study).size(), 1U) << "only the mesh differs";
}

TEST(StudyFileMeshAlbedo, ChangesTheHashWhereItIsNotConstant) {
  EXPECT_EQ(study_hash(painted_study("mesh_albedo = \"constant\"")), study_hash(painted_study("")));
  EXPECT_NE(study_hash(painted_study("mesh_albedo = \"truth\"")), study_hash(painted_study("")));
  EXPECT_NE(study_hash(painted_study("mesh_albedo = \"truth\"")),
            study_hash(painted_study("mesh_albedo = \"photograph\"")));
}

TEST(StudyFileMeshAlbedo, IsRefusedWhereNothingLooksAtIt) {
  EXPECT_THAT(test::complaint_of([] { (void)painted_study("mesh_albedo = \"red\""); }),
              HasSubstr("\"constant\" or \"truth\" or \"photograph\""));
  EXPECT_THAT(test::complaint_of([] { (void)painted_study("mesh_albedo = \"truth\"", "receiver"); }),
              HasSubstr("mesh_albedo"));
  EXPECT_NO_THROW((void)painted_study("isolation = \"mask\"\nmesh_albedo = \"truth\"", "receiver"));
  for (const char* artifact : {"bounce", "reflection", "all"})
    EXPECT_NO_THROW((void)painted_study("mesh_albedo = \"truth\"", artifact));
}

}  // namespace
}  // namespace seamline
