// Clip against still: the joint model's contrast with a condition whose clips are one picture each.
#include "analysis/report/tables/still_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/files/atomic_file.h"
#include "tests/analysis/condition_people.h"

namespace seamline::analysis {
namespace {

Analysis analysis_of_ready_study(const std::string& name) {
  study::LogContents log = test::condition_log(test::planted_study(name), 12, 1);
  log.study_text = read_file(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / name);
  return analyze(std::move(log), false, {.replicates = 100, .seed = 9});
}

TEST(StillTables, AClipIsComparedWithTheStillOfItsFirstFrame) {
  const Analysis analysis = analysis_of_ready_study("video_background.toml");
  const std::vector<ClipAgainstStill> compared = clips_against_stills(analysis);
  ASSERT_EQ(compared.size(), 2U);
  for (const ClipAgainstStill& one : compared) {
    EXPECT_EQ(one.clip, "new");
    EXPECT_EQ(one.still, "held");
    // The study plants an octave.
    EXPECT_NEAR(one.difference.estimate, -1, 0.5);
    EXPECT_LT(one.difference.ci95_low, one.difference.estimate);
    EXPECT_GT(one.difference.ci95_high, one.difference.estimate);
  }
  EXPECT_THAT(sentences_of(analysis, compared).front(), testing::HasSubstr("whose clips are stills"));
  const CsvTable table = still_table(analysis, compared);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows.front().size(), table.columns.size());
}

TEST(StillTables, AStudyOfStillsHasNoClipsToCompare) {
  EXPECT_TRUE(clips_against_stills(analysis_of_ready_study("soft_light.toml")).empty());
}

}  // namespace
}  // namespace seamline::analysis
