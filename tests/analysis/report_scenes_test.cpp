#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/tables/dictionary.h"
#include "analysis/report/text/scenes_text.h"
#include "tests/analysis/report_people.h"

namespace seamline::analysis {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;
using study::Answer;
using study::LogContents;

/// Receiver and overlap; the receiver in that many scenes.
LogContents scenes_log(int scenes) {
  LogContents log = test::people_log(8, 1);
  std::erase_if(log.answers, [](const Answer& answer) { return answer.artifact != Artifact::overlap; });
  for (int scene = 1; scene <= scenes; ++scene)
    for (Answer answer : test::people_log(8, static_cast<std::uint64_t>(scene)).answers)
      if (answer.artifact == Artifact::receiver) {
        answer.scene = "room_" + std::to_string(scene);
        answer.stimulus_id += answer.scene;
        log.answers.push_back(answer);
      }
  return log;
}

struct ScenesReport {
  Analysis analysis;
  ReportNumbers numbers;
};

ScenesReport report_with_scenes(int scenes) {
  ScenesReport report;
  report.analysis = analyze(scenes_log(scenes), false, {.replicates = 100, .seed = 3});
  report.numbers = report_numbers(report.analysis);
  return report;
}

std::set<std::string> table_names(const ScenesReport& report) {
  std::set<std::string> names;
  for (const CsvTable& table : all_tables(report.analysis, report.numbers)) names.insert(table.name);
  return names;
}

}  // namespace

TEST(ReportScenes, OfThreeScenesSaysBothSpreadsEverywhere) {
  const ScenesReport report = report_with_scenes(fewest_scenes);
  ASSERT_EQ(report.numbers.over_scenes.size(), 1U);  // the overlap has one scene
  const CurveOverScenes& curve = report.numbers.over_scenes[0];
  EXPECT_EQ(curve.scenes, (std::vector<std::string>{"room_1", "room_2", "room_3"}));
  EXPECT_EQ(curve.people, 8);
  ASSERT_EQ(curve.thresholds.size(), every_joint_quantity.size());
  const ThresholdOverScenes& detection = curve.thresholds.back();
  EXPECT_EQ(detection.reason, "");
  EXPECT_LE(detection.like_these.low_x, detection.these.low_x);
  EXPECT_GE(detection.like_these.high_x, detection.these.high_x);

  EXPECT_THAT(scenes_html(report.numbers), HasSubstr("scenes like these (95 %)"));
  EXPECT_THAT(scenes_text(report.numbers), HasSubstr("What may be claimed"));
  EXPECT_THAT(fixed_effects_text(report.analysis), HasSubstr("Thresholds over scenes"));
  const MethodsText methods = methods_text(report.analysis, report.numbers);
  EXPECT_THAT(plain_text(methods), HasSubstr("in 3 scenes or more"));
  EXPECT_THAT(methods.references, Contains(HasSubstr("Cameron, A. C.")));

  const std::set<std::string> names = table_names(report);
  EXPECT_TRUE(names.contains("thresholds_over_scenes"));
  EXPECT_TRUE(names.contains("thresholds_scenes"));
  const Json json = Json::parse(thresholds_json(report.analysis, report.numbers.over_scenes));
  EXPECT_EQ(json.at("scenes").at(0).at("thresholds").size(), every_joint_quantity.size());
  std::set<std::string> explained;
  const std::vector<CsvTable> tables = all_tables(report.analysis, report.numbers);
  for (const auto& row : report_dictionary(tables, report.numbers.axis, report.numbers.conditions).rows)
    explained.insert(std::get<std::string>(row[1]));
  for (const auto& [key, value] : json.at("scenes").at(0).at("thresholds").at(0).items())
    EXPECT_TRUE(explained.contains("scenes[].thresholds[]." + key + (value.is_array() ? "[]" : ""))) << key;
}

// What a study with fewer scenes had, it has: no section, table, field or sentence more.
TEST(ReportScenes, OfOneOrTwoScenesIsAsItWas) {
  for (const int scenes : {1, 2}) {
    const ScenesReport report = report_with_scenes(scenes);
    EXPECT_TRUE(report.numbers.over_scenes.empty());
    EXPECT_EQ(scenes_html(report.numbers) + scenes_text(report.numbers), "");
    EXPECT_THAT(fixed_effects_text(report.analysis), HasSubstr("Objects and scenes are fixed: intervals"));
    EXPECT_FALSE(table_names(report).contains("thresholds_over_scenes"));
    EXPECT_EQ(thresholds_json(report.analysis, report.numbers.over_scenes), thresholds_json(report.analysis));
    EXPECT_THAT(plain_text(methods_text(report.analysis, report.numbers)), Not(HasSubstr("Cameron")));
  }
}

// A scene without a threshold is named, and no mean of the others is given out for that of all.
TEST(ReportScenes, ASceneWithoutAThresholdIsNamed) {
  LogContents log = scenes_log(4);
  for (Answer& answer : log.answers)
    if (answer.scene == "room_2") {
      answer.chosen_index = answer.object_index;  // always right: everything is seen
      answer.rating = 4;
    }
  const Analysis analysis = analyze(std::move(log), false, {.replicates = 100, .seed = 3});
  const ReportNumbers numbers = report_numbers(analysis);
  ASSERT_EQ(numbers.over_scenes.size(), 1U);
  const ThresholdOverScenes& detection = numbers.over_scenes[0].thresholds.back();
  EXPECT_THAT(detection.reason, HasSubstr("1 of 4 scenes (room_2)"));
  EXPECT_FALSE(std::isfinite(detection.spreads.mean_x));
  EXPECT_THAT(scenes_text(numbers), HasSubstr("room_2"));
}

}  // namespace seamline::analysis
