// What a study file says of pictures in all directions and of how people look at them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/definition/looks/study_look.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

using testing::HasSubstr;

std::string look_study(const std::string& tables, const std::string& keys, const std::string& camera) {
  std::string text = "format = \"seamline study 1\"\nname = \"small\"\ndepth_width_px = [64, 512]\n" + keys +
                     "\n" + tables +
                     "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"all\"]\n" + camera;
  for (const char* object : {"a", "b", "c"})
    text += std::string("\n[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
  return text;
}

const std::string round_camera =
    "[scene.camera]\nprojection = \"panorama\"\nposition_m = [0, 1, 0]\nlook_at_m = [1, 2, 0]\n";
const std::string round_size = "width_px = 512\nheight_px = 256";

StudyDefinition looked_at(const std::string& tables, const std::string& keys = round_size,
                          const std::string& camera = round_camera) {
  return read_study_text(look_study(tables, keys, camera), "study.toml");
}

std::string look_complaint(const std::string& tables, const std::string& keys = round_size,
                           const std::string& camera = round_camera) {
  return test::complaint_of([&] { (void)looked_at(tables, keys, camera); });
}

TEST(StudyFileLook, AStudyWithoutOneIsAsItWas) {
  const std::string camera = "[scene.camera]\nposition_m = [0, 1, 0]\nlook_at_m = [1, 1, 0]\n";
  const StudyDefinition plain = looked_at("", "", camera);
  EXPECT_EQ(plain.look, nullptr);
  EXPECT_FALSE(is_panorama(plain));
  EXPECT_EQ(canonical_text(plain).find("look"), std::string::npos);
  EXPECT_EQ(study_hash(looked_at("", "", camera + "projection = \"perspective\"\n")), study_hash(plain));
}

TEST(StudyFileLook, AQuestionAboutComfortIsNoPartOfTheHash) {
  const std::string look = "[look]\nkind = \"mouse\"\n";
  const StudyDefinition plain = looked_at(look);
  EXPECT_EQ(comfort_asked(plain), nullptr);
  const std::string question = look + "comfort_question = \"Dizzy?\"\n";
  const StudyDefinition asking = looked_at(question + "comfort_labels = [\"0\", \"1\", \"2\", \"3\", \"4\"]");
  ASSERT_NE(comfort_asked(asking), nullptr);
  EXPECT_EQ(comfort_asked(asking)->comfort_labels[4], "4");
  EXPECT_EQ(study_hash(asking), study_hash(plain));
  EXPECT_THAT(look_complaint(question + "comfort_labels = [\"0\", \"1\"]"), HasSubstr("five texts"));
  EXPECT_THAT(look_complaint(look + "comfort_labels = [\"0\"]"), HasSubstr("comfort_question beside it"));
}

TEST(StudyFileLook, BelongsToStudyOrConditionAndToTheHash) {
  const StudyDefinition study = looked_at(
      "[look]\nkind = \"mouse\"\nhorizontal_fov_deg = 80\n[[condition]]\nname = \"turned\"\n"
      "[[condition]]\nname = \"still\"\nlook.kind = \"fixed\"\n");
  EXPECT_TRUE(is_panorama(study));
  EXPECT_EQ(look_of(study, "turned")->kind, LookKind::mouse);
  EXPECT_EQ(look_of(study, "still")->kind, LookKind::fixed);
  EXPECT_EQ(look_of(study, "still")->horizontal_fov_deg, 80);
  EXPECT_EQ(list_truths(study).size(), 1U);  // one picture is rendered for both
  const std::array<double, 2> start = start_deg(*look_of(study, "still"), study, "room");
  EXPECT_EQ(start[0], 0);
  EXPECT_NEAR(start[1], 45, 1e-9);
  EXPECT_THAT(canonical_text(study), HasSubstr("look mouse 960 x 540 px 80 degrees yaw -180 180"));
  EXPECT_THAT(canonical_text(study), HasSubstr("look fixed"));
  const auto hash = [](const std::string& look) { return study_hash(looked_at("[look]\n" + look)); };
  EXPECT_NE(hash("kind = \"mouse\""), hash("kind = \"fixed\""));
  EXPECT_EQ(hash("kind = \"mouse\""), hash("kind = \"mouse\"\nhint = \"Turn round.\""));
}

TEST(StudyFileLook, EachEyeMayHaveAPanoramaInAHeadset) {
  const std::string head = "[look]\nkind = \"head\"\n", eyes = "[view]\nkind = \"omnidirectional\"\n";
  const StudyDefinition study = looked_at(head + eyes);
  EXPECT_EQ(study.scenes.front().view.kind, ViewKind::omnidirectional);
  EXPECT_THAT(canonical_text(study), HasSubstr("view omnidirectional, 2 views 0.065 m apart\n"));
  EXPECT_NE(study_hash(study), study_hash(looked_at(head)));
  const StudyDefinition both = looked_at(
      head +
      "[[condition]]\nname = \"flat\"\n[[condition]]\nname = \"eyes\"\nview.kind = \"omnidirectional\"\n"
      "[[condition]]\nname = \"mesh\"\nview.kind = \"omnidirectional\"\nview.parallax = \"depth\"\n");
  EXPECT_EQ(list_truths(both).size(), 3U);
  EXPECT_THAT(canonical_text(both), HasSubstr("0.065 m apart, parallax by depth"));
  EXPECT_THAT(look_complaint("[look]\nkind = \"mouse\"\n" + eyes),
              HasSubstr("view.kind: wanted look.kind = \"head\" beside \"omnidirectional\""));
  EXPECT_THAT(look_complaint(eyes, "", ""), HasSubstr("found no [look]"));
  EXPECT_THAT(look_complaint(head + eyes + "zero_parallax_m = 2\n"), HasSubstr("zero_parallax_m"));
  EXPECT_THAT(look_complaint(head + eyes + "views = 64\n", "width_px = 4096\nheight_px = 2048"),
              HasSubstr("at most 16384 rows"));
}

TEST(StudyFileLook, KeysMayChangeTheField) {
  const std::string look = "[look]\nkind = \"mouse\"\n";
  const StudyDefinition study = looked_at(look + "fov_limits_deg = [40, 90]\n");
  EXPECT_EQ(study.look->fov_limits_deg, (std::array{40.0, 90.0}));
  EXPECT_THAT(study.look->hint, HasSubstr("+ and -"));
  EXPECT_THAT(canonical_text(study), HasSubstr("field 40 90"));
  EXPECT_NE(study_hash(study), study_hash(looked_at(look)));
  EXPECT_EQ(looked_at(look + "fov_limits_deg = [40, 90]\nhint = \"Turn.\"\n").look->hint, "Turn.");
  EXPECT_THAT(look_complaint(look + "fov_limits_deg = [70, 90]"),
              HasSubstr("horizontal_fov_deg between them"));
  EXPECT_THAT(look_complaint("[look]\nfov_limits_deg = [40, 90]"), HasSubstr("kind = \"mouse\" beside it"));
}

TEST(StudyFileLook, WhatCannotBeIsRefusedByName) {
  EXPECT_THAT(look_complaint(""), HasSubstr("look: wanted a table [look]"));
  EXPECT_THAT(look_complaint("[look]\n", "", ""), HasSubstr("something to look round at"));
  EXPECT_THAT(look_complaint("[look]\n", ""), HasSubstr("twice height_px and a multiple of 64"));
  EXPECT_THAT(look_complaint("[look]\nkind = \"nose\""), HasSubstr("\"fixed\" or \"mouse\" or \"head\""));
  EXPECT_THAT(look_complaint("[look]\nkind = \"mous\""), HasSubstr("did you mean \"mouse\"?"));
  EXPECT_THAT(look_complaint("[look]\nkind = \"head\"\nstart_spread_deg = 9"),
              HasSubstr("look.start_spread_deg: wanted kind = \"mouse\" beside it, found kind = \"head\""));
  EXPECT_THAT(look_complaint("[look]\nyaw_deg = [-90, 90]"), HasSubstr("kind = \"mouse\" beside it"));
  EXPECT_THAT(look_complaint("[look]\nkind = \"mouse\"\nyaw_deg = [10, 90]"), HasSubstr("0 between them"));
  EXPECT_THAT(look_complaint("[look]\nkind = \"mouse\"\npitch_deg = [-10, 10]\nstart_deg = [0, 30]"),
              HasSubstr("within yaw_deg and pitch_deg"));
  EXPECT_THAT(look_complaint("[look]\nstart = 3"), HasSubstr("look.start"));
  EXPECT_THAT(look_complaint("[look]\n", round_size, round_camera + "horizontal_fov_deg = 60\n"),
              HasSubstr("look.horizontal_fov_deg"));
  EXPECT_THAT(look_complaint("[look]\n[view]\nkind = \"anaglyph\"\nzero_parallax_m = 2"),
              HasSubstr("view.kind: wanted nothing that is bound to one perspective view"));
  EXPECT_THAT(look_complaint("[look]\n[mitigation]\nocclusion = \"mask\""),
              HasSubstr("mitigation.occlusion"));
  EXPECT_THAT(look_complaint("[look]\n", round_size + "\nmesh_albedo = \"photograph\""),
              HasSubstr("mesh_albedo"));
}

}  // namespace
}  // namespace seamline
