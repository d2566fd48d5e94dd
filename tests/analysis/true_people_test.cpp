// The people of whom true thresholds are known are as their truth says: a large sample of their answers has
// the means that integration gives, and the crossings of documentation/evidence/coverage.md are where those
// means cross.
#include "tests/analysis/true_people.h"

#include <gtest/gtest.h>

#include "study/observers/observer.h"

namespace seamline::analysis {
namespace {

using test::true_mean;
using test::TruePeople;

TEST(TruePeople, AnswerAsTheirTruthSays) {
  const std::vector<double> level_x = {6, 7, 8, 9, 10, 11, 12};
  for (const TruePeople& people : test::true_populations()) {
    constexpr int count = 1500;
    std::array<double, 7> sum{}, square{};
    for (const auto& person : test::answer_as_people(people, count, level_x, 7)) {
      std::array<double, 7> mean{};  // of curve 2
      for (const test::TrueTrial& trial : person)
        if (trial.curve == 2) mean[static_cast<std::size_t>(trial.level)] += trial.score() / 3.0;
      for (std::size_t w = 0; w < level_x.size(); ++w) {
        sum[w] += mean[w];
        square[w] += mean[w] * mean[w];
      }
    }
    for (std::size_t w = 0; w < level_x.size(); ++w) {
      const double mean = sum[w] / count;
      const double sem = std::sqrt((square[w] / count - mean * mean) / count);
      const double truth = true_mean(people, level_x[w] - std::log2(people.midpoint_px[2]), false);
      EXPECT_NEAR(mean, truth, 4 * sem + 1e-3) << people.name << " at " << level_x[w];
    }
  }
}

TEST(TruePeople, ByDefaultAreTheThresholdObserversOfAStudy) {
  for (const double width_px : {100.0, 300.0, 512.0, 1000.0, 3000.0})
    EXPECT_NEAR(true_mean({}, std::log2(width_px / 300), false),
                study::expected_noticeability({}, Artifact::receiver, width_px), 1e-7);
}

TEST(TruePeople, CrossTheLevelWhereTheirTruthSays) {
  for (const TruePeople& people : test::true_populations())
    for (const bool corrected : {false, true})
      for (const double level : {0.5, 1.0}) {
        const double octaves = test::true_crossing_octaves(people, level, corrected);
        EXPECT_NEAR(true_mean(people, octaves, corrected), level, 1e-7) << people.name;
      }
  EXPECT_EQ(test::true_crossing_octaves({.guess_rating = {0, 1, 0, 0}}, 0.5, false), INFINITY);
}

TEST(TruePeople, OfASmallerStudyAreTheFirstOfALarger) {
  const std::vector<double> level_x = {6, 8, 10};
  const TruePeople people = test::true_populations().back();
  const auto few = test::answer_as_people(people, 2, level_x, 3),
             many = test::answer_as_people(people, 5, level_x, 3);
  for (std::size_t p = 0; p < few.size(); ++p)
    for (std::size_t t = 0; t < few[p].size(); ++t) {
      EXPECT_EQ(few[p][t].score(), many[p][t].score());
      EXPECT_EQ(few[p][t].curve, many[p][t].curve);
    }
}

}  // namespace
}  // namespace seamline::analysis
