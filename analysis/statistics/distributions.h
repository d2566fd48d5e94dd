#pragma once

namespace seamline::analysis {

// Probabilities and quantiles by Boost.Math, whose headers take seconds of every file that includes them.

/// The value below which a share of the distribution lies; `probability` in (0, 1).
[[nodiscard]] double normal_quantile(double probability);
[[nodiscard]] double logistic_quantile(double probability);
[[nodiscard]] double student_quantile(double degrees_of_freedom, double probability);

/// The share of the standard normal distribution below z.
[[nodiscard]] double normal_below(double z);

/// The share of the distribution above a value.
[[nodiscard]] double normal_above(double z);
[[nodiscard]] double student_above(double degrees_of_freedom, double t);
[[nodiscard]] double chi_squared_above(double degrees_of_freedom, double value);
[[nodiscard]] double fisher_above(double numerator_degrees_of_freedom, double denominator_degrees_of_freedom,
                                  double value);

/// The value above which a share of the distribution lies; exact also for shares that 1 - share would round
/// away.
[[nodiscard]] double normal_with_above(double probability);
[[nodiscard]] double student_with_above(double degrees_of_freedom, double probability);

}  // namespace seamline::analysis
