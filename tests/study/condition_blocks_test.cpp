// Conditions in blocks, in the order of a balanced Latin square.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "study/log/log.h"
#include "study/running/simulation.h"
#include "study/trials/condition_blocks.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

TEST(ConditionBlocks, EveryTreatmentStandsEverywhereAndFollowsEveryOtherEquallyOften) {
  for (int count = 2; count <= 9; ++count) {
    std::map<std::pair<int, int>, int> at_place, after;
    const int rows = williams_rows(count);
    for (int row = 0; row < rows; ++row) {
      const std::vector<int> order = williams_row(count, row);
      EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), static_cast<std::size_t>(count));
      EXPECT_EQ(order, williams_row(count, row + rows));
      for (int place = 0; place < count; ++place) {
        ++at_place[{order[static_cast<std::size_t>(place)], place}];
        if (place > 0)
          ++after[{order[static_cast<std::size_t>(place - 1)], order[static_cast<std::size_t>(place)]}];
      }
    }
    ASSERT_EQ(at_place.size(), static_cast<std::size_t>(count * count));
    ASSERT_EQ(after.size(), static_cast<std::size_t>(count * (count - 1)));
    for (const auto& [what, times] : at_place) EXPECT_EQ(times, rows / count) << count;
    for (const auto& [what, times] : after) EXPECT_EQ(times, rows / count) << count;
  }
}

TEST(ConditionBlocks, TheSquareOfFourIsThePublishedOne) {
  EXPECT_EQ(williams_row(4, 0), (std::vector{0, 1, 3, 2}));
  EXPECT_EQ(williams_row(4, 1), (std::vector{1, 2, 0, 3}));
  EXPECT_EQ(williams_row(4, 2), (std::vector{2, 3, 1, 0}));
  EXPECT_EQ(williams_row(4, 3), (std::vector{3, 0, 2, 1}));
}

TEST(ConditionBlocks, ASessionHasABlockOfEachConditionAndAllItsRepetitions) {
  const TemporaryFolder folder;
  std::string text = study_text("blocks", "64, 512");
  text.insert(text.find("[session]"),
              "[[condition]]\nname = \"hard\"\n[[condition]]\nname = \"soft\"\nisolation = \"mask\"\n");
  (void)write_set_of_text(folder / "set", text +
                                              "[task]\nkind = \"pair\"\nrepetitions = 2\nblocks = "
                                              "\"condition\"\n");
  run_simulated_study({.set_folder = folder / "set",
                       .log = folder / "log",
                       .observer = ObserverKind::threshold,
                       .count = 4,
                       .seed = 3});
  std::map<std::string, std::vector<std::string>> blocks;
  std::map<std::string, std::map<std::string, int>> shown;
  for (const Answer& answer : read_log(folder / "log").answers) {
    std::vector<std::string>& of = blocks[answer.participant];
    if (of.empty() || of.back() != answer.condition) of.push_back(answer.condition);
    ++shown[answer.participant][answer.stimulus_id];
  }
  std::map<std::string, int> first;
  for (const auto& [code, of] : blocks) {
    ASSERT_EQ(of.size(), 2U) << code;
    ++first[of.front()];
    EXPECT_EQ(shown[code].size(), 48U);
    for (const auto& [id, times] : shown[code]) EXPECT_EQ(times, 2) << id;
  }
  EXPECT_EQ(first, (std::map<std::string, int>{{"hard", 2}, {"soft", 2}}));
}

}  // namespace
}  // namespace seamline::study
