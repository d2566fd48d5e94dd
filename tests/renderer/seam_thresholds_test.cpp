// Thresholds of a report, and the depth width that they ask for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/report/json/json_values.h"
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
  const StudyThresholds study = read(R"({"format":"seamline thresholds","version":1,)" + artifacts + "}");
  EXPECT_FALSE(study.joint || study.simulated);
  const std::vector<SeamThresholds>& found = study.artifacts;
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

StudyThresholds of_report(const std::string& headline, const std::string& artifact) {
  const fs::path path = fs::path(SEAMLINE_TEST_OUTPUT) / "record_thresholds.json";
  write_file_atomically(path, R"({"format":"seamline thresholds","simulated":true,"source":"40 simulated",)"
                              R"("headline":")" +
                                  headline + R"(","artifacts":[{"artifact":"receiver",)" + artifact + "}]}");
  return read_thresholds(path, "");
}

/// The only need of a picture whose receiver is present.
WidthNeed receiver_need(const StudyThresholds& study) {
  return seamless_width({.receiver = true}, study.artifacts).needs.at(0);
}

TEST(SeamThresholds, AreTheNumbersThatTheHeadlineNames) {
  const std::string both =
      R"("perceptual_threshold_px":{"estimate":null,"reason":"above 828"},)"
      R"("slightly_noticeable_px":{"estimate":561.4,"reason":null},"curve":[{"width_px":64}],)"
      R"("joint":{"perceptual_threshold_px":{"estimate":704.49,"reason":null,"ci95":[545,1200]},)"
      R"("slightly_noticeable_px":{"estimate":409.1,"reason":null},"detection_px":{"estimate":300}})";
  const StudyThresholds joint = of_report("joint", both);
  EXPECT_TRUE(joint.joint && joint.simulated);
  EXPECT_EQ(joint.source, "40 simulated");
  EXPECT_EQ(receiver_need(joint).width_px, 706);
  EXPECT_EQ(receiver_need(joint).rule, "PT: not noticed");
  EXPECT_EQ(receiver_need(of_report("paper_way", both)).width_px, 562);
}

TEST(SeamThresholds, OfAnswersWithoutRatingsAreThoseOfDetection) {
  const WidthNeed seen =
      receiver_need(of_report("joint", R"("joint":{"detection_px":{"estimate":320.9,"reason":null}})"));
  EXPECT_EQ(seen.width_px, 322);
  EXPECT_THAT(seen.rule, HasSubstr("detection: fewer than half"));
  const WidthNeed unseen =
      receiver_need(of_report("joint", R"("joint":{"detection_px":{"estimate":null,"reason":"above"}})"));
  EXPECT_FALSE(unseen.width_px.has_value());
  EXPECT_THAT(unseen.rule, HasSubstr("no detection threshold"));
}

TEST(SeamThresholds, OfAStudyWithRatingsAreNeverThoseOfDetection) {
  // Half of the people see a seam of that width: it is no smaller one.
  const WidthNeed none = receiver_need(of_report(
      "joint",
      R"("joint":{"perceptual_threshold_px":{"estimate":null,"reason":"at the levels hardest to see"},)"
      R"("slightly_noticeable_px":{"estimate":null,"reason":"at the levels hardest to see"},)"
      R"("detection_px":{"estimate":300}})"));
  EXPECT_FALSE(none.width_px.has_value());
  EXPECT_THAT(none.rule, HasSubstr("neither PT nor SN"));
}

TEST(SeamThresholds, BelowAllWidthsAreTheSmallestOrTheUpperEndOfTheInterval) {
  const auto with_interval = [](const std::string& interval) {
    return receiver_need(of_report(
        "joint",
        R"("curve":[{"width_px":64}],"joint":{"perceptual_threshold_px":{"estimate":null,)"
        R"("reason":"at the levels easiest to see or before: no lower end of its interval","ci95":)" +
            interval + "}}"));
  };
  EXPECT_EQ(with_interval("[null,40]").width_px, 64);
  EXPECT_EQ(with_interval("[null,90.5]").width_px, 92);
}

/// As `analyze` writes them, and as earlier versions wrote them: with the sentence alone.
TEST(SeamThresholds, WithoutANumberAreReadFromTheWordAsFromTheSentence) {
  const std::set<NoThreshold> below = {NoThreshold::below_level, NoThreshold::open_easiest,
                                       NoThreshold::curve_below};
  for (std::size_t i = 0; i < number_of_reasons; ++i) {
    const auto why = static_cast<NoThreshold>(i);
    nlohmann::ordered_json threshold =
        analysis::json_estimate({.level_x = {}, .reason = why, .ci95 = {.high_x = 7}}, analysis::LevelAxis{});
    const auto need = [&] {
      return receiver_need(of_report(
          "joint",
          R"("curve":[{"width_px":64}],"joint":{"perceptual_threshold_corrected_px":{"estimate":500},)"
          R"("perceptual_threshold_px":)" +
              threshold.dump() + "}"));
    };
    const WidthNeed by_word = need();
    if (below.contains(why))
      EXPECT_EQ(by_word.width_px, 128) << word(why);
    else if (why == NoThreshold::guess_floor)
      EXPECT_EQ(by_word.width_px, 500);
    else
      EXPECT_FALSE(by_word.width_px) << word(why);
    ASSERT_EQ(threshold.erase("reason_word"), 1U);
    const WidthNeed by_sentence = need();
    EXPECT_EQ(by_sentence.width_px, by_word.width_px) << word(why);
    EXPECT_EQ(by_sentence.rule, by_word.rule) << word(why);
  }
}

TEST(SeamThresholds, InTheGuessFloorGiveWayToTheCorrectedOnes) {
  const WidthNeed need =
      receiver_need(of_report("joint", R"("joint":{"perceptual_threshold_px":{"estimate":null,)"
                                       R"("reason":"not identified: the level lies in the guess floor"},)"
                                       R"("perceptual_threshold_corrected_px":{"estimate":500}})"));
  EXPECT_EQ(need.width_px, 500);
  EXPECT_EQ(need.rule, "PT corrected for guesses: not noticed");
}

TEST(SeamThresholds, OfWhatAStudyDidNotShowAreNotKnown) {
  const StudyThresholds study = of_report("joint", R"("joint":{"perceptual_threshold_px":{"estimate":300}})");
  const SeamlessWidth width = seamless_width({.receiver = true, .occlusion = true}, study.artifacts);
  ASSERT_EQ(width.needs.size(), 2U);
  EXPECT_THAT(width.needs[1].rule, HasSubstr("the study did not show it"));
  EXPECT_FALSE(width.width_px.has_value());
}

}  // namespace
}  // namespace seamline::renderer
