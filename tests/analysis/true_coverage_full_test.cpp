// The tables of documentation/evidence/coverage.md on the true crossing: writes true_coverage.csv and
// true_sentences.csv into the tests' output folder (or that of `seamline lab evidence coverage`), and goes on
// there where a run was stopped. Hours of processor time; SEAMLINE_TRUE_STUDIES says how many studies a row
// (2000 unless given).
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/analysis/evidence_folder.h"
#include "tests/analysis/true_halves.h"
#include "tests/analysis/true_joint.h"

namespace seamline::analysis {
namespace {

int true_studies(int unless_given) {
  const char* given = std::getenv("SEAMLINE_TRUE_STUDIES");
  return given == nullptr ? unless_given : std::atoi(given);
}

TEST(TrueCoverage, OfThePapersWay) {
  test::continue_true_coverage(test::evidence_file("true_coverage.csv"), "lines", true_studies(2000),
                               test::read_by_lines);
}

TEST(TrueCoverage, OfTheJointModel) {
  test::continue_true_coverage(test::evidence_file("true_coverage.csv"), "joint", true_studies(2000),
                               test::read_by_joint_model);
}

TEST(TrueCoverage, FalseSentencesOfBothModels) {
  const auto file = test::evidence_file("true_sentences.csv");
  test::continue_false_sentences(file, "ordinal", true_studies(300), {20}, test::said_by_ordinal_model);
  test::continue_false_sentences(file, "joint", true_studies(300), {10, 20, 40}, test::said_by_joint_model);
}

TEST(TrueCoverage, OfTheHalvesOfTheSession) {
  test::write_halves(test::evidence_file("halves.csv"), true_studies(300));
}

}  // namespace
}  // namespace seamline::analysis
