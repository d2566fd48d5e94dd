// The tables of documentation/evidence/replication.md: how often `analyze --published` says "agrees" and
// "differs" of studies whose truth is known. Writes replication.csv and replication_orders.csv into the
// tests' output folder (or that of `seamline lab evidence replication`). SEAMLINE_TRUE_STUDIES: studies a row
// (400).
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/analysis/evidence_folder.h"
#include "tests/analysis/planted_replications.h"

namespace seamline::analysis {
namespace {

TEST(PlantedReplications, AgreeAndDifferAsOftenAsPromised) {
  const char* given = std::getenv("SEAMLINE_TRUE_STUDIES");
  const int studies = given == nullptr ? 200 : std::atoi(given);
  std::ofstream rates(test::evidence_file("replication.csv")),
      orders(test::evidence_file("replication_orders.csv"));
  rates << test::replication_header;
  orders << test::replication_orders_header;
  for (const test::TruePeople& people : test::true_populations()) {
    // Their floor hides the paper's PT (guesses), or their thresholds are made to lie at the edge (edge).
    if (people.name == "guesses" || people.name == "edge") continue;
    const std::vector<test::VerdictTally> tallies =
        test::write_replications(test::people_of_the_paper(people), 20, studies, rates, orders);
    // The thresholds of one study are not independent: a study's share has at most this standard error.
    const double error = 100 * std::sqrt(0.05 * 0.95 / studies);
    EXPECT_LE(tallies[0].percent(tallies[0].differs), 5 + 3 * error) << people.name;
    EXPECT_LE(tallies[2].percent(tallies[2].agrees), 5 + 3 * error) << people.name;
    EXPECT_GE(tallies[4].percent(tallies[4].differs + tallies[4].no_number), 99) << people.name;
  }
}

}  // namespace
}  // namespace seamline::analysis
