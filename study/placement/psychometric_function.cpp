#include "study/placement/psychometric_function.h"

#include <cassert>
#include <cmath>

#include "study/placement/sigmoid_shape.h"

namespace seamline::study {

double response_probability(const PsychometricFunction& function, double level) {
  assert(function.scale > 0);
  assert(function.axis == Axis::linear || (level > 0 && function.threshold > 0));
  const double distance = function.axis == Axis::log2 ? std::log2(level) - std::log2(function.threshold)
                                                      : level - function.threshold;
  const double z = (function.direction == Direction::increasing ? distance : -distance) / function.scale;
  return function.guess + (1 - function.guess - function.lapse) * sigmoid_value(function.sigmoid, z);
}

}  // namespace seamline::study
