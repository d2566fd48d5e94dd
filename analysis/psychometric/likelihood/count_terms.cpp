#include "analysis/psychometric/likelihood/count_terms.h"

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>

#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double impossible = 1e-140;  ///< a smaller probability counts as 0: its square must not underflow
constexpr double summed_counts = 256;  ///< up to here sums are added one by one, which is exact for any eta
constexpr double smallest_eta = 1e-4;

/// sum_{i<count} of ln(p + i w), 1/(p + i w) and 1/(p + i w)^2.
struct RisingSums {
  double log = 0, inverse = 0, inverse_square = 0;
};

RisingSums rising_sums(double count, double p, double w) {
  RisingSums sums;
  if (count <= summed_counts) {
    for (double i = 0; i < count; ++i) {
      const double inverse = 1 / (p + i * w);
      sums.log += std::log(p + i * w);
      sums.inverse += inverse;
      sums.inverse_square += inverse * inverse;
    }
    return sums;
  }
  const double start = p / w;
  sums.log = std::lgamma(start + count) - std::lgamma(start) + count * std::log(w);
  sums.inverse = (boost::math::digamma(start + count) - boost::math::digamma(start)) / w;
  sums.inverse_square = (boost::math::trigamma(start) - boost::math::trigamma(start + count)) / (w * w);
  return sums;
}

}  // namespace

CountTerm binomial_term(double k, double n, double p, double q) {
  const double wrong = n - k;
  if ((k > 0 && p < impossible) || (wrong > 0 && q < impossible)) return {.value = -infinity};
  CountTerm term;
  if (k > 0) {
    const double share = k / p;
    term.value += k * std::log(p);
    term.score += share;
    term.observed += share / p;
  }
  if (wrong > 0) {
    const double share = wrong / q;
    term.value += wrong * std::log(q);
    term.score -= share;
    term.observed += share / q;
  }
  term.expected = p * q > impossible ? n / (p * q) : 0;
  return term;
}

CountTerm beta_binomial_term(double k, double n, double p, double q, double eta) {
  if (eta < smallest_eta || n <= 1) return binomial_term(k, n, p, q);
  const double wrong = n - k;
  if ((k > 0 && p < impossible) || (wrong > 0 && q < impossible)) return {.value = -infinity};
  const double w = eta * eta / (1 - eta * eta);
  const RisingSums right_sums = rising_sums(k, p, w), wrong_sums = rising_sums(wrong, q, w);
  return {.value = right_sums.log + wrong_sums.log - rising_sums(n, 1, w).log,
          .score = right_sums.inverse - wrong_sums.inverse,
          .observed = right_sums.inverse_square + wrong_sums.inverse_square,
          .expected = p * q > impossible ? n / (p * q) / (1 + (n - 1) * eta * eta) : 0};
}

}  // namespace seamline::analysis
