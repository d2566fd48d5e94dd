#pragma once

namespace seamline::inline stimuli {

/// A sigmoid F on the real line, each shifted so that F(0) = 0.5 (thresholds of different sigmoids then mean
/// the same).
enum class Sigmoid {
  logistic,  ///< F(z) = 1 / (1 + exp(-z))
  normal,    ///< F(z) = Phi(z)
  gumbel  ///< F(z) = 1 - 2^(-exp(z)); a Weibull function on a log axis. The textbook's 1 - exp(-exp(z)) is ln
          ///< ln 2 away
};

}  // namespace seamline::inline stimuli
