#pragma once

namespace seamline::analysis {

/// What one level adds to the log-likelihood, without the binomial coefficient, as a function of the
/// probability p of a right choice.
struct CountTerm {
  double value = 0;
  double score = 0;     ///< d value / dp
  double observed = 0;  ///< -d2 value / dp2, positive
  double expected = 0;  ///< Fisher's information on p
};

/// k of n answers right, each with probability p, q = 1 - p given separately so that it keeps its bits:
/// k ln p + (n - k) ln q. -infinity when the data are impossible.
[[nodiscard]] CountTerm binomial_term(double k, double n, double p, double q);

/// The same for a beta-binomial, whose p varies between rows with mean p and variance eta^2 p q:
///
///     sum_{i<k} ln(p + i w) + sum_{i<n-k} ln(q + i w) - sum_{i<n} ln(1 + i w),   w = eta^2 / (1 - eta^2)
///
/// eta = 0 is the binomial; eta^2 is the correlation between two answers of a row; the variance of k is
/// n p q (1 + (n - 1) eta^2). The parametrisation of Schuett et al. (2016).
[[nodiscard]] CountTerm beta_binomial_term(double k, double n, double p, double q, double eta);

}  // namespace seamline::analysis
