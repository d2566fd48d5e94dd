// `[level]` and `[[condition]]` of a study file: what a study varies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A study whose files are not there, with one scene of the given artifact.
StudyDefinition study_with(const std::string& varied, const std::string& light = "") {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\n" + varied +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n" +
                     light;
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return read_study_text(text, "study.toml", IdleSettings::refused);
}

std::string complaint(const std::string& varied, const std::string& light = "") {
  return test::complaint_of([&] { (void)study_with(varied, light); });
}

std::vector<std::string> ids_of_first_object(const StudyDefinition& study) {
  std::vector<std::string> ids;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (stimulus.object_index == 1) ids.push_back(stimulus_id(stimulus));
  return ids;
}

TEST(StudyFileLevel, WidthsInATableAreTheShortFormsStudy) {
  const StudyDefinition brief = study_with("depth_width_px = [512, 64]");
  const StudyDefinition table = study_with("[level]\nquantity = \"depth_width_px\"\nvalues = [64, 512]");
  EXPECT_EQ(study_hash(brief), study_hash(table));
  EXPECT_EQ(ids_of_first_object(brief), ids_of_first_object(table));
  EXPECT_THAT(ids_of_first_object(table), ElementsAre("room-receiver-a-0064", "room-receiver-a-0512"));
  EXPECT_EQ(list_stimuli(table)[0].truth, "room");
}

TEST(StudyFileLevel, TolerancesHaveSortableIdsAndNoneIsTheFullMesh) {
  const StudyDefinition study =
      study_with("depth_width_px = 1024\n[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.01, 0, 1e-4]");
  EXPECT_THAT(ids_of_first_object(study),
              ElementsAre("room-receiver-a-0p000000000", "room-receiver-a-0p000100000",
                          "room-receiver-a-0p010000000"));
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  EXPECT_EQ(stimuli[0].depth.mesh, MeshDensity::full);
  EXPECT_EQ(stimuli[1].depth.mesh, MeshDensity::adaptive);
  EXPECT_EQ(stimuli[1].depth.mesh_tolerance, 1e-4);
  EXPECT_EQ(stimuli[2].depth.width_px, 1024);
  EXPECT_EQ(study.level.noticeability, Direction::increasing);
  EXPECT_EQ(list_truths(study).size(), 1U);
}

TEST(StudyFileLevel, TexelsPerDegreeAreWidths) {
  const StudyDefinition study =
      study_with("[level]\nquantity = \"texels_per_degree\"\nvalues = [0.1778, 1.4222, 11.3778]");
  EXPECT_EQ(depth_widths_px(study), (std::vector<int>{64, 512, 4096}));
  EXPECT_THAT(complaint("[level]\nquantity = \"texels_per_degree\"\nvalues = [0.5, 1.001]"),
              HasSubstr("level.values: wanted 360 times a value to be an even number of texels"));
}

TEST(StudyFileLevel, APartOfATexelIsAPhaseOfTheGridAndStandsInIds) {
  const StudyDefinition whole = study_with("yaw_texels = -3\ndepth_width_px = [64]\n");
  EXPECT_THAT(ids_of_first_object(whole), ElementsAre("room-receiver-a-0064-yaw-3"));
  const StudyDefinition part = study_with("yaw_texels = 0.25\ndepth_width_px = [64]\n");
  EXPECT_THAT(ids_of_first_object(part), ElementsAre("room-receiver-a-0064-yaw0p25"));
  EXPECT_THAT(complaint("yaw_texels = 20000\ndepth_width_px = [64]\n"), HasSubstr("yaw_texels: wanted"));
}

TEST(StudyFileLevel, ConditionsOfOneLightShareATruthAndOthersDoNot) {
  const StudyDefinition study = study_with(
      "depth_width_px = [64, 512]\n[[condition]]\nname = \"hard\"\n[[condition]]\nname = "
      "\"turned\"\nyaw_texels = 3\n"
      "[[condition]]\nname = \"soft\"\nsun_radius_deg = 2\n");
  EXPECT_THAT(ids_of_first_object(study),
              ElementsAre("room-receiver-a-hard-0064", "room-receiver-a-hard-0512",
                          "room-receiver-a-turned-0064-yaw3", "room-receiver-a-turned-0512-yaw3",
                          "room-receiver-a-soft-0064", "room-receiver-a-soft-0512"));
  std::set<std::string> truths;
  for (const Stimulus& stimulus : list_stimuli(study)) truths.insert(stimulus.truth);
  EXPECT_EQ(truths, (std::set<std::string>{"room-hard", "room-soft"}));
  const std::vector<SceneDefinition> scenes = list_truths(study);
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_FALSE(scenes[0].sun_radius_deg);
  EXPECT_EQ(scenes[1].sun_radius_deg, 2);
}

TEST(StudyFileLevel, ALevelThatChangesTheLightHasATruthForEachValue) {
  const StudyDefinition study =
      study_with("depth_width_px = 512\n[level]\nquantity = \"sun_radius_deg\"\nvalues = [0, 0.5]");
  EXPECT_THAT(ids_of_first_object(study), ElementsAre("room-receiver-a-00p000", "room-receiver-a-00p500"));
  const std::vector<SceneDefinition> scenes = list_truths(study);
  ASSERT_EQ(scenes.size(), 2U);
  EXPECT_EQ(scenes[1].truth, "room-00p500");
  EXPECT_EQ(list_stimuli(study)[1].truth, "room-00p500");
}

TEST(StudyFileLevel, EverySettingOfAConditionChangesTheStudysHash) {
  const std::string base =
      "depth_width_px = [64, 512]\n[[condition]]\nname = \"plain\"\n[[condition]]\nname = \"x\"\n";
  std::set<std::string> hashes = {study_hash(study_with("depth_width_px = [64, 512]"))};
  std::size_t tried = 1;
  for (const char* setting :
       {"isolation = \"mask\"", "mesh = \"full\"", "mesh_tolerance = 1e-3", "yaw_texels = 1",
        "sun_radius_deg = 1", "albedo = 0.4", "bounces = 2", "environment_radiance = [1, 2, 3]",
        "exposure_ev = 1", "ambient_occlusion = true", "ambient_occlusion = true\nao_distance_m = 3",
        "materials = \"gltf\""}) {
    hashes.insert(study_hash(study_with(base + setting)));
    ++tried;
  }
  EXPECT_EQ(hashes.size(), tried);
}

TEST(StudyFileLevel, AModelOfMaterialsIsAnotherTruthAndTheUsualOneIsNotSaid) {
  const std::string base =
      "depth_width_px = [64, 512]\n[[condition]]\nname = \"plain\"\n[[condition]]\nname = \"x\"\n";
  const StudyDefinition study = study_with(base + "materials = \"gltf\"");
  ASSERT_EQ(list_truths(study).size(), 2U);
  EXPECT_EQ(list_truths(study)[1].materials, MaterialModel::gltf);
  const std::string turned = base + "yaw_texels = 3\n";
  EXPECT_EQ(study_hash(study_with(turned + "materials = \"diffuse\"")), study_hash(study_with(turned)));
  EXPECT_EQ(canonical_text(study_with(turned)).find("materials"), std::string::npos);
  EXPECT_THAT(complaint(base + "materials = \"glossy\""),
              HasSubstr("materials: wanted \"diffuse\" or \"gltf\", found \"glossy\""));
}

TEST(StudyFileLevel, AnObserverMayHaveMidpointsInACondition) {
  const StudyDefinition study = study_with(
      "depth_width_px = [64, 512]\n[[condition]]\nname = \"hard\"\n[[condition]]\nname = "
      "\"soft\"\nsun_radius_deg = 2\n"
      "[observer.condition_midpoint.soft]\nreceiver = 120\n");
  EXPECT_EQ(study.observer.midpoint.at(Artifact::receiver), 300);
  EXPECT_EQ(study.observer.condition_midpoint.at("soft").at(Artifact::receiver), 120);
  EXPECT_EQ(study.observer.condition_midpoint.at("soft").at(Artifact::overlap), 900);
  EXPECT_FALSE(study.observer.condition_midpoint.contains("hard"));
}

TEST(StudyFileLevel, WhatAWidthMeansHasThePapersMidpointsAndOtherLevelsHaveNone) {
  const auto midpoints = [](const std::string& quantity, const std::string& values,
                            const std::string& top = "") {
    return study_with(top + "[level]\nquantity = \"" + quantity + "\"\nvalues = " + values).observer.midpoint;
  };
  const std::map<Artifact, double> of_widths = study_with("depth_width_px = [64, 512]").observer.midpoint;
  const std::map<Artifact, double> of_texels = midpoints("texels_per_degree", "[0.1778, 1.4222]");
  const std::map<Artifact, double> of_samples = midpoints("depth_samples", "[2048, 8192]");
  EXPECT_EQ(of_widths.at(Artifact::receiver), 300);
  ASSERT_EQ(of_texels.size(), of_widths.size());
  ASSERT_EQ(of_samples.size(), of_widths.size());
  for (const auto& [artifact, width_px] : of_widths) {
    EXPECT_DOUBLE_EQ(of_texels.at(artifact), width_px / 360);
    EXPECT_DOUBLE_EQ(of_samples.at(artifact), width_px * width_px / 2);
  }
  EXPECT_TRUE(midpoints("mesh_tolerance", "[0.01, 0.1]", "depth_width_px = 1024\n").empty());
}

TEST(StudyFileLevel, RefusesWhatWouldBeIgnoredOrMeanTwoThings) {
  const std::string widths = "depth_width_px = [64, 512]\n";
  EXPECT_THAT(complaint("depth_width_px = [64]\n[level]\nquantity = \"depth_width_px\"\nvalues = [64]"),
              HasSubstr("depth_width_px: wanted nothing, because depth_width_px is the level"));
  EXPECT_THAT(complaint("[level]\nquantity = \"mesh_tolerance\"\nvalues = [1e-3]"),
              HasSubstr("depth_width_px: wanted the width of all depth maps"));
  EXPECT_THAT(
      complaint(
          "depth_width_px = 64\nmesh = \"full\"\n[level]\nquantity = \"mesh_tolerance\"\nvalues = [1e-3]"),
      HasSubstr("mesh: wanted nothing, because mesh_tolerance is the level"));
  EXPECT_THAT(complaint("[level]\nquantity = \"width\"\nvalues = [1]"), HasSubstr("level.quantity"));
  EXPECT_THAT(complaint("[level]\nquantity = \"depth_width_px\"\nvalues = [64.5]"),
              HasSubstr("whole numbers"));
  EXPECT_THAT(complaint("[level]\nquantity = \"depth_width_px\"\nvalues = [0, 64]"),
              HasSubstr("from 2 to 16384 px"));
  EXPECT_THAT(complaint(widths + "[[condition]]\nname = \"a\"\ndepth_width_px = 64"),
              HasSubstr("condition[0].depth_width_px: wanted nothing"));
  EXPECT_THAT(complaint(widths + "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"a\"\nyaw_texels = 1"),
              HasSubstr("a name that no other condition has"));
  EXPECT_THAT(complaint(widths + "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\""),
              HasSubstr("settings that no other condition has"));
  EXPECT_THAT(complaint(widths + "[[condition]]\nname = \"A b\""), HasSubstr("lower-case letters"));
  EXPECT_THAT(complaint(widths + "[[condition]]\nname = \"a\"\nsun_radius = 1"), HasSubstr("sun_radius_deg"));
  EXPECT_THAT(complaint(widths + "[[condition]]\nname = \"a\"\nmesh = \"full\"\nmesh_tolerance = 0.1"),
              HasSubstr("the full mesh has no tolerance"));
  EXPECT_THAT(complaint(widths + "mesh = \"full\"\nmesh_tolerance = 0.01"),
              HasSubstr("mesh_tolerance: wanted mesh = \"adaptive\" beside it"));
  EXPECT_EQ(complaint(widths + "mesh = \"full\"\nmesh_tolerance = 0.01\n[[condition]]\nname = \"full\"\n"
                               "[[condition]]\nname = \"few\"\nmesh = \"adaptive\""),
            "no complaint");
  EXPECT_THAT(
      complaint(widths + "[[condition]]\nname = \"a\"\nsun_radius_deg = 1", "ambient_occlusion = true\n"),
      HasSubstr("has ambient_occlusion"));
  EXPECT_THAT(complaint("depth_width_px = 64\n[level]\nquantity = \"sun_radius_deg\"\nvalues = [0, 1]",
                        "ambient_occlusion = true\n"),
              HasSubstr("a sun in every scene"));
  EXPECT_THAT(
      complaint("procedure = \"quest_plus\"\ndepth_width_px = 64\n[level]\nquantity = \"mesh_tolerance\"\n"
                "values = [0, 1e-3]\n[quest_plus]\nmax_shows_per_image = 1"),
      HasSubstr("levels above 0 on the log2 axis"));
}

TEST(StudyFileLevel, MoreStimuliThanAManifestHoldsAreRefusedBeforeTheyAreListed) {
  const auto widths = [](int count) {
    std::string text = "depth_width_px = [2";
    for (int i = 2; i <= count; ++i) text += ", " + std::to_string(2 * i);
    std::string conditions = "]\n";
    for (int c = 0; c < 100; ++c)
      conditions += "[[condition]]\nname = \"c" + std::to_string(c) + "\"\nyaw_texels = 0." +
                    std::to_string(100 + c) + "\n";
    return text + conditions;
  };
  EXPECT_THAT(
      complaint(widths(667)),
      HasSubstr("scene: wanted at most 200000 stimuli (artifacts x objects x levels x conditions), or "
                "several studies, found 200100"));
  EXPECT_EQ(list_stimuli(study_with(widths(100))).size(), 30000U);
}

}  // namespace
}  // namespace seamline
