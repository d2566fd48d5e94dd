// `[depth] occlusion` of a study file: who is in front.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/stimuli/study_of_depth.h"

namespace seamline {
namespace {

using test::depth_complaint;
using test::levels_complaint;
using test::plain;
using test::sensor_study;
using test::study_of_depth;
using testing::HasSubstr;

TEST(StudyFileOcclusion, WhoIsInFrontIsTheMeshOrATestAPixel) {
  const StudyDefinition study = study_of_depth(
      "[depth]\nocclusion = \"depth_buffer\"\nbuffer_bits = 16\nbuffer_near_m = 0.01\n"
      "[[condition]]\nname = \"mesh\"\ndepth.occlusion = \"mesh\"\n"
      "[[condition]]\nname = \"test\"\ndepth.occlusion = \"depth_test\"\n"
      "[[condition]]\nname = \"coarse\"\n"
      "[[condition]]\nname = \"fine\"\ndepth.buffer_bits = 24\n");
  EXPECT_FALSE(study.conditions[0].depth.chain.has_value());
  EXPECT_EQ(word(study.conditions[1].depth.chain.value().occlusion), "depth_test");
  EXPECT_EQ(study.conditions[2].depth.chain.value().buffer,
            (sensors::DepthBuffer{.nearest_m = 0.01, .farthest_m = 100, .bits = 16}));
  EXPECT_EQ(study.conditions[3].depth.chain.value().buffer.bits, 24);
  EXPECT_THAT(depth_complaint(std::string(plain) + "occlusion = \"shader\""),
              HasSubstr("depth.occlusion: wanted \"mesh\" or \"depth_test\" or \"depth_buffer\""));
  EXPECT_THAT(depth_complaint(std::string(plain) + "occlusion = \"depth_test\"\nbuffer_bits = 16"),
              HasSubstr("depth.buffer_bits: wanted occlusion = \"depth_buffer\", found occlusion = "
                        "\"depth_test\""));
  EXPECT_THAT(depth_complaint(std::string(plain) + "buffer_far_m = 16"),
              HasSubstr("depth.buffer_far_m: wanted occlusion = \"depth_buffer\""));
  EXPECT_THAT(depth_complaint(std::string(plain) + "occlusion = \"depth_buffer\"\nbuffer_bits = 7"),
              HasSubstr("depth.buffer_bits: wanted a whole number from 8 to 32"));
  EXPECT_THAT(depth_complaint(std::string(plain) +
                              "occlusion = \"depth_buffer\"\nbuffer_near_m = 2\nbuffer_far_m = 2"),
              HasSubstr("depth.buffer_far_m: wanted a plane beyond buffer_near_m = 2, found 2"));
}

TEST(StudyFileOcclusion, ATestAPixelNeedsDepthOfThePhotographsPlace) {
  const std::string aside = std::string(plain) + "pose = { position_m = [0.1, 0, 0] }\n";
  const std::string test = "occlusion = \"depth_test\"\n";
  for (const std::string& depth : {plain + test, plain + test + "pose = { rotation_deg = [5, 0, 0] }",
                                   aside + test + "registration = \"points\"",
                                   aside + test + "registration = \"mesh\"\ncalibration_error_m = 1"})
    EXPECT_TRUE(is_in_photographs_place(sensor_study(depth).depth.chain.value())) << depth;
  for (const std::string& depth : {aside + test, plain + test + "calibration_error_m = 1",
                                   plain + test + "delay_ms = 10\nvelocity_m_s = [1, 0, 0]"})
    EXPECT_THAT(depth_complaint(depth),
                HasSubstr("depth.occlusion: wanted \"mesh\", or registration = \"points\" or \"mesh\""))
        << depth;
  EXPECT_THAT(levels_complaint("calibration_error_m", "[0, 0.1]", plain + test),
              HasSubstr("depth.occlusion: wanted \"mesh\", or registration"));
}

}  // namespace
}  // namespace seamline
