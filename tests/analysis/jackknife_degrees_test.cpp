// Degrees of freedom of a variance over people, beside Welch's and those of a normal sample.
#include "analysis/statistics/jackknife_degrees.h"

#include <gtest/gtest.h>

namespace seamline::analysis {
namespace {

Eigen::VectorXd of(std::vector<double> values) {
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(JackknifeDegrees, WithoutHeavyTailsAreThoseOfTheSample) {
  EXPECT_DOUBLE_EQ(jackknife_degrees(of({-1, 1, -1, 1, -1, 1, -1, 1})), 7);
}

TEST(JackknifeDegrees, OfGroupsAreWelchs) {
  const Eigen::VectorXd values = of({-1, 1, -1, 1, -3, 3, -3, 3, -3, 3});
  // Sums of squares 4 of four people, 54 of six.
  EXPECT_NEAR(jackknife_degrees(values, {0, 0, 0, 0, 1, 1, 1, 1, 1, 1}), 58.0 * 58 / (16.0 / 3 + 2916.0 / 5),
              1e-12);
}

TEST(JackknifeDegrees, AreFewWhereOnePersonCarriesTheNumber) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(20);
  values[7] = 1;
  const double one = jackknife_degrees(values);
  EXPECT_LT(one, 3);
  EXPECT_GE(one, 2);
  // The same in one of two groups.
  std::vector<int> group_of(20, 0);
  for (std::size_t p = 10; p < group_of.size(); ++p) group_of[p] = 1;
  EXPECT_LT(jackknife_degrees(values, group_of), 5);
}

TEST(JackknifeDegrees, OfPeopleWhoDoNotDifferAreThoseOfTheSample) {
  EXPECT_DOUBLE_EQ(jackknife_degrees(Eigen::VectorXd::Constant(6, 2.5)), 5);
}

}  // namespace
}  // namespace seamline::analysis
