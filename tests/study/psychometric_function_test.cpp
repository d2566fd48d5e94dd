#include "study/placement/psychometric_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/placement/sigmoid_shape.h"

namespace seamline::study {
namespace {

TEST(Sigmoid, EveryOneHasAWordOfItsOwnThatIsReadBack) {
  for (const Sigmoid sigmoid : every_sigmoid) EXPECT_EQ(sigmoid_from_word(word(sigmoid)), sigmoid);
  EXPECT_EQ(sigmoid_from_word("cauchy"), std::nullopt);
  EXPECT_EQ(sigmoid_from_word(""), std::nullopt);
}

/// The three ways to write a sigmoid down say the same.
TEST(Sigmoid, ValuePointAndQuantileAgree) {
  for (const Sigmoid sigmoid : every_sigmoid)
    for (const double z : {-3.0, -1.0, -0.25, 0.0, 0.5, 1.0}) {
      const double value = sigmoid_value(sigmoid, z);
      const SigmoidPoint point = sigmoid_point(sigmoid, z);
      EXPECT_NEAR(point.below, value, 1e-15);
      EXPECT_NEAR(point.above, 1 - value, 1e-15);
      EXPECT_NEAR(sigmoid_quantile(sigmoid, value), z, 1e-12);
      const double h = 1e-5;
      EXPECT_NEAR((sigmoid_value(sigmoid, z + h) - sigmoid_value(sigmoid, z - h)) / (2 * h), point.density,
                  1e-9);
    }
}

TEST(PsychometricFunction, EverySigmoidIsHalfAtZeroAndRisesFrom0To1) {
  for (const Sigmoid sigmoid : every_sigmoid) {
    EXPECT_NEAR(sigmoid_value(sigmoid, 0), 0.5, 1e-15);
    for (double z = -8; z < 8; z += 0.25)
      EXPECT_LE(sigmoid_value(sigmoid, z), sigmoid_value(sigmoid, z + 0.25));
    EXPECT_EQ(sigmoid_value(sigmoid, -1e4), 0);
    EXPECT_EQ(sigmoid_value(sigmoid, 1e4), 1);
    EXPECT_TRUE(std::isnan(sigmoid_value(sigmoid, std::nan(""))));
  }
}

TEST(PsychometricFunction, KnownValues) {
  EXPECT_NEAR(sigmoid_value(Sigmoid::logistic, 1), 0.7310585786300049, 1e-15);
  EXPECT_NEAR(sigmoid_value(Sigmoid::normal, 1), 0.8413447460685429, 1e-15);
  EXPECT_NEAR(sigmoid_value(Sigmoid::gumbel, -std::log(std::log(2.0))), 1 - std::exp(-1.0), 1e-15);
}

TEST(PsychometricFunction, GuessAndLapseAreTheAsymptotesInBothDirections) {
  for (const Sigmoid sigmoid : every_sigmoid)
    for (const Direction direction : {Direction::increasing, Direction::decreasing}) {
      const PsychometricFunction psi{.sigmoid = sigmoid,
                                     .axis = Axis::log2,
                                     .direction = direction,
                                     .threshold = 256,
                                     .scale = 0.5,
                                     .guess = 1.0 / 3,
                                     .lapse = 0.04};
      const bool rises = direction == Direction::increasing;
      EXPECT_NEAR(response_probability(psi, rises ? 1e-9 : 1e12), 1.0 / 3, 1e-9);
      EXPECT_NEAR(response_probability(psi, rises ? 1e12 : 1e-9), 0.96, 1e-9);
      EXPECT_NEAR(response_probability(psi, 256), 1.0 / 3 + (1 - 1.0 / 3 - 0.04) / 2, 1e-12);
    }
}

TEST(PsychometricFunction, Log2AxisIsTheLinearAxisOfOctaves) {
  const PsychometricFunction octaves{.axis = Axis::log2, .threshold = 300, .scale = 0.7};
  PsychometricFunction linear = octaves;
  linear.axis = Axis::linear;
  linear.threshold = std::log2(300);
  for (double width_px = 64; width_px <= 4096; width_px *= 1.3)
    EXPECT_NEAR(response_probability(octaves, width_px), response_probability(linear, std::log2(width_px)),
                1e-14);
}

}  // namespace
}  // namespace seamline::study
