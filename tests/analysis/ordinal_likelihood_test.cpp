// Derivatives against differences of the functions themselves, quadrature against integrals.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "analysis/ordinal/likelihood/fixed_likelihood.h"
#include "analysis/ordinal/likelihood/gauss_hermite.h"
#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/marginal_likelihood.h"
#include "support/text/numbers.h"
#include "tests/analysis/ordinal_people.h"

namespace seamline::analysis {
namespace {

using test::OrdinalPopulation;
using test::simulate_scores;

/// Central difference with one Richardson step: error of order step^4.
Eigen::VectorXd difference(const std::function<Eigen::VectorXd(double)>& function, double step) {
  const Eigen::VectorXd coarse = (function(step) - function(-step)) / (2 * step);
  const Eigen::VectorXd fine = (function(step / 2) - function(-step / 2)) / step;
  return (4 * fine - coarse) / 3;
}

class EveryLink : public ::testing::TestWithParam<Link> {};
INSTANTIATE_TEST_SUITE_P(Ordinal, EveryLink, ::testing::Values(Link::logit, Link::probit),
                         [](const auto& tested) { return std::string(word(tested.param)); });

TEST_P(EveryLink, IntervalTermsAreTheDerivativesOfLogP) {
  for (const auto& [upper, lower] : {std::pair{0.3, -0.8},
                                     {2.5, 1.9},
                                     {-4.0, -4.5},
                                     {6.0, 5.0},
                                     {infinity, 1.2},
                                     {0.4, -infinity},
                                     {infinity, 7.0},
                                     {-7.0, -infinity},
                                     {3.0, -5.0}}) {
    const auto at = [&](double du, double dl) {
      const IntervalTerms t = interval_terms(GetParam(), upper + du, lower + dl);
      Eigen::VectorXd values(6);
      values << t.log_p, t.u, t.l, t.s(), t.ss(), t.sss();
      return values;
    };
    const IntervalTerms terms = interval_terms(GetParam(), upper, lower);
    const Eigen::VectorXd by_u = difference([&](double h) { return at(h, 0); }, 1e-3);
    const Eigen::VectorXd by_l = difference([&](double h) { return at(0, h); }, 1e-3);
    const Eigen::VectorXd by_s = difference([&](double h) { return at(-h, -h); }, 1e-3);
    const double tolerance = 1e-8 * (1 + std::abs(terms.uu) + std::abs(terms.ll));
    if (std::isfinite(upper)) {
      EXPECT_NEAR(by_u[0], terms.u, tolerance);
      EXPECT_NEAR(by_u[1], terms.uu, tolerance);
      EXPECT_NEAR(by_u[2], terms.ul, tolerance);
      EXPECT_NEAR(by_u[4], terms.ssu, 10 * tolerance) << upper << " " << lower;
    }
    if (std::isfinite(lower)) {
      EXPECT_NEAR(by_l[0], terms.l, tolerance);
      EXPECT_NEAR(by_l[2], terms.ll, tolerance);
      EXPECT_NEAR(by_l[4], terms.ssl, 10 * tolerance) << upper << " " << lower;
    }
    EXPECT_NEAR(by_s[0], terms.s(), tolerance);
    EXPECT_NEAR(by_s[3], terms.ss(), tolerance);
    EXPECT_NEAR(by_s[4], terms.sss(), 10 * tolerance);
  }
}

TEST_P(EveryLink, ProbabilitiesOfAllScoresSumToOne) {
  for (const double eta : {-20.0, -3.0, 0.0, 1.7, 20.0}) {
    double sum = std::exp(interval_terms(GetParam(), -1 - eta, -infinity).log_p);
    sum += std::exp(interval_terms(GetParam(), 0.5 - eta, -1 - eta).log_p);
    sum += std::exp(interval_terms(GetParam(), infinity, 0.5 - eta).log_p);
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(OrdinalLink, ProbitIsExactWhereTheProbabilityUnderflows) {
  // log Phi(-50) and the ratio phi / Phi there, by the asymptotic series to many terms (mpmath, 30 digits).
  const IntervalTerms terms = interval_terms(Link::probit, -50, -infinity);
  EXPECT_NEAR(terms.log_p, -1254.8313611394224, 1e-9);
  EXPECT_NEAR(terms.u, 50.01998403830446, 1e-7);
  const IntervalTerms top = interval_terms(Link::probit, infinity, 50);
  EXPECT_NEAR(top.log_p, terms.log_p, 1e-12);
  EXPECT_EQ(interval_terms(Link::logit, 1, 1).log_p, -infinity);
}

TEST(GaussHermite, IntegratesPolynomialsOfDegreeTwiceItsNodesLessOne) {
  for (const int nodes : {1, 2, 5, 9, 15, 40}) {
    const GaussHermite rule = gauss_hermite(nodes);
    double moment = std::sqrt(std::acos(-1.0));
    for (int degree = 0; degree < 2 * nodes && degree <= 24; degree += 2) {
      EXPECT_NEAR((rule.weight.array() * rule.node.array().pow(degree)).sum() / moment, 1, 1e-11);
      moment *= (degree + 1) / 2.0;
    }
  }
}

Eigen::VectorXd somewhere(const OrdinalProblem& problem, bool with_sd) {
  Eigen::VectorXd parameters(problem.cuts() + problem.x.cols() + (with_sd ? 1 : 0));
  for (int c = 0; c < problem.cuts(); ++c) parameters[c] = -1.5 + 0.9 * c;
  for (Eigen::Index j = 0; j < problem.x.cols(); ++j)
    parameters[problem.cuts() + j] = 0.4 - 0.9 * static_cast<double>(j % 2);
  if (with_sd) parameters[parameters.size() - 1] = 0.9;
  return parameters;
}

/// Largest relative departure of analytic from differenced derivatives.
struct Departures {
  double gradient = 0, hessian = 0;
};

Departures departures(const std::function<Evaluation(const Eigen::VectorXd&)>& function,
                      const Eigen::VectorXd& at) {
  const Evaluation analytic = function(at);
  Departures worst;
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const auto along = [&](double h) {
      Eigen::VectorXd moved = at;
      moved[k] += h;
      const Evaluation evaluation = function(moved);
      Eigen::VectorXd values(1 + at.size());
      values << evaluation.value, evaluation.gradient;
      return values;
    };
    const Eigen::VectorXd numeric = difference(along, 1e-3);
    worst.gradient = std::max(worst.gradient, std::abs(numeric[0] - analytic.gradient[k]) /
                                                  (1 + analytic.gradient.cwiseAbs().maxCoeff()));
    worst.hessian =
        std::max(worst.hessian, (numeric.tail(at.size()) - analytic.hessian.col(k)).cwiseAbs().maxCoeff() /
                                    analytic.hessian.cwiseAbs().maxCoeff());
  }
  return worst;
}

TEST_P(EveryLink, FixedGradientAndHessianEqualDifferences) {
  const OrdinalData data = simulate_scores({}, 12, 5);
  const OrdinalProblem problem = prepare(data, false);
  const Departures worst =
      departures([&](const Eigen::VectorXd& at) { return fixed_likelihood(problem, GetParam(), at, 1); },
                 somewhere(problem, false));
  EXPECT_LT(worst.gradient, 1e-9);
  EXPECT_LT(worst.hessian, 1e-9);
}

TEST_P(EveryLink, MarginalGradientIsExactForAnyNumberOfNodes) {
  const OrdinalData data = simulate_scores({}, 9, 6, 1);  // seven answers a person: Laplace is crude here
  const OrdinalProblem problem = prepare(data, true);
  for (const int nodes : {1, 2, 3, 5, 15, 31}) {
    const Quadrature quadrature(nodes);
    const Departures worst = departures(
        [&](const Eigen::VectorXd& at) {
          return marginal_likelihood(problem, GetParam(), quadrature, at, 1);
        },
        somewhere(problem, true));
    EXPECT_LT(worst.gradient, 1e-9) << nodes;
    // Louis' identity holds for the integral, so its distance is the quadrature's error.
    EXPECT_LT(worst.hessian, nodes == 1 ? 2e-2 : nodes < 15 ? 1e-2 : 1e-6) << nodes;
  }
}

TEST_P(EveryLink, AdaptiveQuadratureConvergesToTheIntegral) {
  const OrdinalData data = simulate_scores({}, 4, 7, 1);
  const OrdinalProblem problem = prepare(data, true);
  const Eigen::VectorXd at = somewhere(problem, true);
  // The integral by the trapezium rule on a fine grid, by way of single rows.
  double direct = 0;
  const Eigen::VectorXd x_beta = problem.x * at.segment(problem.cuts(), problem.x.cols());
  for (int p = 0; p < problem.participants(); ++p) {
    double sum = 0;
    for (double v = -9; v <= 9; v += 0.005) {
      double log_p = -0.5 * v * v;
      for (Eigen::Index row = problem.first_row[static_cast<std::size_t>(p)];
           row < problem.first_row[static_cast<std::size_t>(p) + 1]; ++row) {
        const int c = problem.category[static_cast<std::size_t>(row)];
        const double eta = x_beta[row] + 0.9 * v;
        log_p += std::log(cumulative(GetParam(), c < problem.cuts() ? at[c] - eta : infinity) -
                          cumulative(GetParam(), c > 0 ? at[c - 1] - eta : -infinity));
      }
      sum += 0.005 * std::exp(log_p) / std::sqrt(2 * std::acos(-1.0));
    }
    direct += std::log(sum);
  }
  EXPECT_NEAR(marginal_likelihood(problem, GetParam(), Quadrature(31), at, 1).value, direct, 1e-8);
  EXPECT_NEAR(marginal_likelihood(problem, GetParam(), Quadrature(15), at, 1).value, direct, 1e-6);
  const double laplace = marginal_likelihood(problem, GetParam(), Quadrature(1), at, 1).value;
  EXPECT_NEAR(laplace, direct, 0.1);
  EXPECT_GT(std::abs(laplace - direct), 1e-4);  // or the rule above was not tried
}

}  // namespace
}  // namespace seamline::analysis
