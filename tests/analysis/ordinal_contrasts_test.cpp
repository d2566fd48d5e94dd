// Adjusted p values against published tables, independent formulas and simulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/ordinal/contrasts/contrasts_apart.h"
#include "analysis/ordinal/contrasts/max_t.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::analysis {
namespace {

using ::testing::HasSubstr;

/// Correlation of all pairwise differences of k independent means.
Eigen::MatrixXd all_pairs(int k) {
  std::vector<Eigen::VectorXd> rows;
  for (int i = 0; i < k; ++i)
    for (int j = i + 1; j < k; ++j) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(k);
      row[i] = std::sqrt(0.5);
      row[j] = -std::sqrt(0.5);
      rows.push_back(row);
    }
  Eigen::MatrixXd all(static_cast<Eigen::Index>(rows.size()), k);
  for (std::size_t r = 0; r < rows.size(); ++r) all.row(static_cast<Eigen::Index>(r)) = rows[r];
  return all * all.transpose();
}

TEST(MaxAbsT, EqualsTukeysTable) {
  // Upper 5 % points of the studentized range q(k, df), divided by sqrt 2.
  struct Point {
    int k;
    double df, q;
  };
  for (const Point& point : {Point{3, infinity, 3.314},
                             {4, infinity, 3.633},
                             {5, infinity, 3.858},
                             {3, 20, 3.578},
                             {4, 20, 3.958},
                             {3, 10, 3.877},
                             {6, 20, 4.445}}) {
    const MaxAbsT distribution(all_pairs(point.k), point.df);
    EXPECT_NEAR(distribution.critical(0.05), point.q / std::sqrt(2.0), 0.01) << point.k << " " << point.df;
    EXPECT_NEAR(distribution.tail(point.q / std::sqrt(2.0)), 0.05, 1e-3) << point.k << " " << point.df;
  }
}

TEST(MaxAbsT, EqualsDunnettsTable) {
  // Two-sided 5 % points, comparisons with one control, correlation 1/2.
  for (const auto& [k, df, point] :
       {std::tuple{2, 20.0, 2.38}, {3, 20.0, 2.54}, {5, 20.0, 2.73}, {3, infinity, 2.35}}) {
    Eigen::MatrixXd correlation = Eigen::MatrixXd::Constant(k, k, 0.5);
    correlation.diagonal().setOnes();
    EXPECT_NEAR(MaxAbsT(correlation, df).critical(0.05), point, 0.01) << k;
  }
}

TEST(MaxAbsT, IndependentAndIdenticalContrasts) {
  const MaxAbsT independent(Eigen::MatrixXd::Identity(8, 8), infinity);
  for (const double t : {1.0, 2.0, 3.0, 4.5}) {
    const double one = two_sided_tail(t, infinity);
    const double sidak = -std::expm1(8 * std::log1p(-one));
    EXPECT_NEAR(independent.tail(t), sidak, 5e-3 * sidak + 1e-12) << t;
  }
  const MaxAbsT identical(Eigen::MatrixXd::Ones(4, 4), 12);
  EXPECT_NEAR(identical.tail(2.5), two_sided_tail(2.5, 12), 1e-9);
  const MaxAbsT alone(Eigen::MatrixXd::Ones(1, 1), 7);
  EXPECT_NEAR(alone.critical(0.05), 2.364624, 1e-5);
}

TEST(MaxAbsT, EqualsSimulationWithUnevenCorrelation) {
  Random random(3);
  Eigen::MatrixXd root(5, 3);
  for (Eigen::Index i = 0; i < 5; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) root(i, j) = random.normal();
  root.rowwise().normalize();
  const MaxAbsT distribution(root * root.transpose(), infinity);
  const double t = distribution.critical(0.05);
  int beyond = 0;
  constexpr int draws = 200000;
  for (int draw = 0; draw < draws; ++draw) {
    const Eigen::Vector3d g(random.normal(), random.normal(), random.normal());
    beyond += (root * g).cwiseAbs().maxCoeff() > t ? 1 : 0;
  }
  EXPECT_NEAR(beyond / static_cast<double>(draws), 0.05, 3.5 * std::sqrt(0.05 * 0.95 / draws) + 5e-4);
}

TEST(Holm, StepsDown) {
  const std::vector<double> adjusted = holm_adjusted({0.01, 0.04, nan, 0.03, 0.005});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.03);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.06);
  EXPECT_TRUE(std::isnan(adjusted[2]));
  EXPECT_DOUBLE_EQ(adjusted[3], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[4], 0.02);
  EXPECT_EQ(holm_adjusted({0.9, 0.8}), (std::vector<double>{1, 1}));
}

ContrastFamily pairs_of_three() {
  ContrastFamily family{.question = "Do they differ?", .contrasts = {}, .degrees_of_freedom = 19};
  const auto add = [&](const std::string& name, double a, double b, double c) {
    family.contrasts.push_back({.name = name,
                                .weights = Eigen::Vector3d(a, b, c),
                                .more = name + " is more",
                                .less = name + " is less",
                                .undecided = name + " is open"});
  };
  add("b - a", -1, 1, 0);
  add("c - a", -1, 0, 1);
  add("c - b", 0, -1, 1);
  return family;
}

TEST(Contrasts, IntervalsAndAdjustedPAgree) {
  const Eigen::Vector3d coefficients(0, 1.1, -0.2);
  const Eigen::MatrixXd covariance = 0.08 * Eigen::Matrix3d::Identity();
  const ContrastTable table =
      test_contrasts(pairs_of_three(), coefficients, covariance, Correction::single_step);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_DOUBLE_EQ(table.rows[0].estimate, 1.1);
  EXPECT_DOUBLE_EQ(table.rows[0].standard_error, 0.4);
  EXPECT_EQ(table.rows[0].verdict, ContrastVerdict::differs);
  EXPECT_EQ(table.rows[1].verdict, ContrastVerdict::not_shown);
  EXPECT_EQ(table.rows[2].verdict, ContrastVerdict::differs);
  EXPECT_THAT(table.rows[0].conclusion, HasSubstr("b - a is more (adjusted p = 0.0"));
  EXPECT_THAT(table.rows[1].conclusion, HasSubstr("c - a is open"));
  EXPECT_THAT(table.rows[2].conclusion, HasSubstr("c - b is less"));
  for (const ContrastRow& row : table.rows) {
    const bool excludes_zero = row.ci95_low > 0 || row.ci95_high < 0;
    EXPECT_EQ(excludes_zero, row.verdict == ContrastVerdict::differs);
    EXPECT_GT(row.adjusted_p, row.p);
    EXPECT_LT(row.adjusted_p, std::min(1.0, 3 * row.p));
  }
  // Hotelling by hand: the two independent contrasts' quadratic form.
  EXPECT_EQ(table.joint_contrasts, 2);
  const double mean = 0.3;
  const double squared = (std::pow(0 - mean, 2) + std::pow(1.1 - mean, 2) + std::pow(-0.2 - mean, 2)) / 0.08;
  const double f = squared * 18 / (19 * 2);
  EXPECT_NEAR(table.joint_p.value(), std::pow(1 + 2 * f / 18, -9), 1e-9);  // F with 2 and 18 degrees, exactly

  const ContrastTable holm = test_contrasts(pairs_of_three(), coefficients, covariance, Correction::holm);
  EXPECT_DOUBLE_EQ(holm.rows[2].adjusted_p, 3 * holm.rows[2].p);
  EXPECT_LT(holm.rows[0].ci95_high - holm.rows[0].ci95_low, table.rows[0].ci95_high - table.rows[0].ci95_low);
}

TEST(Contrasts, PartsOfAFamilyAreAdjustedTogether) {
  const Eigen::MatrixXd covariance = 0.08 * Eigen::Matrix3d::Identity();
  const std::vector<EstimatedContrasts> parts = {
      {.family = pairs_of_three(), .coefficients = Eigen::Vector3d(0, 1.1, -0.2), .covariance = covariance},
      {.family = pairs_of_three(), .coefficients = Eigen::Vector3d(0, 0.5, 1.6), .covariance = covariance},
      {.family = pairs_of_three(), .coefficients = Eigen::Vector3d(0, 9, 9), .covariance = {}}};
  const ContrastTable table = test_contrasts_apart(parts);
  EXPECT_EQ(table.correction, Correction::holm);
  EXPECT_FALSE(table.joint_p.has_value());
  ASSERT_EQ(table.rows.size(), 9u);
  std::vector<double> p, adjusted;
  for (const ContrastRow& row : table.rows) {
    p.push_back(row.p);
    adjusted.push_back(row.adjusted_p);
  }
  for (std::size_t i = 0; i < 9; ++i) {
    const ContrastRow& row = table.rows[i];
    if (i >= 6) {  // its model says nothing, and does not count
      EXPECT_EQ(row.verdict, ContrastVerdict::not_estimable);
      continue;
    }
    EXPECT_EQ(row.adjusted_p, holm_adjusted(p)[i]);
    EXPECT_EQ(row.verdict == ContrastVerdict::differs, row.adjusted_p < 0.05);
    // Simultaneous intervals of Bonferroni leave 0 out where six times p is below 5 %.
    EXPECT_EQ(row.ci95_low > 0 || row.ci95_high < 0, 6 * row.p < 0.05) << row.name;
  }
  const ContrastTable alone = test_contrasts_apart({parts.data(), 1});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(alone.rows[i].estimate, table.rows[i].estimate);
}

TEST(Contrasts, VeryLargeFamiliesAreAdjustedByHolm) {
  ContrastFamily family{.question = "Do they differ?", .contrasts = {}, .degrees_of_freedom = 19};
  for (int i = 0; i <= most_joint_contrasts; ++i)
    family.contrasts.push_back({.name = "a",
                                .weights = Eigen::Vector2d(-1, 1 + 1e-3 * i),
                                .more = "more",
                                .less = "less",
                                .undecided = "open"});
  const ContrastTable table = test_contrasts(family, Eigen::Vector2d(0, 1), 0.1 * Eigen::Matrix2d::Identity(),
                                             Correction::single_step);
  EXPECT_EQ(table.correction, Correction::holm);
  EXPECT_EQ(table.rows.size(), family.contrasts.size());
  EXPECT_GE(table.rows[0].adjusted_p, table.rows[0].p);
}

TEST(Contrasts, WithoutVarianceNothingIsEstimable) {
  Eigen::Matrix3d covariance = 0.08 * Eigen::Matrix3d::Identity();
  for (const Eigen::MatrixXd& none : {Eigen::MatrixXd(), Eigen::MatrixXd(Eigen::Matrix3d::Zero())}) {
    const ContrastTable table =
        test_contrasts(pairs_of_three(), Eigen::Vector3d(0, 1, 2), none, Correction::single_step);
    for (const ContrastRow& row : table.rows) {
      EXPECT_EQ(row.verdict, ContrastVerdict::not_estimable);
      EXPECT_TRUE(std::isnan(row.estimate) && std::isnan(row.adjusted_p) && std::isnan(row.ci95_low));
    }
    EXPECT_FALSE(table.joint_p.has_value());
  }
  covariance(0, 0) = covariance(1, 1) = 0;  // one of three is left out, the others are tested
  const ContrastTable table =
      test_contrasts(pairs_of_three(), Eigen::Vector3d(0, 1, 2), covariance, Correction::single_step);
  EXPECT_EQ(table.rows[0].verdict, ContrastVerdict::not_estimable);
  EXPECT_EQ(table.rows[1].verdict, ContrastVerdict::differs);
}

}  // namespace
}  // namespace seamline::analysis
