// Trials whose clips came late: marked, counted, and the thresholds with and without them.
#include "analysis/screening/late_marks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/tables/late_tables.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using testing::HasSubstr;

/// Every answer saw 40 frames, two of them late; every third answer at fine depth maps dropped ten, and there
/// the person was wrong.
struct PlantedLateness {
  study::LogContents log = test::simulate_log(8, 1);
  LateMarks marks;

  PlantedLateness() {
    for (std::size_t i = 0; i < log.answers.size(); ++i) {
      const bool drops = i % 3 == 0 && log.answers[i].level > 500;
      marks.counts.emplace_back(study::ClipCounts{.shown = 40, .late = 2, .dropped = drops ? 10 : 0});
      if (drops) log.answers[i].chosen_index = log.answers[i].object_index;
      if (drops) log.answers[i].rating = 4;
    }
  }
};

TEST(LateMarks, LeaveOutWhatIsMarkedAndNothingElse) {
  PlantedLateness planted;
  const study::LogContents rest = without_marked(planted.log, planted.marks);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < planted.log.answers.size(); ++i) {
    if (planted.marks.is_marked(i)) continue;
    ASSERT_LT(kept, rest.answers.size());
    EXPECT_EQ(rest.answers[kept].stimulus_id, planted.log.answers[i].stimulus_id);
    EXPECT_EQ(rest.answers[kept].participant, planted.log.answers[i].participant);
    ++kept;
  }
  EXPECT_EQ(kept, rest.answers.size());
  EXPECT_LT(kept, planted.log.answers.size());
  planted.marks.rule.most_share = 0.25;  // 12 of 50 are fewer
  EXPECT_FALSE(planted.marks.any());
  EXPECT_EQ(without_marked(planted.log, planted.marks).answers.size(), planted.log.answers.size());
}

TEST(LateMarks, TheReportSaysWhatLateTrialsDid) {
  PlantedLateness planted;
  planted.log.participants[1].excluded = true;
  const ResamplingRequest few{.replicates = 100, .seed = 9};
  const Analysis with = analyze(planted.log, false, few);
  const Analysis without = analyze(without_marked(planted.log, planted.marks), false, few);
  const LateReport late{.rule = planted.marks.rule,
                        .rows = late_rows(planted.log, with, planted.marks),
                        .thresholds = thresholds_beside(with, without)};
  const LateRow all = late.all();
  const auto used = static_cast<int>(planted.log.answers.size() / 8 * 7);
  EXPECT_EQ(all.answers, used);
  EXPECT_EQ(all.due, 40LL * used + 10LL * all.marked);
  EXPECT_EQ(all.late, 2LL * used);
  EXPECT_EQ(all.dropped, 10LL * all.marked);
  EXPECT_GT(all.marked, 0);
  ASSERT_FALSE(late.thresholds.empty());
  // What nobody saw well was called clearly seen where frames were dropped: finer maps seem needed with them.
  const LateThreshold& first = late.thresholds.front();
  ASSERT_TRUE(first.without.level_x);
  EXPECT_GT(first.with.level_x.value_or(infinity), *first.without.level_x);
  EXPECT_THAT(late_sentence(late), HasSubstr(std::to_string(all.marked) + " of " + std::to_string(used)));
  EXPECT_THAT(late_sentence(late), HasSubstr("marked and used all the same"));
  EXPECT_THAT(late_method(late), HasSubstr("more than two refreshes"));
  const std::vector<CsvTable> tables = late_tables(with, late);
  ASSERT_EQ(tables.size(), 2U);
  for (const CsvTable& table : tables)
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

}  // namespace
}  // namespace seamline::analysis
