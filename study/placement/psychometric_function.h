#pragma once
#include "stimuli/definition/axis.h"
#include "stimuli/definition/methods/sigmoid.h"

namespace seamline::study {

using seamline::Axis;
using seamline::Direction;

/// The probability of a response as a function of a level x (Wichmann and Hill 2001):
///
///     psi(x) = guess + (1 - guess - lapse) F(d (a(x) - a(threshold)) / scale)
///
/// with a(x) = x or log2 x, and d = +1 or -1 for increasing and decreasing.
struct PsychometricFunction {
  Sigmoid sigmoid = Sigmoid::logistic;
  Axis axis = Axis::log2;
  Direction direction = Direction::decreasing;
  double threshold = 1.0;  ///< level where F = 0.5, in the level's own unit
  double scale = 1.0;      ///< > 0, on the axis: octaves when it is log2
  double guess = 0.0;
  double lapse = 0.0;
};

/// psi(x). On a log2 axis the level and the threshold are positive.
[[nodiscard]] double response_probability(const PsychometricFunction& function, double level);

}  // namespace seamline::study
