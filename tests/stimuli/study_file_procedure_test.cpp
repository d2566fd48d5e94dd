// `procedure` and `[quest_plus]` of a study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"
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

TEST(StudyFileProcedure, TheJointModelHasAGridOfItsOwn) {
  const QuestPlusDefinition quest = quest_plus("outcome = \"joint\"\n");
  EXPECT_EQ(quest.outcome, PlacementOutcome::joint);
  EXPECT_EQ(quest.sigmoid, Sigmoid::normal);
  EXPECT_EQ(quest.scale.count * quest.lapse.count * quest.rating_step.count, 7 * 3 * 4);
  const auto hash = [](const std::string& settings) {
    return study_hash(read_procedure(adaptive, "[quest_plus]\nmax_shows_per_image = 3\n" + settings));
  };
  EXPECT_NE(hash("outcome = \"joint\"\n"), hash("outcome = \"noticeability\"\n"));
  EXPECT_EQ(hash("outcome = \"joint\"\nsigmoid = \"norm\"\n"), hash("outcome = \"joint\"\n"));
}

TEST(StudyFileAnalysis, IsReadStrictlyAndIsNoPartOfTheHash) {
  const auto text = [](const std::string& settings) {
    return test::study_of_no_files("", "[analysis]\n" + settings);
  };
  EXPECT_EQ(study_hash(read_study_text(text("model = \"paper\"\n"), "study.toml")),
            study_hash(read_study_text(text(""), "study.toml")));
  const AnalysisDefinition read = read_analysis_text(text("share = [\"scale\", \"lapse\"]\n"), "study.toml");
  EXPECT_TRUE(read.joint && read.share_scale && read.share_lapse);
  EXPECT_FALSE(read.share_criteria || read.share_guess_ratings);
  EXPECT_FALSE(read.sharing_tested) << "a study that says what is shared is not asked the answers";
  EXPECT_FALSE(read_analysis_text(text("share = [\"nothing\"]\n"), "study.toml").share_scale);
  EXPECT_EQ(read_analysis_text(text("share = [\"tested\"]\n"), "study.toml"), AnalysisDefinition{});
  EXPECT_EQ(read_analysis_text(test::study_of_no_files("", ""), "study.toml"), AnalysisDefinition{});
  for (const char* wrong :
       {"share = [\"slopes\"]\n", "share = [\"scale\", \"scale\"]\n", "model = \"lines\"\n",
        "model = \"paper\"\nshare = [\"scale\"]\n", "shared = [\"scale\"]\n"})
    EXPECT_THAT(test::complaint_of([&] { (void)read_study_text(text(wrong), "study.toml"); }),
                HasSubstr("analysis."))
        << wrong;
}

TEST(StudyFileProcedure, DefaultsReachAnOctaveBeyondTheWidths) {
  const QuestPlusDefinition quest = quest_plus("");
  EXPECT_EQ(quest.max_shows_per_image, 3);
  EXPECT_EQ(quest.threshold.least, 32);
  EXPECT_EQ(quest.threshold.most, 8192);
  EXPECT_EQ(quest.threshold.count, 41);
  EXPECT_EQ(quest.guess.least, 1.0 / 3);
  EXPECT_EQ(quest.max_trials, 40);
  EXPECT_FALSE(quest.stop_interval || quest.stop_entropy_nats);
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
  EXPECT_EQ(quest.threshold.most, 20000);
  EXPECT_EQ(quest.scale.count, 1);
  EXPECT_EQ(quest.lapse.least, 0.01);
  EXPECT_EQ(quest.guess.count, 3);
  EXPECT_EQ(quest.rating_step.count, 5);
  EXPECT_EQ(quest.min_trials, 5);
  EXPECT_EQ(quest.max_trials, 60);
  EXPECT_EQ(quest.stop_interval, 0.75);
  EXPECT_EQ(quest.stop_entropy_nats, 4.5);
  EXPECT_EQ(quest.edge_share, 0.2);
}

TEST(StudyFileProcedure, ReadsAxisDirectionValuesAndPriors) {
  const QuestPlusDefinition quest = quest_plus(R"(axis = "linear"
noticeability = "rises"
outcome = "noticeability"
threshold_px = { least = 100, most = 900, count = 9, prior = { mean = 300, sd = 120 } }
scale_px = { values = [10, 20, 50], prior = { weights = [1, 2, 0] } }
rating_step_px = { least = 5, most = 20, count = 4, steps = "equal" }
lapse = { prior = { a = 1, b = 20 } }
guess = { least = 0.2, most = 0.4, count = 3, prior = { mean = 0.33, sd = 0.05 } }
stop_interval_px = 80
)");
  EXPECT_EQ(quest.axis, Axis::linear);
  EXPECT_EQ(quest.direction, Direction::increasing);
  EXPECT_EQ(std::get<NormalMass>(quest.threshold.prior).mean, 300);
  EXPECT_EQ(std::get<NormalMass>(quest.threshold.prior).sd, 120);
  EXPECT_EQ(quest.scale.values, (std::vector<double>{10, 20, 50}));
  EXPECT_EQ(quest.scale.count, 3);
  EXPECT_EQ(std::get<ListedMass>(quest.scale.prior).weights, (std::vector<double>{1, 2, 0}));
  EXPECT_EQ(quest.rating_step.steps, Steps::equal);
  EXPECT_EQ(std::get<BetaMass>(quest.lapse.prior).b, 20);
  EXPECT_EQ(quest.lapse.count, 5);
  EXPECT_EQ(std::get<NormalMass>(quest.guess.prior).sd, 0.05);
  EXPECT_EQ(quest.stop_interval, 80);

  const QuestPlusDefinition usual = quest_plus("axis = \"linear\"\n");
  EXPECT_FALSE(usual.threshold.steps);
  EXPECT_LT(usual.scale.least, usual.scale.most);
  EXPECT_TRUE(std::holds_alternative<EvenMass>(usual.threshold.prior));
}

TEST(StudyFileProcedure, WhatIsUsualMayBeSaidWithoutAnotherHash) {
  const auto hash = [](const std::string& settings) {
    return study_hash(read_procedure(adaptive, "[quest_plus]\nmax_shows_per_image = 3\n" + settings));
  };
  const std::string usual = hash("");
  EXPECT_EQ(usual, hash("axis = \"log2\"\nnoticeability = \"falls\"\nthreshold_px = { steps = \"ratios\" }\n"
                        "lapse = { steps = \"equal\" }\n"));
  EXPECT_EQ(study_hash(read_procedure("", "")),
            study_hash(read_procedure("", "[observer]\nnoticeability = \"falls\"\n")));
  EXPECT_NE(study_hash(read_procedure("", "")),
            study_hash(read_procedure("", "[observer]\nnoticeability = \"rises\"\n")));
  // Hashes of studies that were rendered before any of this could be said.
  EXPECT_EQ(hash("outcome = \"noticeability\"\nstop_interval_octaves = 1\n"),
            "d3a8d9c2de21c1549b1c7841a174298f0c3040beddbf7e316878e214f17a6773");
  EXPECT_EQ(usual, "9d84f32918c6c32d21656e75a1a55763d66307d888012690b561d093462fd5c5");
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
                                           "edge_share = 0.3",
                                           "noticeability = \"rises\"",
                                           "axis = \"linear\"",
                                           "threshold_px = { steps = \"equal\" }",
                                           "threshold_px = { prior = { mean = 300, sd = 1 } }",
                                           "threshold_px = { prior = { mean = 300, sd = 2 } }",
                                           "scale_octaves = { values = [0.1, 1] }",
                                           "scale_octaves = { values = [0.1, 0.5, 1] }",
                                           "lapse = { prior = { a = 1, b = 20 } }",
                                           "lapse = { prior = { a = 2, b = 20 } }",
                                           "lapse = { prior = { mean = 0, sd = 0.1 } }",
                                           "lapse = { prior = { weights = [1, 1, 1, 1, 2] } }",
                                           "outcome = \"noticeability\"\nrating_step_octaves = "
                                           "{ prior = { mean = 0.5, sd = 1 } }"};
  for (const std::string& setting : others) hashes.insert(hash(shows + setting + "\n"));
  EXPECT_EQ(hashes.size(), 3 + others.size());
}

TEST(StudyFileProcedure, RefusesWhatIsWrongInOneSentence) {
  EXPECT_THAT(
      complaint_of_procedure("procedure = \"ladder\"", ""),
      testing::AllOf(HasSubstr("study.toml: procedure"), HasSubstr("\"constant\""),
                     HasSubstr("\"quest_plus\""), HasSubstr("\"staircase\""), HasSubstr("\"ladder\"")));
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
      {"axis = \"log10\"", "quest_plus.axis"},
      {"axes = \"log2\"", "did you mean \"axis\""},
      {"noticeability = \"increasing\"", "\"falls\" or \"rises\""},
      {"noticability = \"rises\"", "did you mean \"noticeability\""},
      {"scale_px = { count = 3 }", "scale_px: wanted scale_octaves where axis = \"log2\""},
      {"axis = \"linear\"\nscale_octaves = { count = 3 }", "scale_octaves: wanted scale_px where"},
      {"axis = \"linear\"\nstop_interval_octaves = 1", "wanted stop_interval_px where"},
      {"axis = \"linear\"\nrating_step_px = { count = 3 }", "outcome"},
      {"threshold_px = { values = [] }", "threshold_px.values: wanted an array of numbers"},
      {"threshold_px = { values = [2, 1] }", "values that rise, found 1 after 2"},
      {"threshold_px = { values = [1, 1] }", "values that rise"},
      {"threshold_px = { values = [0, 1] }", "threshold_px.values: wanted numbers, each"},
      {"threshold_px = { values = [1, \"x\"] }", "threshold_px.values"},
      {"threshold_px = { values = [1, 2], count = 2 }", "threshold_px.count: wanted either values"},
      {"threshold_px = { steps = \"log\" }", "\"equal\" or \"ratios\""},
      {"lapse = { steps = \"ratios\" }", "lapse.steps"},
      {"lapse = { prior = \"even\" }", "lapse.prior"},
      {"lapse = { prior = {} }", "lapse.prior: wanted mean and sd, a and b, or weights, found nothing"},
      {"lapse = { prior = { meen = 1 } }", "did you mean \"mean\""},
      {"lapse = { prior = { mean = 0.1 } }", "lapse.prior.sd: wanted a number beside mean, found nothing"},
      {"lapse = { prior = { a = 0.5, b = 2 } }", "lapse.prior.a"},
      {"lapse = { prior = { mean = 0.1, sd = 0 } }", "lapse.prior.sd"},
      {"lapse = { prior = { mean = nan, sd = 1 } }", "lapse.prior.mean"},
      {"lapse = { prior = { mean = 0, sd = 1, weights = [1, 1, 1, 1, 1] } }", "lapse.prior: wanted one of"},
      {"lapse = { prior = { weights = [1, 1] } }", "lapse.prior.weights: wanted 5 numbers"},
      {"lapse = { prior = { weights = [1, 1, 1, 1, -1] } }", "lapse.prior.weights"},
      {"lapse = { prior = { weights = [0, 0, 0, 0, 0] } }", "lapse.prior: wanted a value that is possible"},
      {"lapse = { most = 0, count = 1, prior = { a = 2, b = 2 } }", "a value that is possible, found none"},
      {"scale_octaves = { prior = { a = 1, b = 2 } }", "scale_octaves.prior.a"},
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
