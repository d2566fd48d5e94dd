// Thresholds of a report, and the depth width that they ask for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "composites/seamless_width.h"
#include "support/files/atomic_file.h"
#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;

TEST(SeamThresholds, AreReadFromAReport) {
  const fs::path path = fs::path(SEAMLINE_TEST_OUTPUT) / "thresholds.json";
  const auto read = [&](const std::string& text, const std::string& condition = "") {
    write_file_atomically(path, text);
    return read_thresholds(path, condition);
  };
  const std::string artifacts =
      R"("artifacts":[{"artifact":"receiver","perceptual_threshold_px":{"estimate":300.5,"reason":null},)"
      R"("slightly_noticeable_px":{"estimate":null,"reason":"below at every width"},"curve":[{"width_px":64}]},)"
      R"({"artifact":"occlusion","perceptual_threshold_px":{"estimate":null,"reason":"above at every width"},)"
      R"("slightly_noticeable_px":{"estimate":900}}])";
  const auto found = read(R"({"format":"seamline thresholds","version":1,)" + artifacts + "}");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].perceptual_px, 300.5);
  EXPECT_EQ(found[0].slightly_px, 64);
  EXPECT_FALSE(found[1].perceptual_px.has_value());
  EXPECT_EQ(seamless_width({.receiver = true}, found).width_px, 302);
  EXPECT_EQ(seamless_width({.occlusion = true}, found).width_px, 900);
  const auto said = [&](const std::string& text, const std::string& condition = "") {
    return complaint_of([&] { static_cast<void>(read(text, condition)); });
  };
  EXPECT_THAT(said("{}"), HasSubstr("thresholds.json"));
  EXPECT_THAT(said("[1"), HasSubstr("another kind of file"));
  const std::string conditions =
      R"({"format":"seamline thresholds","conditions":["soft","hard"],)" + artifacts + "}";
  EXPECT_THAT(said(conditions), HasSubstr("one of soft, hard"));
  EXPECT_THAT(said(R"({"format":"seamline thresholds","level":{},)" + artifacts + "}"),
              HasSubstr("depth widths"));
}

}  // namespace
}  // namespace seamline::renderer
