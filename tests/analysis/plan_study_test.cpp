#include "analysis/foresight/plan_text.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"

namespace seamline::analysis {
namespace {

namespace fs = std::filesystem;

class PlanStudy : public testing::Test {
 protected:
  PlanRequest request(const std::string& head, const std::string& artifacts = "\"receiver\", \"overlap\"") {
    std::string text = "format = \"seamline study 1\"\nname = \"plan\"\n" + head +
                       "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [" + artifacts + "]\n";
    for (const char* object : {"left", "middle", "right"})
      text += std::string("[[scene.object]]\nname = \"") + object + "\"\nfile = \"none.glb\"\n";
    write_file_atomically(folder_ / "study.toml", text);
    return {.study_file = folder_ / "study.toml", .participants = {5, 20, 60}, .studies = 60};
  }

  const TemporaryFolder folder_;
};

const std::string paper_widths = "depth_width_px = [64, 128, 256, 512, 1024, 2048, 4096]";

TEST_F(PlanStudy, MorePeopleGiveNarrowerIntervals) {
  const StudyPlan plan = plan_study(request(paper_widths));
  ASSERT_EQ(plan.width_sets.size(), 3U);
  ASSERT_EQ(plan.rows.size(), 2U * 3 * 3);
  EXPECT_EQ(plan.stimuli_a_width, 6);
  for (std::size_t row = 0; row < plan.rows.size(); row += 3) {
    for (const PlanRow* few : {&plan.rows[row], &plan.rows[row + 1]}) {
      // Intervals may be open in most studies of few people: then there is no median
      if (few->perceptual.median_octaves) {
        ASSERT_TRUE(few[1].perceptual.median_octaves);
        EXPECT_GE(*few->perceptual.median_octaves, *few[1].perceptual.median_octaves);
      }
      EXPECT_GE(few->perceptual.open_share, few[1].perceptual.open_share);
      ASSERT_TRUE(few[1].slightly_noticeable.median_octaves);
      if (few->slightly_noticeable.median_octaves) {
        EXPECT_GT(*few->slightly_noticeable.median_octaves, *few[1].slightly_noticeable.median_octaves);
      }
    }
    // 20 to 60 people: near 1 / sqrt(3), the last row's intervals are far from open
    const double ratio = *plan.rows[row + 2].slightly_noticeable.median_octaves /
                         *plan.rows[row + 1].slightly_noticeable.median_octaves;
    EXPECT_NEAR(ratio, 1 / std::sqrt(3.0), 0.15);
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

TEST_F(PlanStudy, WidthSetsAreTheStudysEverySecondAndDenser) {
  const StudyDefinition study = read_study(request(paper_widths).study_file, AssetCheck::not_needed);
  const std::vector<WidthSet> sets = width_sets_to_try(study);
  ASSERT_EQ(sets.size(), 3U);
  EXPECT_EQ(sets[0].width_px, depth_widths_px(study));
  EXPECT_EQ(sets[1].width_px, (std::vector<int>{64, 256, 1024, 4096}));
  EXPECT_EQ(sets[2].width_px.front(), 64);
  EXPECT_EQ(sets[2].width_px.back(), 4096);
  for (std::size_t i = 2; i + 1 < sets[2].width_px.size(); ++i) {
    EXPECT_EQ(sets[2].width_px[i] % 2, 0);
    EXPECT_NEAR(std::log2(sets[2].width_px[i]) - std::log2(sets[2].width_px[i - 1]), 0.5, 0.02);
  }
}

TEST_F(PlanStudy, TheDesignFoundMeetsTheWishAndNoSmallerOneDoes) {
  StudyPlan plan = plan_study(request(paper_widths));
  plan.wanted_octaves = 1.0;
  const std::optional<PlannedDesign> people = fewest_participants(plan), answers = fewest_answers(plan);
  ASSERT_TRUE(people && answers);
  const auto meets = [&](std::size_t width_set, int participants) {
    for (const PlanRow& row : plan.rows)
      if (row.width_set == width_set && row.participants == participants &&
          !(row.perceptual.median_octaves && row.slightly_noticeable.median_octaves &&
            std::max(*row.perceptual.median_octaves, *row.slightly_noticeable.median_octaves) <= 1.0))
        return false;
    return true;
  };
  EXPECT_TRUE(meets(people->width_set, people->participants));
  EXPECT_TRUE(meets(answers->width_set, answers->participants));
  for (std::size_t set = 0; set < 3; ++set)
    for (const int participants : {5, 20, 60})
      if (participants < people->participants) {
        EXPECT_FALSE(meets(set, participants));
      }
  plan.wanted_octaves = 0.001;
  EXPECT_FALSE(fewest_participants(plan));
  EXPECT_NE(plan_text(plan).find("no design"), std::string::npos);
}

TEST_F(PlanStudy, AThresholdBeyondTheWidthsIsSaidAndNotWaitedFor) {
  PlanRequest wish =
      request("depth_width_px = [64, 128, 256]\n[observer.midpoint_width_px]\noverlap = 60000\n");
  const StudyPlan plan = plan_study(wish);
  EXPECT_FALSE(plan.rows.back().perceptual.planted);
  EXPECT_NE(plan_text(plan).find("beyond the widths"), std::string::npos);
}

/// Where everybody sees an artifact at every width, or nobody does, both ends of an interval lie beyond the
/// widths: the interval is open, and no number of people closes it. (Infinity less infinity is NaN, which is
/// less than any wish.)
TEST_F(PlanStudy, AnIntervalWhollyBeyondTheWidthsIsOpen) {
  const PlanRequest wish =
      request(paper_widths +
                  "\n[observer]\nscale_octaves = 0.2\npeople_sd_octaves = 0.2\n[observer.midpoint_width_px]\n"
                  "receiver = 5200\nshadow = 40\nocclusion = 4400\noverlap = 3000\n",
              "\"receiver\", \"shadow\", \"occlusion\", \"overlap\"");
  const StudyPlan plan = plan_study(wish);
  int within = 0;
  for (const PlanRow& row : plan.rows)
    for (const PlannedInterval* interval : {&row.perceptual, &row.slightly_noticeable}) {
      EXPECT_EQ(interval->median_octaves.has_value(), interval->open_share < 0.5)
          << word(row.artifact) << ", " << row.participants;
      if (interval->median_octaves) {
        EXPECT_TRUE(std::isfinite(*interval->median_octaves));
      }
      if (!interval->planted) {
        EXPECT_GT(interval->open_share, 0.9) << word(row.artifact) << ", " << row.participants;
      }
      within += interval->planted && row.width_set == 0 && row.participants == 5 ? 1 : 0;
    }
  EXPECT_EQ(within, 1);  // SN of the overlap
  const std::string text = plan_text(plan);
  EXPECT_NE(text.find("(7 of 8 thresholds)"), std::string::npos) << text;
  EXPECT_EQ(text.find("for every artifact"), std::string::npos) << text;
}

TEST_F(PlanStudy, StudiesThatCannotBePlannedAreWrongInput) {
  EXPECT_THROW((void)plan_study(request("depth_width_px = [64]")), InputError);
  EXPECT_THROW((void)plan_study(request(paper_widths, "\"none\"")), InputError);
  EXPECT_THROW((void)plan_study(request(paper_widths + "\nprocedure = \"quest_plus\"\n[quest_plus]\n"
                                                       "max_shows_per_image = 3\n")),
               InputError);
}

}  // namespace
}  // namespace seamline::analysis
