#pragma once
#include "stimuli/definition/methods/sigmoid.h"

namespace seamline::study {

/// A sigmoid F at one place z, with both tails exact to the last bits.
struct SigmoidPoint {
  double below = 0;          ///< F(z)
  double above = 0;          ///< 1 - F(z)
  double density = 0;        ///< F'(z)
  double density_slope = 0;  ///< F''(z)
};

/// F(z), without guess and lapse. NaN gives NaN.
[[nodiscard]] double sigmoid_value(Sigmoid sigmoid, double z);

[[nodiscard]] SigmoidPoint sigmoid_point(Sigmoid sigmoid, double z);

/// z with F(z) = share, 0 < share < 1.
[[nodiscard]] double sigmoid_quantile(Sigmoid sigmoid, double share);

/// F^-1(0.95) - F^-1(0.05): the width of a function is this many scales.
[[nodiscard]] double scales_in_width(Sigmoid sigmoid);

}  // namespace seamline::study
