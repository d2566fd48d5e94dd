// What was frozen, and what deviates from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/log_analysis/analysis.h"
#include "analysis/preregistration/deviations.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/tables/preregistration_table.h"
#include "analysis/thresholds/threshold_rules.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/files/temporary_folder.h"
#include "tests/analysis/threshold_people.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

using test::complaint_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What fits the logs of `simulate_log` with 300 replicates.
Preregistration frozen_for(int participants) {
  return {.program_version = program_version(),
          .study_name = "tiny \"quoted\" \xE6\xB7\xB1",
          .study_hash = "study",
          .study_text = "a = 1\n\n# two\tlines\n",
          .sets = {{.set_hash = "another", .stimuli = 3}, {.set_hash = "set", .stimuli = 60}},
          .analysis = {.thresholds = {"PT", "SN"},
                       .bootstrap_replicates = 300,
                       .seed = 9,
                       .rules = rules_of_analysis(),
                       .by_hand = {}},
          .participants = participants,
          .why_so_many = "as many as come",
          .plan = {"a table", "of two lines"}};
}

Analysis analysed_as(study::LogContents log, bool exclude_screened = false) {
  AnalysisOptions options;
  options.exclude_screened = exclude_screened;
  return analyze(std::move(log), false, {.replicates = 300, .seed = 9}, options);
}

std::vector<Deviation> deviations(Analysis analysis, const Preregistration& frozen) {
  compare_with_archive(analysis, {.file = "frozen.json", .content = frozen, .sha256 = "hash"});
  return analysis.frozen->deviations;
}

TEST(Preregistration, IsReadBackAndNoByteOfItMayChange) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "frozen.json";
  const std::string text = archive_text(frozen_for(8));
  write_file_atomically(file, text);
  const Archive archive = read_archive(file);
  EXPECT_EQ(archive.content, frozen_for(8));
  // What `head -n -2` leaves is what the hash is of.
  const std::size_t hash_at = text.rfind("  \"sha256\"");
  EXPECT_EQ(archive.sha256, sha256(text.substr(0, hash_at)));
  for (std::size_t at = 0; at < text.size(); at += 7) {
    std::string changed = text;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    write_file_atomically(file, changed);
    EXPECT_THAT(complaint_of([&] { (void)read_archive(file); }), HasSubstr("frozen.json: wanted")) << at;
  }
  for (const std::string& other :
       {std::string("{}\n"), std::string(), text.substr(0, text.size() / 2), text + " "}) {
    write_file_atomically(file, other);
    EXPECT_THAT(complaint_of([&] { (void)read_archive(file); }), HasSubstr("frozen.json: wanted"));
  }
}

TEST(Preregistration, ASoundHashOverNonsenseIsRefusedBySentence) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "frozen.json";
  const auto hashed = [&](const std::string& text) {
    write_file_atomically(file, text + "  \"sha256\": \"" + sha256(text) + "\"\n}\n");
    return complaint_of([&] { (void)read_archive(file); });
  };
  EXPECT_THAT(hashed("{\n  \"format\": 3,\n"), HasSubstr("\"format\""));
  EXPECT_THAT(hashed("{\n  \"format\": \"x\",\n"), HasSubstr("format \"x\""));
  EXPECT_THAT(hashed("{\n  \"format\": \"seamline preregistration 1\",\n"), HasSubstr("program_version"));
  EXPECT_THAT(hashed("nonsense\n"), HasSubstr("no JSON"));
}

TEST(Preregistration, WhatWasFrozenHasNoDeviation) {
  Analysis analysis = analysed_as(test::simulate_log(8, 1));
  compare_with_archive(analysis, {.file = "x/frozen.json", .content = frozen_for(8), .sha256 = "hash"});
  EXPECT_THAT(analysis.frozen->deviations, IsEmpty());
  EXPECT_THAT(analysis.notes.front(), HasSubstr("data and analysis are those that were frozen"));
  EXPECT_THAT(preregistration_html(analysis), HasSubstr("hash (frozen.json)"));
  EXPECT_THAT(deviations_table(*analysis.frozen).rows, IsEmpty());
}

TEST(Preregistration, OneChangedExclusionRuleIsReportedAsSuch) {
  const Deviation changed{"exclusion rule: whom a screen names", "named and used", "left out"};
  // Nobody of these people is named, so the rule alone differs.
  EXPECT_THAT(deviations(analysed_as(test::simulate_log(8, 1), true), frozen_for(8)), ElementsAre(changed));
  Analysis analysis = analysed_as(test::simulate_log(8, 1), true);
  compare_with_archive(analysis, {.file = "frozen.json", .content = frozen_for(8), .sha256 = "hash"});
  EXPECT_THAT(analysis.notes.front(), HasSubstr("1 deviation from what was frozen"));
  EXPECT_THAT(preregistration_html(analysis), HasSubstr(changed.what));
  EXPECT_THAT(frozen_text(analysis), HasSubstr("whom a screen names: frozen named and used, found left out"));
}

TEST(Preregistration, WhoIsExcludedByHandIsNamed) {
  study::LogContents log = test::simulate_log(8, 1);
  log.participants[1].excluded = true;
  Preregistration frozen = frozen_for(7);
  EXPECT_THAT(deviations(analysed_as(log), frozen),
              ElementsAre(Deviation{"exclusion rule: by hand", "nobody", log.participants[1].code}));
  frozen.analysis.by_hand = "Who says that they saw the pictures before.";
  Analysis analysis = analysed_as(log);
  compare_with_archive(analysis, {.file = "frozen.json", .content = frozen, .sha256 = "hash"});
  EXPECT_THAT(analysis.frozen->deviations, IsEmpty());
  EXPECT_THAT(analysis.frozen->remarks, ElementsAre(HasSubstr(log.participants[1].code)));
}

/// What is frozen of a threshold is what is computed: level, estimator and interval of the same table.
TEST(Preregistration, TheFrozenRuleOfAThresholdIsTheOneThatIsComputed) {
  const Analysis analysis = analysed_as(test::simulate_log(14, 1));
  const std::vector<std::string> rules = rules_of_analysis();
  const ArtifactScores& scores = analysis.data.artifacts.front();
  const CurveThresholds& found = analysis.thresholds.front().estimates;
  const MeanVector means = mean_and_covariance(scores.noticeability);
  for (const ThresholdRule& rule : paper_rules) {
    const auto said = std::find_if(rules.begin(), rules.end(), [&](const std::string& sentence) {
      return sentence.starts_with(std::string("paper's way, ") + rule.name + ": ");
    });
    ASSERT_NE(said, rules.end()) << rule.name;
    if (!rule.level) {
      EXPECT_THAT(*said, HasSubstr("centre of the four-parameter logistic"));
      EXPECT_THAT(*said, HasSubstr("expanded percentile bootstrap"));
      continue;
    }
    EXPECT_THAT(*said, HasSubstr("isotonic regression of mean noticeability equals"));
    EXPECT_THAT(*said, HasSubstr("95 % by an inverted score test"));
    const LevelInterval tested =
        level_interval(*rule.level, levels_on_axis(scores), means, static_cast<int>(scores.people.size()));
    EXPECT_EQ((found.*rule.estimate).ci95.low_x, tested.low_x) << rule.name;
    EXPECT_EQ((found.*rule.estimate).ci95.high_x, tested.high_x) << rule.name;
  }
  EXPECT_THAT(rules, testing::Contains(testing::StartsWith("several thresholds: ")));
}

/// An archive of a version that stated another interval shows that it is not the one computed today.
TEST(Preregistration, AnotherIntervalThanThatComputedIsADeviation) {
  Preregistration frozen = frozen_for(8);
  const auto pt = std::find_if(frozen.analysis.rules.begin(), frozen.analysis.rules.end(),
                               [](const std::string& rule) { return rule.starts_with("PT: "); });
  ASSERT_NE(pt, frozen.analysis.rules.end());
  *pt = "thresholds: PT where mean noticeability is 0.5; intervals of 95 % by resampling participants";
  std::vector<std::string> what;
  for (const Deviation& deviation : deviations(analysed_as(test::simulate_log(8, 1)), frozen))
    what.push_back(deviation.found);
  EXPECT_THAT(what, ElementsAre("not so today", HasSubstr("jackknife")));
}

TEST(Preregistration, EveryOtherDifferenceIsListed) {
  Preregistration frozen = frozen_for(9);
  frozen.program_version = "0.0.1";
  frozen.study_hash = "older";
  frozen.sets.pop_back();
  frozen.analysis.seed = 8;
  frozen.analysis.bootstrap_replicates = 1000;
  frozen.analysis.field_of_view_deg = 60;
  frozen.analysis.include_pilot = true;
  frozen.analysis.rules[2] = "screen attention: right in fewer than 60 % of the catch trials";
  std::vector<std::string> what;
  for (const Deviation& deviation : deviations(analysed_as(test::simulate_log(8, 1)), frozen))
    what.push_back(deviation.what);
  EXPECT_THAT(what, ElementsAre("study", "stimulus set", "program", "participants used",
                                "exclusion rule: pilot data", "rule of the program", "rule of the program",
                                "bootstrap replicates", "bootstrap seed", "field of view"));
}

}  // namespace
}  // namespace seamline::analysis
