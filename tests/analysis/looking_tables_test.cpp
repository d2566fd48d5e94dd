// How people looked round panoramas, as the report says it: means over people, not over trials.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/tables/looking_tables.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using study::MeasuredLook;

/// Everybody turned by 10 degrees in each trial but the first participant, who turned by 50; everybody saw
/// the object after two seconds, but the first never.
std::vector<MeasuredLook> planted_looks(const study::LogContents& log) {
  std::vector<MeasuredLook> looks;
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    const bool first = log.answers[i].participant == log.participants[0].code;
    MeasuredLook look{.answer = i, .object_yaw_deg = 0, .measures = {}};
    look.measures.degrees_turned = first ? 50 : 10;
    if (!first) look.measures.first_look_s = 2;
    look.measures.share_facing = first ? 0 : 0.5;
    looks.push_back(look);
  }
  return looks;
}

TEST(LookingTables, AreMeansOverPeopleOfThoseUsed) {
  study::LogContents log = test::simulate_log(5, 1);
  log.participants[1].excluded = true;
  const Analysis analysis = analyze(log, false, {.replicates = 100, .seed = 9});
  const std::vector<LookingRow> rows = looking_rows(analysis, planted_looks(log));
  ASSERT_EQ(rows.size(), analysis.data.artifacts.size());
  for (const LookingRow& row : rows) {
    EXPECT_EQ(row.people, 4);
    EXPECT_EQ(row.answers % 4, 0);
    EXPECT_NEAR(row.degrees_turned.mean, (50 + 3 * 10) / 4.0, 1e-12);
    // Of 50, 10, 10, 10 the standard error is 10, and Student's t with 3 degrees of freedom 3.182.
    EXPECT_NEAR(row.degrees_turned.high - row.degrees_turned.mean, 31.82, 0.01);
    EXPECT_NEAR(row.share_seen.mean, 0.75, 1e-12);
    EXPECT_NEAR(row.share_facing.mean, 0.375, 1e-12);
    ASSERT_TRUE(row.first_look_s);
    EXPECT_NEAR(*row.first_look_s, 2, 1e-12);
  }
  const CsvTable table = looking_table(analysis, rows);
  EXPECT_EQ(table.rows.size(), rows.size());
  EXPECT_EQ(table.rows.front().size(), table.columns.size());
  EXPECT_THAT(csv_text(table), testing::HasSubstr("receiver,4,"));
}

TEST(LookingTables, OneParticipantHasNoIntervalAndNobodyNoRow) {
  const study::LogContents log = test::simulate_log(3, 1);
  const Analysis analysis = analyze(log, false, {.replicates = 100, .seed = 9});
  EXPECT_TRUE(looking_rows(analysis, {}).empty());
  std::vector<MeasuredLook> looks = planted_looks(log);
  std::erase_if(looks, [&](const MeasuredLook& look) {
    return log.answers[look.answer].participant != log.participants[0].code;
  });
  for (const LookingRow& row : looking_rows(analysis, looks)) {
    EXPECT_TRUE(std::isnan(row.degrees_turned.low));
    EXPECT_FALSE(row.first_look_s);
  }
}

}  // namespace
}  // namespace seamline::analysis
