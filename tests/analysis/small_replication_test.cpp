// The small form of `seamline lab evidence replication`: 24 studies of one population.
#include <gtest/gtest.h>

#include "tests/analysis/evidence_folder.h"
#include "tests/analysis/planted_replications.h"

namespace seamline::analysis {
namespace {

TEST(SmallReplication, PlantedThresholdsAgreeAndDifferAsPromised) {
  constexpr int studies = 24;
  std::ofstream rates(test::evidence_file("replication.csv")),
      orders(test::evidence_file("replication_orders.csv"));
  rates << test::replication_header;
  orders << test::replication_orders_header;
  const test::TruePeople people = test::people_of_the_paper(test::true_populations().front());
  const std::vector<test::VerdictTally> tallies =
      test::write_replications(people, 20, studies, rates, orders);
  // Of 24 studies with 5 % each more than 4 come once in a hundred; thresholds of one study hang together.
  EXPECT_LE(tallies[0].differs, 4 * tallies[0].all / studies);
  EXPECT_LE(tallies[2].agrees, 4 * tallies[2].all / studies);
  EXPECT_EQ(tallies[4].differs + tallies[4].no_number, tallies[4].all);
  EXPECT_LE(tallies[4].no_number, tallies[4].all / 20);
  EXPECT_GT(tallies[3].differs, tallies[1].differs);
}

/// Half the length of an interval and a true difference say how often a verdict comes: by hand for t of 19.
TEST(SmallReplication, WhatIsPromisedIsTwoOneSidedTests) {
  const test::PromisedVerdicts at = test::promised_verdicts(0, 1e-6, 0.5, 20);
  EXPECT_NEAR(at.agrees, 100, 1e-9);
  EXPECT_NEAR(at.differs, 0, 1e-9);
  const test::PromisedVerdicts margin = test::promised_verdicts(0.5, 0.2, 0.5, 20);
  EXPECT_NEAR(margin.agrees, 5, 0.9);  // normal estimates beside a limit of t: 100 P(z < -1.729) = 4.19
  EXPECT_GT(margin.differs, 90);
  const test::PromisedVerdicts wide = test::promised_verdicts(0, 1, 0.5, 20);
  EXPECT_EQ(wide.agrees, 0);
  EXPECT_NEAR(wide.differs, 5, 1.4);  // 2 P(z < -2.093) = 3.63
}

}  // namespace
}  // namespace seamline::analysis
