// Whether the intervals of the repository's studies of conditions and of other levels hold what their people
// were planted with: the table of documentation/evidence/coverage.md.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/analysis/condition_people.h"

namespace seamline::analysis {
namespace {

constexpr int people = 20;
constexpr int studies = 50;
constexpr int replicates = 1000;

/// 50 studies say of a cell only that it is not far off: with a true share of 93 %, fewer than 40 are seen in
/// one of 700 cells.
void measure(const test::PlantedStudy& study, const char* name) {
  const test::Coverage found = test::coverage_of(study, people, studies, replicates);
  for (const test::CellCoverage& cell : found.cells) {
    const std::string of = std::string(name) + " " + std::string(word(cell.artifact)) + " " + cell.condition;
    std::printf("%s %s: %d of %d, open %d, none %d\n", of.c_str(), cell.quantity.c_str(), cell.tally.held,
                cell.tally.studies, cell.tally.open, studies - cell.tally.estimated);
    ASSERT_EQ(cell.tally.studies, studies) << of << cell.quantity << " lies beyond the study's levels";
    EXPECT_GE(cell.tally.held, 40) << of << cell.quantity;
    // Planted well within the levels, so that the study's example shows thresholds.
    EXPECT_GE(cell.tally.estimated, 45) << of << cell.quantity;
  }
  if (found.differences.studies > 0)
    std::printf("%s differences: %.1f %%\n", name, found.differences.percent());
  EXPECT_GE(found.share_held(), 0.91);
}

TEST(ConditionCoverage, OfSoftLight) {
  measure(test::soft_light_people(), "soft_light");
}

TEST(ConditionCoverage, OfMeshTolerance) {
  measure(test::mesh_tolerance_people(), "mesh_tolerance");
}

}  // namespace
}  // namespace seamline::analysis
