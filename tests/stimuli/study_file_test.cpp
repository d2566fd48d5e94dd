#include "stimuli/study_file/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "stimuli/definition/stimulus.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* minimal = R"(format = "seamline study 1"
name = "minimal"
depth_width_px = [512, 64]
[[scene]]
name = "room"
file = "builtin:bedroom"
artifacts = ["receiver", "shadow"]
[[scene.object]]
name = "a"
file = "builtin:statue"
[[scene.object]]
name = "b"
file = "builtin:teapot"
rotation_deg = [0, 90, 0]
[[scene.object]]
name = "c"
file = "builtin:creature"
position_m = [1, 2, 3]
)";

class StudyFile : public testing::Test {
 protected:
  void SetUp() override {
    path_ = fs::temp_directory_path() / ("seamline-study-" + std::to_string(::getpid()) + ".toml");
  }
  void TearDown() override { fs::remove(path_); }

  StudyDefinition read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_study(path_, AssetCheck::not_needed);
  }
  std::string complaint(const std::string& text) {
    return test::complaint_of([&] { (void)read(text); });
  }
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = minimal;
    return text.replace(text.find(from), from.size(), to);
  }
  fs::path path_;
};

TEST_F(StudyFile, DefaultsAreTheDesigns) {
  const StudyDefinition study = read(minimal);
  EXPECT_EQ(study.width_px, 960);
  EXPECT_EQ(study.height_px, 540);
  EXPECT_EQ(study.samples_per_pixel, 64);
  EXPECT_EQ(study.isolation, Isolation::query);
  EXPECT_EQ(study.scenes[0].bounces, 4);
  EXPECT_EQ(study.scenes[0].albedo, 0.5);
  EXPECT_EQ(study.scenes[0].ao_distance_m, 2.0);
  EXPECT_EQ(study.level.values, (std::vector<double>{64, 512}));
  EXPECT_EQ(study.scenes[0].objects[2].position_m, Eigen::Vector3d(1, 2, 3));
}

TEST_F(StudyFile, StimuliAreScenesTimesArtifactsTimesObjectsTimesWidths) {
  const std::vector<Stimulus> stimuli = list_stimuli(read(minimal));
  ASSERT_EQ(stimuli.size(), 2U * 3 * 2);
  EXPECT_EQ(stimulus_id(stimuli[0]), "room-receiver-a-0064");
  EXPECT_EQ(stimulus_id(stimuli[11]), "room-shadow-c-0512");
  EXPECT_EQ(stimuli[11].object_index, 3);
}

TEST_F(StudyFile, ComplaintsNameTheKey) {
  EXPECT_THAT(complaint(with("depth_width_px = [512, 64]", "depth_width_px = [511]")),
              HasSubstr("depth_width_px: wanted even widths, found 511"));
  EXPECT_THAT(complaint(with("depth_width_px = [512, 64]", "depth_width_px = [64, 64]")),
              HasSubstr("widths that differ"));
  EXPECT_THAT(complaint(with("name = \"b\"", "name = \"a\"")), HasSubstr("scene[0].object[1].name"));
  EXPECT_THAT(complaint(with("name = \"b\"", "name = \"B!\"")), HasSubstr("lower-case"));
  EXPECT_THAT(complaint(with("rotation_deg = [0, 90, 0]", "rotation_deg = [0, 900, 0]")),
              HasSubstr("degrees"));
  EXPECT_THAT(complaint(with("rotation_deg = [0, 90, 0]", "rotation_rad = [0, 1, 0]")),
              HasSubstr("rotation_deg"));
  EXPECT_THAT(complaint(with("seamline study 1", "seamline study 2")), HasSubstr("format"));
  EXPECT_THAT(complaint(with("[[scene.object]]\nname = \"a\"\nfile = \"builtin:statue\"\n", "")),
              HasSubstr("three objects"));
  EXPECT_THAT(complaint(with("name = \"room\"", "name = \"room\"\nbounces = 2.5")),
              HasSubstr("scene[0].bounces: wanted a whole number"));
  EXPECT_THAT(complaint(with("name = \"room\"", "name = \"room\"\nexposure_ev = nan")),
              HasSubstr("exposure_ev"));
}

TEST_F(StudyFile, HashIsOverMeaningNotLayout) {
  const std::string hash = study_hash(read(minimal));
  EXPECT_EQ(hash, study_hash(read(std::string("# a comment\n") + minimal)));
  EXPECT_EQ(hash, study_hash(read(with("[512, 64]", "[64,   512]"))));
  EXPECT_NE(hash, study_hash(read(with("[1, 2, 3]", "[1, 2, 4]"))));
}

TEST(Pattern, StarsStandForAnyText) {
  EXPECT_TRUE(matches_pattern("bedroom-receiver-statue-0512", ""));
  EXPECT_TRUE(matches_pattern("bedroom-receiver-statue-0512", "bedroom*0512"));
  EXPECT_TRUE(matches_pattern("bedroom-receiver-statue-0512", "*statue*"));
  EXPECT_FALSE(matches_pattern("bedroom-receiver-statue-0512", "bedroom"));
  EXPECT_FALSE(matches_pattern("bedroom-receiver-statue-0512", "*0064"));
}

}  // namespace
}  // namespace seamline
