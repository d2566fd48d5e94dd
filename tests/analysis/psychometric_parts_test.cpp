// What fits are made of: likelihood terms, samples, sigmoids.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/psychometric/likelihood/binomial_sampler.h"
#include "analysis/psychometric/likelihood/count_terms.h"
#include "study/placement/sigmoid_shape.h"

namespace seamline::analysis {
using namespace study;
namespace {

TEST(PsychometricParts, BetaBinomialSumsAreProbabilitiesAndMeetTheBinomial) {
  for (double eta : {0.05, 0.3, 0.8}) {
    double total = 0, mean = 0, square = 0;
    for (int k = 0; k <= 30; ++k) {
      const double choose = std::exp(std::lgamma(31) - std::lgamma(k + 1) - std::lgamma(31 - k));
      const double p = choose * std::exp(beta_binomial_term(k, 30, 0.3, 0.7, eta).value);
      total += p;
      mean += p * k;
      square += p * k * k;
    }
    EXPECT_NEAR(total, 1, 1e-12);
    EXPECT_NEAR(mean, 9, 1e-10);
    EXPECT_NEAR(square - mean * mean, 30 * 0.21 * (1 + 29 * eta * eta), 1e-9);
  }
  // Long counts go by gamma functions: the same value as the sum.
  const double summed = beta_binomial_term(100, 256, 0.4, 0.6, 0.2).value;
  const double w = 0.04 / 0.96, a = 0.4 / w, b = 0.6 / w;
  const auto lbeta = [](double x, double y) { return std::lgamma(x) + std::lgamma(y) - std::lgamma(x + y); };
  EXPECT_NEAR(summed, lbeta(a + 100, b + 156) - lbeta(a, b), 1e-9);
  EXPECT_NEAR(beta_binomial_term(700, 1000, 0.4, 0.6, 0.2).value, lbeta(a + 700, b + 300) - lbeta(a, b),
              1e-9);
  EXPECT_NEAR(beta_binomial_term(9, 30, 0.3, 0.7, 2e-4).value, binomial_term(9, 30, 0.3, 0.7).value, 1e-5);
}

TEST(PsychometricParts, BinomialSamplesHaveTheirMeanAndVariance) {
  for (const auto& [n, p] : {std::pair{3.0, 0.2}, {60.0, 0.97}, {1e6, 0.4}}) {
    Random random(8);
    double mean = 0, square = 0;
    constexpr int draws = 4000;
    for (int i = 0; i < draws; ++i) {
      const auto k = static_cast<double>(sample_binomial(static_cast<std::int64_t>(n), p, random)) - n * p;
      mean += k / draws;
      square += k * k / draws;
    }
    const double variance = n * p * (1 - p);
    EXPECT_NEAR(mean, 0, 4 * std::sqrt(variance / draws));
    EXPECT_NEAR(square / variance, 1, 0.15);
  }
}

TEST(PsychometricParts, SigmoidsQuantilesAndDerivatives) {
  for (const Sigmoid sigmoid : every_sigmoid)
    for (double share : {1e-6, 0.05, 0.5, 0.8, 0.999}) {
      const double z = sigmoid_quantile(sigmoid, share), h = 1e-5;
      const SigmoidPoint at = sigmoid_point(sigmoid, z);
      EXPECT_NEAR(at.below, share, 1e-12);
      EXPECT_NEAR(at.below, sigmoid_value(sigmoid, z), 1e-14);
      EXPECT_NEAR(at.below + at.above, 1, 1e-15);
      const SigmoidPoint up = sigmoid_point(sigmoid, z + h), down = sigmoid_point(sigmoid, z - h);
      EXPECT_NEAR(at.density, (up.below - down.below) / (2 * h), 1e-7);
      EXPECT_NEAR(at.density_slope, (up.density - down.density) / (2 * h), 1e-7);
    }
}

}  // namespace
}  // namespace seamline::analysis
