#pragma once
#include <optional>

#include "study/placement/psychometric_function.h"

namespace seamline::analysis {

/// A guess or lapse rate: known, or estimated within a stated bound.
struct Rate {
  double low = 0, high = 0;
  [[nodiscard]] bool is_free() const { return high > low; }
};

[[nodiscard]] constexpr Rate fixed_rate(double value) {
  return {.low = value, .high = value};
}
[[nodiscard]] constexpr Rate free_rate(double high) {
  return {.low = 0, .high = high};
}

struct NormalPrior {
  double mean = 0, sd = 1;
};

/// Density proportional to x^(a-1) (1-x)^(b-1); a, b >= 1.
struct BetaPrior {
  double a = 1, b = 1;
};

/// With a prior the estimate is the maximum of the posterior density (MAP) and profile intervals are those of
/// the posterior. Without one (the default) everything is maximum likelihood.
struct Priors {
  std::optional<NormalPrior> threshold;   ///< `mean` is a level; `sd` is on the axis (octaves on log2)
  std::optional<NormalPrior> log2_width;  ///< of log2 of the width
  std::optional<BetaPrior> lapse;
};

/// What is fitted: psi(x) = guess + (1 - guess - lapse) F(d (a(x) - a(threshold)) / scale), see
/// study/placement/psychometric_function.h.
struct FitOptions {
  Sigmoid sigmoid = Sigmoid::normal;
  study::Axis axis = study::Axis::log2;
  std::optional<study::Direction> direction = std::nullopt;  ///< none: the likelier of the two
  Rate guess = fixed_rate(0);
  Rate lapse = free_rate(0.1);
  /// True: guess and lapse rate are one number, within the bounds of `lapse`; `guess` says nothing. For tasks
  /// whose two answers mirror each other, as of a point of subjective equality.
  bool equal_rates = false;
  Priors priors = {};
  /// True: the answers at a level (a row) are beta-binomial with an estimated overdispersion, and so are the
  /// intervals. False: binomial.
  bool overdispersed = false;
};

/// The defaults for a task: guess 1/N for N >= 2 alternatives, 0 for yes/no (`alternatives` 1), lapse free to
/// 0.1.
[[nodiscard]] inline FitOptions options_for_alternatives(int alternatives) {
  FitOptions options;
  options.guess = fixed_rate(alternatives >= 2 ? 1.0 / alternatives : 0.0);
  return options;
}

/// Throws InputError unless 0 <= guess, 0 <= lapse, guess + lapse < 1 at their upper bounds, and priors are
/// proper (positive sd, a and b >= 1, a positive threshold on a log2 axis).
void require_valid(const FitOptions& options);

}  // namespace seamline::analysis
