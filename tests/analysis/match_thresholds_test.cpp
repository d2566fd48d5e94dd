// Matched levels of people: means, intervals and the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/analyze_log.h"
#include "analysis/report/matching/match_report.h"
#include "study/running/simulation.h"
#include "support/files/atomic_file.h"
#include "tests/complaint.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
namespace {

using testing::HasSubstr;

std::filesystem::path matched_log(const TemporaryFolder& folder, int people, std::uint64_t seed,
                                  const std::string& more = "repetitions = 4\n") {
  (void)study::write_set_of_text(
      folder / "set", study::study_text("matched", "16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192") +
                          "[task]\nkind = \"match\"\n" + more);
  study::run_simulated_study({.set_folder = folder / "set",
                              .log = folder / "log",
                              .observer = study::ObserverKind::threshold,
                              .count = people,
                              .seed = seed});
  return folder / "log";
}

MatchAnalysis matches_of_log(const std::filesystem::path& path) {
  study::LogContents log = study::read_log(path);
  std::vector<ParticipantUse> people = select_participants(log, false);
  return analyze_matches(std::move(log), std::move(people));
}

TEST(MatchThresholds, AMeanOverPeopleHasStudentsInterval) {
  // scipy.stats.t.interval(0.95, 4, loc=mean, scale=sem) of these, SciPy 1.10.1.
  const MatchMean found = mean_over_people({7.0, 8.5, 9.25, 6.75, 8.0});
  EXPECT_NEAR(found.mean, 7.9, 1e-12);
  EXPECT_NEAR(found.low.value(), 6.60887839261914, 1e-6);
  EXPECT_NEAR(found.high.value(), 9.191121607380861, 1e-6);
  EXPECT_FALSE(mean_over_people({7.0}).low);
}

TEST(MatchThresholds, PlantedThresholdsAreFoundAndPeopleDifferAsPlanted) {
  const TemporaryFolder folder;
  const MatchAnalysis analysis = matches_of_log(matched_log(folder, 60, 2));
  const ObserverDefinition observer;
  ASSERT_EQ(analysis.curves.size(), 4U);
  for (const CurveMatches& curve : analysis.curves) {
    EXPECT_EQ(curve.people, 60);
    EXPECT_EQ(curve.matches, 60 * 3 * 4);
    EXPECT_EQ(curve.planted, observer.midpoint.at(curve.artifact));
    const double sem = curve.between_sd.value() / std::sqrt(60);
    EXPECT_NEAR(curve.threshold.mean, std::log2(*curve.planted), 3.5 * sem) << word(curve.artifact);
    EXPECT_NEAR(*curve.between_sd, observer.people_sd_octaves, 0.25) << word(curve.artifact);
    ASSERT_TRUE(curve.start_effect && curve.start_effect->low);
    EXPECT_NEAR(curve.start_effect->mean, 0, 0.2) << "simulated people do not care where they began";
  }
}

TEST(MatchThresholds, EveryParticipantHasTheirOwnMeanAndDeviation) {
  const TemporaryFolder folder;
  const MatchAnalysis analysis = matches_of_log(matched_log(folder, 2, 3));
  ASSERT_EQ(analysis.of_people.size(), 8U);
  for (const PersonMatches& person : analysis.of_people) {
    double sum = 0, squares = 0;
    int n = 0;
    for (const study::MatchRecord& match : analysis.matches)
      if (match.participant == person.participant && match.artifact == person.artifact) {
        sum += std::log2(match.level);
        squares += std::log2(match.level) * std::log2(match.level);
        ++n;
      }
    EXPECT_EQ(person.matches, n);
    EXPECT_NEAR(person.mean, sum / n, 1e-12);
    EXPECT_NEAR(person.sd.value(), std::sqrt((squares - sum * sum / n) / (n - 1)), 1e-9);
  }
}

TEST(MatchThresholds, TheReportSaysWhatTheTablesSay) {
  const TemporaryFolder folder;
  const AnalysisSummary summary =
      analyze_log({.log = matched_log(folder, 5, 4), .report_folder = folder / "report"});
  const auto json = nlohmann::json::parse(read_file(folder / "report" / "thresholds.json"));
  ASSERT_EQ(json["thresholds"].size(), 4U);
  const MatchAnalysis analysis = matches_of_log(folder / "log");
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& curve = json["thresholds"][i];
    EXPECT_NEAR(curve["just_seen"]["estimate"].get<double>(), std::exp2(analysis.curves[i].threshold.mean),
                1e-2);
    EXPECT_EQ(curve["participants"], 5);
  }
  for (const char* file : {"report.html", "methods.txt", "thresholds.csv", "thresholds_people.csv",
                           "matches.csv", "data_dictionary.csv", "figures/matches.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / "report" / file)) << file;
  EXPECT_THAT(summary.table, HasSubstr("receiver"));
  EXPECT_THAT(read_file(folder / "report" / "methods.txt"), HasSubstr("by adjustment"));
  EXPECT_THAT(test::complaint_of([&] {
                (void)analyze_log(
                    {.log = folder / "log", .report_folder = folder / "other", .exclude_screened = true});
              }),
              HasSubstr("exclude_screened"));
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

TEST(MatchThresholds, OneParticipantHasNoIntervalAndIsToldSo) {
  const TemporaryFolder folder;
  const MatchAnalysis analysis = matches_of_log(matched_log(folder, 1, 3));
  for (const CurveMatches& curve : analysis.curves) EXPECT_FALSE(curve.threshold.low || curve.between_sd);
  EXPECT_THAT(analysis.notes, testing::Contains(HasSubstr("One participant")));
}

}  // namespace
}  // namespace seamline::analysis
