#include "analysis/foresight/plan_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "analysis/foresight/plan_scenes.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

namespace fs = std::filesystem;

class PlanStudy : public testing::Test {
 protected:
  PlanRequest request(const std::string& head, const std::string& artifacts = "\"receiver\", \"overlap\"",
                      const std::string& tail = "") {
    std::string text = "format = \"seamline study 1\"\nname = \"plan\"\n" + head +
                       "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [" + artifacts + "]\n";
    for (const char* object : {"left", "middle", "right"})
      text += std::string("[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
    write_file_atomically(folder_ / "study.toml", text + tail);
    PlanRequest request;
    request.study_file = folder_ / "study.toml";
    request.participants = {5, 20, 60};
    request.studies = 60;
    request.estimator = PlanEstimator::straight_lines;  // quick; the joint model has a test of its own
    return request;
  }

  const TemporaryFolder folder_;
};

const std::string paper_widths = "depth_width_px = [64, 128, 256, 512, 1024, 2048, 4096]";

// Scenes add their own variance: the text says so where it is assumed, and is what it was where it is not.
TEST_F(PlanStudy, SaysWhatScenesCanClaimWhereTheirSpreadIsAssumed) {
  PlanRequest asked = request(paper_widths, "\"receiver\"");
  asked.studies = 20;
  const std::string without = plan_text(plan_study(asked));
  asked.between_scenes = 0.5;
  const StudyPlan plan = plan_study(asked);
  std::string with = plan_text(plan);
  const std::string scenes = scenes_plan_text(plan), assumed = " " + scenes_assumed_text(asked, plan.axis);
  EXPECT_NE(scenes.find("10 scenes"), std::string::npos);
  EXPECT_EQ(scenes.find("1 scenes"), std::string::npos);
  EXPECT_NE(scenes.find("With one scene"), std::string::npos);
  for (const std::string& part : {scenes, assumed}) {
    ASSERT_NE(with.find(part), std::string::npos);
    with.erase(with.find(part), part.size());
  }
  EXPECT_EQ(with, without);
}

TEST_F(PlanStudy, MorePeopleGiveShorterIntervals) {
  const StudyPlan plan = plan_study(request(paper_widths));
  ASSERT_EQ(plan.level_sets.size(), 3U);
  ASSERT_EQ(plan.targets.size(), 4U);  // PT and SN of two artifacts
  ASSERT_EQ(plan.rows.size(), 4U * 3 * 3);
  EXPECT_EQ(plan.trials_a_level, 6);
  for (std::size_t row = 0; row < plan.rows.size(); row += 3) {
    const auto median = [&](std::size_t n) {
      return plan.rows[row + n].interval.median_length.value_or(infinity);
    };
    EXPECT_GE(median(0), median(1));
    EXPECT_GE(median(1), median(2));
    EXPECT_GE(plan.rows[row].interval.open_share, plan.rows[row + 2].interval.open_share);
    // 20 to 60 people: near 1 / sqrt(3), where intervals are far from open
    if (plan.targets[plan.rows[row].target].quantity.word == "SN") {
      EXPECT_NEAR(median(2) / median(1), 1 / std::sqrt(3.0), 0.15);
    }
  }
}

TEST_F(PlanStudy, SameTableForAnyNumberOfThreadsAndSameSeed) {
  PlanRequest one = request(paper_widths), many = one, other = one;
  one.threads = 1;
  many.threads = 4;
  other.seed = 2;
  EXPECT_EQ(plan_text(plan_study(one)), plan_text(plan_study(many)));
  EXPECT_NE(plan_text(plan_study(one)), plan_text(plan_study(other)));
}

TEST_F(PlanStudy, LevelSetsAreTheStudysEverySecondAndDenser) {
  PlanRequest wish = request(paper_widths);
  wish.studies = 1;
  const std::vector<LevelSet> sets = plan_study(wish).level_sets;
  ASSERT_EQ(sets.size(), 3U);
  EXPECT_EQ(sets[0].levels, (std::vector<double>{64, 128, 256, 512, 1024, 2048, 4096}));
  EXPECT_EQ(sets[1].levels, (std::vector<double>{64, 256, 1024, 4096}));
  EXPECT_EQ(sets[2].levels.front(), 64);
  EXPECT_EQ(sets[2].levels.back(), 4096);
  for (std::size_t i = 2; i + 1 < sets[2].levels.size(); ++i) {
    EXPECT_EQ(std::fmod(sets[2].levels[i], 2), 0);
    EXPECT_NEAR(std::log2(sets[2].levels[i]) - std::log2(sets[2].levels[i - 1]), 0.5, 0.02);
  }
}

/// True crossings, and what straight lines make of them, in octaves; computed by Gauss-Hermite quadrature and
/// Brent's method in another language.
TEST_F(PlanStudy, TruthAndBiasAreThoseOfAnIndependentComputation) {
  PlanRequest wish = request("depth_width_px = [64, 256, 512, 1024, 4096]");
  wish.studies = 1;
  const StudyPlan plan = plan_study(wish);
  struct Reference {
    double true_px, all, second;
  };
  const std::array<Reference, 4> references = {
      {{660, 0.23, 1.22}, {400, 0.10, 0.06}, {1980, 0.73, 0.87}, {1200, 0.37, 0.99}}};
  for (std::size_t target = 0; target < references.size(); ++target) {
    EXPECT_NEAR(std::exp2(plan.targets[target].truth_x), references[target].true_px, 0.6);
    EXPECT_NEAR(plan.bias_x[target][0].value(), references[target].all, 0.005);
    EXPECT_NEAR(plan.bias_x[target][1].value(), references[target].second, 0.005);
  }
}

/// The design whose intervals look shortest is short beside the truth.
TEST_F(PlanStudy, ABiasedDesignIsWarnedOfAndNeverRecommended) {
  PlanRequest wish = request("depth_width_px = [64, 256, 512, 1024, 4096]", "\"occlusion\"");
  wish.participants = {80};
  wish.wanted.quantities = {"SN"};
  const StudyPlan plan = plan_study(wish);
  ASSERT_EQ(plan.level_sets[1].name, "every second");
  const PlanRow& second = plan.rows[1];
  ASSERT_EQ(second.level_set, 1U);
  EXPECT_LT(second.interval.median_length.value(), 1);
  EXPECT_LT(second.interval.holds_share, 0.05);
  EXPECT_GT(plan.designs[1].assurance, 0.95);
  EXPECT_FALSE(meets_wish(plan, plan.designs[1]));
  EXPECT_EQ(fewest_answers(plan)->level_set, 0U);
  EXPECT_NE(plan_text(plan).find("Warning: with the widths \"every second\""), std::string::npos);
}

/// The joint model is not fooled by few widths: what it finds in the exact shares of all answers lies near
/// the truth, and so do its intervals.
TEST_F(PlanStudy, TheJointModelHasLittleBias) {
  PlanRequest wish = request("depth_width_px = [64, 256, 512, 1024, 4096]", "\"receiver\"");
  wish.estimator = PlanEstimator::joint;
  wish.wanted.quantities = {"PT", "SN", "corrected-PT", "corrected-SN"};
  wish.participants = {20};
  wish.studies = 10;
  const StudyPlan plan = plan_study(wish);
  ASSERT_EQ(plan.targets.size(), 4U);
  for (std::size_t target = 0; target < 4; ++target) {
    EXPECT_LT(std::abs(plan.bias_x[target][0].value()), 0.08) << target;
    EXPECT_GE(plan.rows[target * plan.level_sets.size()].interval.holds_share, 0.5) << target;
  }
  EXPECT_NE(plan_text(plan).find("analysed by the joint model"), std::string::npos);
}

TEST_F(PlanStudy, TheDesignFoundMeetsTheWishAndNoSmallerOneDoes) {
  StudyPlan plan = plan_study(request(paper_widths));
  const std::optional<DesignRow> people = fewest_participants(plan), answers = fewest_answers(plan);
  ASSERT_TRUE(people && answers);
  EXPECT_TRUE(meets_wish(plan, *people));
  EXPECT_TRUE(meets_wish(plan, *answers));
  for (const DesignRow& design : plan.designs)
    if (design.participants < people->participants) {
      EXPECT_FALSE(meets_wish(plan, design));
    }
  // All intervals of a study together: never more often than the rarest of them
  for (const DesignRow& design : plan.designs)
    for (const PlanRow& row : plan.rows)
      if (row.level_set == design.level_set && row.participants == design.participants) {
        EXPECT_LE(design.all_hold, row.interval.holds_share + 1e-9);
      }
  plan.request.assurance = 1.1;
  EXPECT_FALSE(fewest_participants(plan));
  EXPECT_NE(plan_text(plan).find("no design"), std::string::npos);
}

TEST_F(PlanStudy, AThresholdBeyondTheWidthsIsSaidAndNotWaitedFor) {
  const StudyPlan plan =
      plan_study(request("depth_width_px = [64, 128, 256]\n[observer.midpoint_width_px]\noverlap = 60000\n"));
  EXPECT_FALSE(plan.rows.back().interval.within);
  EXPECT_NE(plan_text(plan).find("beyond the widths"), std::string::npos);
}

/// Where everybody sees an artifact at every width, or nobody does, both ends of an interval lie beyond the
/// widths: the interval is open, and no number of people closes it. (Infinity less infinity is NaN, which is
/// less than any wish.)
TEST_F(PlanStudy, AnIntervalWhollyBeyondTheWidthsIsOpen) {
  const StudyPlan plan = plan_study(
      request(paper_widths +
                  "\n[observer]\nscale_octaves = 0.2\npeople_sd_octaves = 0.2\n[observer.midpoint_width_px]\n"
                  "receiver = 5200\nshadow = 40\nocclusion = 4400\noverlap = 3000\n",
              "\"receiver\", \"shadow\", \"occlusion\", \"overlap\""));
  int within = 0;
  for (const PlanRow& row : plan.rows) {
    const PlannedInterval& interval = row.interval;
    const std::string name = name_of(plan.targets[row.target], plan.curves);
    EXPECT_EQ(interval.median_length.has_value(), interval.open_share < 0.5) << name << row.participants;
    if (interval.median_length) {
      EXPECT_TRUE(std::isfinite(*interval.median_length));
    }
    if (!interval.within) {
      EXPECT_GT(interval.open_share, 0.9) << name << ", " << row.participants;
    }
    within += interval.within && row.level_set == 0 && row.participants == 5 ? 1 : 0;
  }
  EXPECT_EQ(within, 1);  // SN of the overlap
  EXPECT_NE(plan_text(plan).find("(7 of 8 thresholds)"), std::string::npos) << plan_text(plan);
}

const std::string two_lights =
    "[[condition]]\nname = \"sharp\"\n[[condition]]\nname = \"soft\"\nisolation = \"mask\"\n"
    "[observer.condition_midpoint.soft]\nreceiver = 600\n";

/// Conditions are curves of their own, and their difference has power where there is one, and none to speak
/// of where there is none.
TEST_F(PlanStudy, DifferencesOfConditionsHavePowerAndEquivalence) {
  PlanRequest wish = request(paper_widths, "\"receiver\"", two_lights);
  wish.wanted = {.quantities = {"SN"}, .differences = {"sharp:soft"}, .differences_alone = true};
  wish.participants = {10, 40};
  wish.studies = 40;
  wish.equal_within = 0.5;
  const StudyPlan apart = plan_study(wish);
  ASSERT_EQ(apart.targets.size(), 1U);
  EXPECT_NEAR(apart.targets[0].truth_x, 1, 1e-6);  // 300 and 600 px
  EXPECT_GT(apart.rows[1].interval.power, 0.95);
  EXPECT_LT(apart.rows[1].interval.equal_share, 0.05);
  wish.wanted.stated_difference = 0;
  const StudyPlan equal = plan_study(wish);
  EXPECT_NEAR(equal.targets[0].truth_x, 0, 1e-9);
  EXPECT_LT(equal.rows[1].interval.power, 0.15);
  EXPECT_GT(equal.rows[1].interval.equal_share, 0.7);
}

TEST_F(PlanStudy, AskingUntilIntervalsAreShortStopsEarlyAndTellsItsPrice) {
  PlanRequest wish = request(paper_widths, "\"receiver\"");
  wish.wanted.quantities = {"SN"};
  wish.sequential = true;
  const StudyPlan plan = plan_study(wish);
  ASSERT_EQ(plan.sequential.size(), 3U);
  for (const SequentialRow& row : plan.sequential) {
    EXPECT_GE(row.mean_participants, 5);
    EXPECT_LE(row.mean_participants, 60);
    EXPECT_LE(row.holds, 1 + 1e-9);
  }
  wish.wanted_length = 100;
  wish.participants = {20, 60};
  const StudyPlan at_once = plan_study(wish);
  EXPECT_NEAR(at_once.sequential[0].mean_participants, 20, 0.5);
  // Stopped at the first look, it is a study of so many people.
  EXPECT_NEAR(at_once.sequential[0].holds, at_once.rows[0].interval.holds_share, 0.03);
}

/// Nobody sees anything at 4096 px, half is seen at 64.
TEST_F(PlanStudy, NoSeamIsShownWhereThereIsNone) {
  PlanRequest wish = request(
      "depth_width_px = [64, 128, 4096]\n[observer.midpoint_width_px]\nreceiver = 64\n", "\"receiver\"");
  wish.no_seam = NoSeamClaim{.level = 4096, .margin = 0.5};
  const StudyPlan none = plan_study(wish);
  EXPECT_LT(none.seam_truth[0], 0.01);
  EXPECT_GT(none.designs[2].no_seam[0], 0.9);
  wish.no_seam->level = 64;
  EXPECT_LT(plan_study(wish).designs[2].no_seam[0], 0.05);
  wish.no_seam->level = 100;
  EXPECT_THROW((void)plan_study(wish), InputError);
}

TEST_F(PlanStudy, AStudyThatCheckRefusesIsPlannedOnlyWhereItsSetsAreThere) {
  PlanRequest idle = request(paper_widths + "\nmesh = \"full\"\nmesh_tolerance = 0.01\n", "\"receiver\"");
  idle.studies = 5;
  EXPECT_THAT(test::complaint_of([&] { (void)plan_study(idle); }),
              testing::HasSubstr("mesh_tolerance: wanted mesh = \"adaptive\" beside it"));
  idle.idle = IdleSettings::kept;
  EXPECT_EQ(plan_study(idle).curves.size(), 1U);
}

TEST_F(PlanStudy, StudiesThatCannotBePlannedAreWrongInput) {
  EXPECT_THROW((void)plan_study(request("depth_width_px = [64]")), InputError);
  EXPECT_THROW((void)plan_study(request(paper_widths, "\"none\"")), InputError);
  EXPECT_THROW((void)plan_study(request(paper_widths + "\nprocedure = \"quest_plus\"\n[quest_plus]\n"
                                                       "max_shows_per_image = 3\n")),
               InputError);
  PlanRequest wish = request(paper_widths);
  for (const WantedTargets& wanted :
       {WantedTargets{.quantities = {"P2"}}, WantedTargets{.artifacts = {"shadow"}},
        WantedTargets{.conditions = {"soft"}}, WantedTargets{.differences = {"receiver:shadow"}},
        WantedTargets{.differences = {"receiver"}}, WantedTargets{.differences_alone = true}}) {
    wish.wanted = wanted;
    EXPECT_THROW((void)plan_study(wish), InputError);
  }
}

}  // namespace
}  // namespace seamline::analysis
