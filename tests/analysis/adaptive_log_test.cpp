// What the analysis says of a log whose widths were placed by the answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/headline_rows.h"
#include "analysis/report/tables/all_tables.h"
#include "study/log/log.h"
#include "study/running/simulation.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
using namespace study;
namespace {

using testing::Contains;
using testing::HasSubstr;

Analysis analysis_of(const std::string& procedure, const std::string& table) {
  const TemporaryFolder folder;
  std::string text = study_text("adaptive", "64, 128, 256, 512, 1024");
  text.insert(text.find("seed ="), procedure);
  text.insert(text.find("[session]"), table);
  (void)write_set_of_text(folder / "set", text);
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 12});
  return analyze(read_log(folder / "log"), false, {.replicates = 100, .threads = 1});
}

TEST(AdaptiveLog, GivesNoCurveOfMeansAndSaysSo) {
  const Analysis analysis = analysis_of("procedure = \"quest_plus\"\n",
                                        "[quest_plus]\nmax_shows_per_image = 20\nmax_trials = 90\n");
  ASSERT_EQ(analysis.thresholds.size(), 4U);
  for (const ArtifactThresholds& thresholds : analysis.thresholds)
    for (const ThresholdEstimate& width :
         {thresholds.estimates.perceptual, thresholds.estimates.slightly_noticeable,
          thresholds.estimates.inflection}) {
      EXPECT_FALSE(width.level_x);
      EXPECT_EQ(width.reason, NoThreshold::placed_by_answers);
    }
  EXPECT_THAT(analysis.notes, Contains(HasSubstr("QUEST+")));
  EXPECT_THAT(analysis.notes, testing::Not(Contains(HasSubstr("no answer at one of the widths"))));
  EXPECT_EQ(analysis.data.objects.size(), 12U) << "the answers are described all the same";
}

TEST(AdaptiveLog, ThresholdsOfTheGroupAreOfEachPersonsOwn) {
  const Analysis analysis =
      analysis_of("procedure = \"quest_plus\"\n",
                  "[quest_plus]\nmax_shows_per_image = 20\nmax_trials = 30\noutcome = \"joint\"\n"
                  "threshold_px = { least = 32, most = 2048, count = 21 }\n");
  ASSERT_TRUE(analysis.joint && analysis.joint->fit.estimated());
  EXPECT_TRUE(analysis.joint->fit.model.between_people);
  int corrected = 0;
  for (const HeadlineRow& row : headline_rows(analysis)) {
    const std::string rule(row.rule->name);
    if (rule == "IP") {
      EXPECT_EQ(row.here.reason, NoThreshold::no_inflection);
    }
    EXPECT_FALSE(row.paper_way && row.paper_way->level_x) << rule;
    if (rule != "SN" || !row.here.level_x || !row.planted) continue;
    ++corrected;
    EXPECT_NEAR(*row.here.level_x, *row.planted->level_x, 1);
  }
  EXPECT_GE(corrected, 2);
  EXPECT_TRUE(analysis.joint->contrasts.tables.empty());
}

TEST(AdaptiveLog, TracksAreInTheUnitsOfTheirAxis) {
  const auto columns_of = [](const std::string& more) {
    const Analysis analysis = analysis_of("procedure = \"quest_plus\"\n",
                                          "[quest_plus]\nmax_shows_per_image = 20\nmax_trials = 20\n" + more);
    ReportNumbers numbers;
    numbers.tracks = quest_plus_estimates(analysis.log);
    std::string columns;
    for (const CsvColumn& column : tracks_table(numbers).columns) columns += column.name + " ";
    return columns;
  };
  EXPECT_THAT(columns_of(""), HasSubstr("threshold_sd_octaves scale_octaves "));
  EXPECT_THAT(columns_of("axis = \"linear\"\n"), HasSubstr("threshold_sd_px scale_px "));
}

TEST(AdaptiveLog, TracksNameTheirConditionAndTheUnitOfTheirQuantity) {
  ReportNumbers numbers;
  numbers.axis = {.quantity = Quantity::sun_radius_deg, .noticeability = Direction::decreasing, .unit = 1};
  numbers.conditions = true;
  for (const char* condition : {"dry", "wet"}) {
    TrackEstimate track;
    track.artifact = Artifact::shadow;
    track.condition = condition;
    track.axis = Axis::linear;
    track.quantity = numbers.axis.quantity;
    numbers.tracks.push_back(track);
  }
  const CsvTable table = tracks_table(numbers);
  std::string columns;
  for (const CsvColumn& column : table.columns) columns += column.name + " ";
  EXPECT_EQ(columns,
            "participant artifact condition track used trials threshold_deg threshold_low_deg "
            "threshold_high_deg threshold_sd_deg scale_deg lapse alarms ");
  ASSERT_EQ(table.rows.size(), 2U);
  for (const std::vector<CsvValue>& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.rows[1][2], CsvValue(std::string("wet")));
  numbers.axis.quantity = numbers.tracks[0].quantity = Quantity::mesh_tolerance;  // a ratio: no unit
  const CsvTable ratios = tracks_table(numbers);
  EXPECT_EQ(ratios.columns[6].name, "threshold");
  EXPECT_EQ(ratios.columns[9].name, "threshold_sd_levels");
}

TEST(AdaptiveLog, NoFallingThresholdsArePlantedInPeopleWhoseNoticeabilityRises) {
  const Analysis falling = analysis_of("procedure = \"constant\"\n", "");
  EXPECT_FALSE(falling.planted.empty());
  const Analysis rising =
      analysis_of("procedure = \"constant\"\n", "[observer]\nnoticeability = \"rises\"\n");
  EXPECT_TRUE(rising.planted.empty());
  EXPECT_THAT(rising.notes, Contains(HasSubstr("notice more as maps grow finer")));
}

TEST(AnalysisOfAStudyFile, SaysWhatCurvesShareAndWhoLeads) {
  const Analysis own = analysis_of(
      "", "[analysis]\nshare = [\"criteria\", \"lapse\", \"guess_ratings\"]\ncompare = [\"vision\"]\n");
  ASSERT_TRUE(own.joint);
  EXPECT_FALSE(own.joint->fit.model.sharing.scale);
  EXPECT_TRUE(own.joint->fit.model.sharing.criteria);
  EXPECT_EQ(own.options.compare, std::vector<std::string>{"vision"});
  EXPECT_THAT(own.notes, Contains("Each curve of the joint model has its own scale."));
  AnalysisOptions options;
  options.own = {"criteria"};
  const Analysis also = analyze(own.log, false, {.replicates = 100, .threads = 1}, options);
  EXPECT_FALSE(also.joint->fit.model.sharing.scale || also.joint->fit.model.sharing.criteria);
  EXPECT_THAT(also.notes, Contains("Each curve of the joint model has its own scale, rating criteria."));
  const Analysis paper = analysis_of("", "[analysis]\nmodel = \"paper\"\n");
  EXPECT_FALSE(paper.joint);
  EXPECT_FALSE(paper.thresholds.empty());
  const Analysis usual = analysis_of("", "");
  EXPECT_EQ(own.log.study_hash, usual.log.study_hash) << "[analysis] shows people nothing";
  EXPECT_EQ(usual.joint->fit.model.sharing, JointSharing{});
}

TEST(AdaptiveLog, ConstantStimuliAreAnalysedAsBefore) {
  const Analysis analysis = analysis_of("procedure = \"constant\"\n", "");
  for (const ArtifactThresholds& thresholds : analysis.thresholds) EXPECT_EQ(thresholds.participants, 12);
  EXPECT_THAT(analysis.notes, testing::Not(Contains(HasSubstr("QUEST+"))));
}

}  // namespace
}  // namespace seamline::analysis
