#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/log_analysis/analysis.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/report_html.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/text/threshold_text.h"
#include "support/text/csv.h"
#include "support/text/html.h"
#include "support/text/numbers.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using ::testing::HasSubstr;
using ::testing::Not;

Analysis analysed_without_the_second(LogContents log) {
  log.participants[1].excluded = true;
  return analyze(std::move(log), false, {.replicates = 300, .seed = 9});
}

TEST(ThresholdsJson, HasTheFieldsOfTheContract) {
  const auto json =
      nlohmann::json::parse(thresholds_json(analysed_without_the_second(test::simulate_log(8, 1))));
  EXPECT_EQ(json["format"], thresholds_format);
  EXPECT_EQ(json["version"], thresholds_version);
  EXPECT_EQ(json["study"]["hash"], "study");
  EXPECT_EQ(json["set"]["hash"], "set");
  EXPECT_EQ(json["participants"]["used"], 7);
  EXPECT_EQ(json["participants"]["excluded"], 1);
  EXPECT_EQ(json["simulated"], true);
  EXPECT_EQ(json["bootstrap"]["replicates"], 300);
  EXPECT_EQ(json["bootstrap"]["seed"], 9);
  ASSERT_EQ(json["artifacts"].size(), 4U);
  for (const auto& artifact : json["artifacts"]) {
    for (const char* unit : {"_px", "_texels_per_degree"})
      for (const char* key : {"perceptual_threshold", "slightly_noticeable", "inflection"}) {
        const auto& value = artifact.at(std::string(key) + unit);
        EXPECT_EQ(value.at("ci95").size(), 2U);
        EXPECT_NE(value.at("estimate").is_null(), value.at("reason").is_null());
        EXPECT_EQ(value.contains("reason_word"), value.at("estimate").is_null());
      }
    EXPECT_EQ(artifact["cells"].size(), 21U);
    for (const char* key : {"artifact", "object", "width_px", "n", "mean", "sem", "correct"})
      EXPECT_TRUE(artifact["cells"][0].contains(key)) << key;
    EXPECT_EQ(artifact["curve"].size(), 7U);
    const auto& px = artifact["slightly_noticeable_px"]["estimate"];
    const auto& texels = artifact["slightly_noticeable_texels_per_degree"]["estimate"];
    EXPECT_NEAR(px.get<double>() / 360, texels.get<double>(), 1e-4);
  }
}

TEST(PlantedValues, AreTrueCrossingsWithTheFunctionalsOfTheExpectedMeansBeside) {
  const Analysis analysis = analysed_without_the_second(test::simulate_log(8, 1));
  const PlantedValues planted = planted_values({}, analysis.data);
  const CurveThresholds expected = test::thresholds_of_expected_means({}, Artifact::overlap);
  const PlantedThresholds& overlap = planted.at({Artifact::overlap, ""});
  EXPECT_DOUBLE_EQ(*overlap.limit.perceptual.level_x, *expected.perceptual.level_x);
  EXPECT_NEAR(std::exp2(overlap.perceptual_x), 1979.5, 0.5);
  EXPECT_TRUE(analysis.planted.empty());  // the log has no study text
  EXPECT_THAT(analysis.notes, ::testing::Contains(HasSubstr("planted values are not known")));
}

TEST(IntervalText, SaysOpenEndsInWords) {
  EXPECT_EQ(interval_text({7, 9}, {.axis = {}, .smallest = 64, .largest = 4096}), "128 to 512");
  EXPECT_EQ(interval_text({7, above_every_level}, {.axis = {}, .smallest = 64, .largest = 4096}),
            "128 to above 4096");
  EXPECT_EQ(interval_text({13, above_every_level}, {.axis = {}, .smallest = 64, .largest = 4096}),
            "above 4096");
  EXPECT_EQ(interval_text({below_every_level, 5}, {.axis = {}, .smallest = 64, .largest = 4096}), "below 64");
  EXPECT_EQ(interval_text({below_every_level, 7}, {.axis = {}, .smallest = 64, .largest = 4096}),
            "below 64 to 128");
  EXPECT_EQ(
      interval_text({above_every_level, above_every_level}, {.axis = {}, .smallest = 64, .largest = 4096}),
      "above 4096");
  EXPECT_EQ(
      interval_text({below_every_level, above_every_level}, {.axis = {}, .smallest = 64, .largest = 4096}),
      "below 64 to above 4096");
}

TEST(Csv, TextThatASpreadsheetWouldRunIsDefused) {
  const CsvTable table{.name = "t",
                       .columns = {{"a", "", ""}, {"b", "", ""}},
                       .rows = {{std::string("=HYPERLINK(\"x\")"), -1.5},
                                {std::string("+1"), std::int64_t{-2}},
                                {std::string("-1"), std::monostate{}},
                                {std::string("@x,y"), nan},
                                {std::string("plain \"q\""), 1.0 / 3}}};
  EXPECT_EQ(csv_text(table),
            "a,b\n\"'=HYPERLINK(\"\"x\"\")\",-1.5\n'+1,-2\n'-1,\n\"'@x,y\",\n\"plain \"\"q\"\"\",0.333333\n");
}

TEST(Csv, EveryColumnOfEveryTableIsInTheDictionary) {
  const std::vector<CsvTable> tables =
      noticeability_tables(analysed_without_the_second(test::simulate_log(4, 1)));
  std::size_t columns = 0;
  for (const CsvTable& table : tables) {
    columns += table.columns.size();
    for (const CsvColumn& column : table.columns) EXPECT_FALSE(column.meaning.empty()) << column.name;
    for (const auto& row : table.rows) ASSERT_EQ(row.size(), table.columns.size()) << table.name;
  }
  EXPECT_EQ(data_dictionary(tables).rows.size(), columns);
}

TEST(Html, EscapesTextFromPeople) {
  EXPECT_EQ(html_escape("<b a='1'>\"&"), "&lt;b a=&#39;1&#39;&gt;&quot;&amp;");
}

TEST(Html, Base64OfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Report, IsOneEscapedPageWithFiguresThatSayWhoAnswered) {
  LogContents log = test::simulate_log(6, 2);
  const std::string evil = "<script>alert(1)</script>";
  log.study_name = evil;
  log.participants[0].code = evil;
  for (Answer& answer : log.answers) {
    if (answer.participant == "sim-0") answer.participant = evil;
    answer.object = "`touch x` $HOME \" {/Bold @^_" + answer.object;
  }
  const Analysis analysis = analysed_without_the_second(log);
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "report";
  std::filesystem::create_directories(folder);
  const ReportNumbers numbers = report_numbers(analysis);
  const std::vector<Figure> figures = draw_figures(analysis, numbers, folder);
  const std::string html = report_html(analysis, numbers, figures, sample_stimuli(analysis, folder));
  EXPECT_THAT(html, Not(HasSubstr(evil)));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;"));
  EXPECT_THAT(html, HasSubstr("set was not found"));
  EXPECT_THAT(html, Not(HasSubstr("src=\"http")));
  ASSERT_EQ(figures.size(), 7U);  // simulated observers have no response times
  for (const Figure& figure : figures)
    EXPECT_THAT(inline_svg(figure), HasSubstr("5 simulated observers (threshold)")) << figure.name;
  EXPECT_FALSE(std::filesystem::exists("x"));
  for (const Figure& figure : figures)
    EXPECT_EQ(std::filesystem::status(figure.svg).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST(Samples, AreCutAroundTheObjectAndInsideThePicture) {
  ByteImage ids{.width_px = 960, .height_px = 540, .channels = 1, .values = {}};
  ids.values.assign(960UL * 540UL, 0);
  for (int y = 300; y < 400; ++y)
    for (int x = 10; x < 70; ++x)
      ids.values[static_cast<std::size_t>(y) * 960 + static_cast<std::size_t>(x)] = 1;
  const Rectangle area = crop_around(ids, 1);
  EXPECT_EQ(area.width_px, 200);
  EXPECT_EQ(area.height_px, 200);
  EXPECT_EQ(area.x, 0);
  EXPECT_EQ(area.y, 250);
  EXPECT_EQ(crop_around(ids, 3).width_px, 960);
}

}  // namespace
}  // namespace seamline::analysis
