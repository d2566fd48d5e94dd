// The small form of `seamline lab evidence coverage`: the table and figure of one population.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/analysis/evidence_folder.h"
#include "tests/analysis/true_joint.h"

namespace seamline::analysis {
namespace {

std::string text_of_table(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Percent of studies, over all sizes, artifacts and quantities.
double mean_coverage(const std::string& table) {
  std::istringstream lines(table);
  double sum = 0;
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream cells_of_line(line);
    for (std::string cell; std::getline(cells_of_line, cell, ',');) cells.push_back(cell);
    if (cells[0] != "joint" || cells[5] == "simultaneous" || cells[5] == "all") continue;
    sum += std::stod(cells[8]);
    ++rows;
  }
  EXPECT_EQ(rows, 5 * 4 * 4);
  return sum / rows;
}

TEST(SmallCoverage, IntervalsHoldTheTruthAndARunGoesOnWhereItStopped) {
  constexpr int studies = 20;
  const std::filesystem::path file = test::evidence_file("true_coverage.csv");
  std::filesystem::remove(file);
  const std::vector<test::TrueWidths> widths = {test::true_widths().front()};
  const std::vector<test::TruePeople> people = {test::true_populations().front()};
  const auto measure = [&] {
    test::continue_true_coverage(file, "joint", studies, test::read_by_joint_model, widths, people);
  };
  measure();
  const std::string table = text_of_table(file);
  EXPECT_GE(mean_coverage(table), 90);  // 95 is wanted; curves of the same people are not independent
  measure();
  EXPECT_EQ(text_of_table(file), table);
}

}  // namespace
}  // namespace seamline::analysis
