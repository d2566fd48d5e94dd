// `procedure` and `[quest_plus]` of a study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "stimuli/study_file.h"
#include "stimuli/support/error.h"
#include "tests/complaint.h"
#include "tests/stimuli/study_of_no_files.h"

namespace seamline {
namespace {

using testing::HasSubstr;

StudyDefinition read_procedure(const std::string& top, const std::string& tables) {
  return read_study_text(test::study_of_no_files(top, tables), "study.toml");
}

constexpr const char* adaptive = "procedure = \"quest_plus\"";

QuestPlusDefinition quest_plus(const std::string& settings) {
  return std::get<QuestPlusDefinition>(
      read_procedure(adaptive, "[quest_plus]\nmax_shows_per_image = 3\n" + settings).procedure);
}

std::string complaint_of_procedure(const std::string& top, const std::string& tables) {
  return test::complaint_of([&] { (void)read_procedure(top, tables); });
}

TEST(StudyFileProcedure, IsConstantUnlessItIsNamed) {
  EXPECT_TRUE(std::holds_alternative<ConstantDefinition>(read_procedure("", "").procedure));
  EXPECT_TRUE(
      std::holds_alternative<ConstantDefinition>(read_procedure("procedure = \"constant\"", "").procedure));
  EXPECT_EQ(study_hash(read_procedure("", "")), study_hash(read_procedure("procedure = \"constant\"", "")));
}

TEST(StudyFileProcedure, DefaultsReachAnOctaveBeyondTheWidths) {
  const QuestPlusDefinition quest = quest_plus("");
  EXPECT_EQ(quest.max_shows_per_image, 3);
  EXPECT_EQ(quest.threshold_px.least, 32);
  EXPECT_EQ(quest.threshold_px.most, 8192);
  EXPECT_EQ(quest.threshold_px.count, 41);
  EXPECT_EQ(quest.guess.least, 1.0 / 3);
  EXPECT_EQ(quest.max_trials, 40);
  EXPECT_FALSE(quest.stop_interval_octaves || quest.stop_entropy_nats);
}

TEST(StudyFileProcedure, ReadsEverySetting) {
  const QuestPlusDefinition quest = quest_plus(R"(outcome = "noticeability"
track = "object"
sigmoid = "gumbel"
threshold_px = { least = 10, most = 20000, count = 21 }
scale_octaves = { least = 0.5, most = 0.5, count = 1 }
lapse = { least = 0.01, most = 0.05, count = 2 }
guess = { least = 0.2, most = 0.4, count = 3 }
rating_step_octaves = { least = 0.2, most = 0.8, count = 5 }
min_trials = 5
max_trials = 60
stop_interval_octaves = 0.75
stop_entropy_nats = 4.5
edge_share = 0.2
)");
  EXPECT_EQ(quest.outcome, PlacementOutcome::noticeability);
  EXPECT_EQ(quest.track, PlacementTrack::object);
  EXPECT_EQ(quest.sigmoid, Sigmoid::gumbel);
  EXPECT_EQ(quest.threshold_px.most, 20000);
  EXPECT_EQ(quest.scale_octaves.count, 1);
  EXPECT_EQ(quest.lapse.least, 0.01);
  EXPECT_EQ(quest.guess.count, 3);
  EXPECT_EQ(quest.rating_step_octaves.count, 5);
  EXPECT_EQ(quest.min_trials, 5);
  EXPECT_EQ(quest.max_trials, 60);
  EXPECT_EQ(quest.stop_interval_octaves, 0.75);
  EXPECT_EQ(quest.stop_entropy_nats, 4.5);
  EXPECT_EQ(quest.edge_share, 0.2);
}

TEST(StudyFileProcedure, EverySettingIsInTheHash) {
  const auto hash = [](const std::string& settings) {
    return study_hash(read_procedure(adaptive, "[quest_plus]\n" + settings));
  };
  const std::string shows = "max_shows_per_image = 3\n";
  std::set<std::string> hashes = {hash(shows), hash("max_shows_per_image = 4\n"),
                                  study_hash(read_procedure("", ""))};
  const std::vector<std::string> others = {"outcome = \"noticeability\"",
                                           "outcome = \"noticeability\"\nrating_step_octaves = { count = 3 }",
                                           "track = \"object\"",
                                           "sigmoid = \"norm\"",
                                           "threshold_px = { least = 33 }",
                                           "scale_octaves = { count = 8 }",
                                           "lapse = { most = 0.07 }",
                                           "guess = { least = 0.3, most = 0.3 }",
                                           "min_trials = 9",
                                           "max_trials = 41",
                                           "stop_interval_octaves = 1",
                                           "stop_entropy_nats = 1",
                                           "edge_share = 0.3"};
  for (const std::string& setting : others) hashes.insert(hash(shows + setting + "\n"));
  EXPECT_EQ(hashes.size(), 3 + others.size());
}

TEST(StudyFileProcedure, RefusesWhatIsWrongInOneSentence) {
  EXPECT_THAT(complaint_of_procedure("procedure = \"staircase\"", ""),
              testing::AllOf(HasSubstr("study.toml: procedure"), HasSubstr("\"constant\" or \"quest_plus\""),
                             HasSubstr("\"staircase\"")));
  EXPECT_THAT(complaint_of_procedure(adaptive, ""), HasSubstr("[quest_plus]"));
  EXPECT_THAT(complaint_of_procedure(adaptive, "[quest_plus]\n"),
              HasSubstr("quest_plus.max_shows_per_image"));
  EXPECT_THAT(complaint_of_procedure("", "[quest_plus]\nmax_shows_per_image = 3\n"), HasSubstr("procedure"));
  const std::vector<std::pair<const char*, const char*>> wrong = {
      {"outcome = \"seen\"", "quest_plus.outcome"},
      {"track = \"scene\"", "quest_plus.track"},
      {"sigmoid = \"logit\"", "quest_plus.sigmoid"},
      {"sigmoid = 3", "quest_plus.sigmoid"},
      {"threshold_px = { least = 0 }", "quest_plus.threshold_px.least"},
      {"threshold_px = { least = 5000, most = 100 }", "quest_plus.threshold_px.most"},
      {"threshold_px = { count = 0 }", "quest_plus.threshold_px.count"},
      {"threshold_px = { counts = 4 }", "did you mean \"count\""},
      {"threshold_px = 300", "quest_plus.threshold_px"},
      {"scale_octaves = { count = 1 }", "quest_plus.scale_octaves.most"},
      {"scale_octaves = { least = nan }", "quest_plus.scale_octaves.least"},
      {"lapse = { most = 0.7 }", "quest_plus.lapse.most"},
      {"lapse = { most = 0.5 }\nguess = { least = 0.5, most = 0.5 }", "less than 1"},
      {"guess = { most = 0.9 }", "quest_plus.guess.most"},
      {"threshold_px = { count = 1001 }\nscale_octaves = { count = 1001 }", "1000000"},
      {"max_trials = 0", "quest_plus.max_trials"},
      {"min_trials = 50", "quest_plus.min_trials"},
      {"stop_interval_octaves = 0", "quest_plus.stop_interval_octaves"},
      {"stop_entropy_nats = -1", "quest_plus.stop_entropy_nats"},
      {"edge_share = 2", "quest_plus.edge_share"},
      {"rating_step_octaves = { count = 2 }", "outcome"},
      {"max_show_per_image = 2", "did you mean \"max_shows_per_image\""}};
  for (const auto& [setting, expected] : wrong) {
    const std::string said = complaint_of_procedure(
        adaptive, std::string("[quest_plus]\nmax_shows_per_image = 3\n") + setting + "\n");
    EXPECT_THAT(said, HasSubstr(expected)) << setting;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0);
  }
}

}  // namespace
}  // namespace seamline
