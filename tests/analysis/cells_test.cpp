#include "analysis/scores/cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/text/error.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::analysis {
namespace {

using namespace study;
using test::answer;
using test::person;

NoticeabilityData averaged(const LogContents& log, bool include_pilot = false) {
  return average_answers(log, select_participants(log, include_pilot));
}

/// Two people, two objects, one width. a: 4 and 2 (mean 3); b: wrong and 1, repeated as 3 (mean of 0 and 2:
/// 1).
LogContents small_log() {
  LogContents log;
  log.participants = {person("a"), person("b")};
  log.answers = {answer("a", 64, 1, 1, 4), answer("a", 64, 2, 2, 2), answer("b", 64, 1, 3, 4),
                 answer("b", 64, 2, 2, 1), answer("b", 64, 2, 2, 3)};
  return log;
}

TEST(Cells, AverageObjectsWithinAPersonFirst) {
  const NoticeabilityData data = averaged(small_log());
  ASSERT_EQ(data.artifacts.size(), 1U);
  const CellMean& cell = data.artifacts[0].cells.at(0);
  EXPECT_EQ(cell.n, 2);
  EXPECT_DOUBLE_EQ(cell.mean, 2);        // of 3 and 1, not of the five answers
  EXPECT_DOUBLE_EQ(cell.sem, 1);         // SD sqrt(2) over sqrt(2)
  EXPECT_DOUBLE_EQ(cell.correct, 0.75);  // of 1 and 1/2
  EXPECT_DOUBLE_EQ(data.artifacts[0].noticeability(1, 0), 1);
}

TEST(Cells, OfOneObject) {
  const NoticeabilityData data = averaged(small_log());
  ASSERT_EQ(data.objects.size(), 2U);
  EXPECT_EQ(data.objects[0].object_index, 1);
  EXPECT_DOUBLE_EQ(data.objects[0].cells.at(0).mean, 2);  // 4 and 0
  EXPECT_DOUBLE_EQ(data.objects[1].cells.at(0).mean, 2);  // 2 and the mean of 1 and 3
  EXPECT_DOUBLE_EQ(data.objects[0].cells.at(0).correct, 0.5);
}

TEST(Cells, StandardErrorByHand) {
  const CellMean cell = mean_over_participants({1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(cell.mean, 2.5);
  EXPECT_DOUBLE_EQ(cell.sem, std::sqrt(5.0 / 3 / 4));
  EXPECT_TRUE(std::isnan(mean_over_participants({3}).sem));
}

TEST(Cells, EveryoneLeftOutIsCounted) {
  LogContents log = small_log();
  log.participants.push_back(person("pilot"));
  log.participants.back().pilot = true;
  log.participants.push_back(person("excluded"));
  log.participants.back().excluded = true;
  log.participants.push_back(person("half"));
  log.participants.back().completed = false;
  for (const char* code : {"pilot", "excluded", "half"}) log.answers.push_back(answer(code, 64, 1, 1, 4));
  const ParticipantCounts counts = count_participants(select_participants(log, false));
  EXPECT_EQ(counts.in_log, 5);
  EXPECT_EQ(counts.used, 2);
  EXPECT_EQ(counts.pilot, 1);
  EXPECT_EQ(counts.excluded, 1);
  EXPECT_EQ(counts.incomplete, 1);
  EXPECT_EQ(averaged(log).artifacts[0].cells[0].n, 2);
  EXPECT_EQ(averaged(log, true).artifacts[0].cells[0].n, 3);
}

TEST(Cells, SomeoneWithoutAWidthStaysInTheOtherMeans) {
  LogContents log = small_log();
  log.answers.push_back(answer("a", 128, 1, 1, 2));
  const ArtifactScores scores = averaged(log).artifacts.at(0);
  EXPECT_EQ(scores.people, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(scores.incomplete, std::vector<std::string>{"b"});
  EXPECT_EQ(scores.cells[0].n, 2);
  EXPECT_DOUBLE_EQ(scores.cells[0].mean, 2);  // as without the other width
  EXPECT_EQ(scores.cells[1].n, 1);
  EXPECT_DOUBLE_EQ(scores.cells[1].mean, 2);
  EXPECT_TRUE(std::isnan(scores.noticeability(1, 1)));
  EXPECT_EQ(people_at_levels(scores), (std::pair{1, 2}));
}

TEST(Cells, NobodyToUseIsTheUsersError) {
  LogContents log = small_log();
  for (ParticipantRecord& record : log.participants) record.completed = false;
  EXPECT_THROW(static_cast<void>(averaged(log)), InputError);
}

TEST(Cells, AnswerOfAStrangerIsTheUsersError) {
  LogContents log = small_log();
  log.answers.push_back(answer("stranger", 64, 1, 1, 1));
  EXPECT_THROW(static_cast<void>(averaged(log)), InputError);
}

}  // namespace
}  // namespace seamline::analysis
