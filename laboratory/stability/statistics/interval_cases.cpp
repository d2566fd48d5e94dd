#include "laboratory/stability/statistics/interval_cases.h"

#include <fmt/core.h>

#include <cmath>

#include "analysis/psychometric/likelihood/count_terms.h"
#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/worst.h"
#include "laboratory/stability/statistics/curve_fit_cases.h"
#include "study/placement/sigmoid_shape.h"
#include "support/text/numbers.h"

namespace seamline::stability {

Interval interval_as_product(const PsychometricFit& fit) {
  return threshold_interval(fit);
}

Finding try_singular_information(const IntervalRule& rule) {
  const PsychometricFit fit = fit_psychometric(
      counts_at_widths(60, [](double px) { return px < 300 ? 1.0 : 1.0 / 3; }), falling_choice_of_three());
  const Interval ci = rule(fit);
  // The likelihood of a step does not change between the levels: it has no information there.
  const Objective at = objective_at(fit.search.problem, fit.search.best.theta, 0);
  const double variance = coordinate_variance(fit.search.problem, fit.search.best, 0);
  const bool singular = std::isinf(variance) || variance > 1e6;
  int wrong = (ci.low <= 256.5 ? 0 : 1) + (ci.high >= 511.5 ? 0 : 1) + (singular ? 0 : 1);
  wrong += at.expected.allFinite() && at.observed.allFinite() ? 0 : 1;
  return {
      static_cast<double>(wrong),
      fmt::format("interval {:.4g} to {:.4g} px, variance by information {:.3g}", ci.low, ci.high, variance)};
}

Finding try_maximum_at_bound(const IntervalRule& rule) {
  const PsychometricFit fit = fit_psychometric(
      counts_at_widths(40, [](double px) { return response_probability(planted_function(0), px); }),
      falling_choice_of_three());
  const Interval ci = rule(fit);
  int wrong = fit.converged ? 0 : 1;
  wrong += ci.low <= 500 && ci.high >= 500 && std::isfinite(ci.low) && std::isfinite(ci.high) ? 0 : 1;
  return {static_cast<double>(wrong),
          fmt::format("lapse {:.3g}, interval {:.4g} to {:.4g} px", fit.function.lapse, ci.low, ci.high)};
}

Finding try_degenerate_resamples(const BootstrapRule& rule) {
  std::vector<LevelCounts> counts = counts_at_widths(2, [](double px) { return px < 1000 ? 1.0 : 0.5; });
  const PsychometricFit fit = fit_psychometric(counts, falling_choice_of_three());
  constexpr int replicates = 400;
  const BootstrapIntervals found = rule(fit, {.replicates = replicates, .seed = 3});
  const bool many_without = found.without_threshold > replicates / 20;
  int wrong = found.replicates == replicates ? 0 : 1;
  wrong += std::isnan(found.threshold.low) || std::isnan(found.threshold.high) ? 1 : 0;
  wrong += many_without && std::isfinite(found.threshold.low) && std::isfinite(found.threshold.high) ? 1 : 0;
  // The step lies between 512 and 1,024 px: every threshold there is as likely.
  wrong += found.threshold.low <= 513 && found.threshold.high >= 1023 ? 0 : 1;
  wrong += found.width.low == 0 || found.steps <= replicates / 20 ? 0 : 1;
  return {static_cast<double>(wrong),
          fmt::format("{} of {} replicates without a threshold, {} steps; interval {:.4g} to {:.4g} px",
                      found.without_threshold, replicates, found.steps, found.threshold.low,
                      found.threshold.high)};
}

Finding try_steps_through_levels(const BootstrapRule& rule) {
  const PsychometricFit fit = fit_psychometric(
      counts_at_widths(60, [](double px) { return px < 200   ? 1.0
                                                  : px < 300 ? 0.7
                                                             : 1.0 / 3; }),
      falling_choice_of_three());
  const BootstrapIntervals found = rule(fit, {.replicates = 400, .seed = 5});
  const Interval profile = threshold_interval(fit), ci = found.threshold;
  int wrong = ci.low <= fit.function.threshold && fit.function.threshold <= ci.high ? 0 : 1;
  for (const double end : {ci.low, ci.high})
    wrong += std::abs(std::log2(end) - std::round(std::log2(end))) > 1e-4 ? 0 : 1;
  wrong += std::log2(ci.high / ci.low) <= 1.3 * std::log2(profile.high / profile.low) ? 0 : 1;
  return {static_cast<double>(wrong),
          fmt::format("{} of 400 steps; interval {:.4g} to {:.4g} px, the profile's {:.4g} to {:.4g}",
                      found.steps, ci.low, ci.high, profile.low, profile.high)};
}

Finding try_extreme_probabilities() {
  double error = 0;
  for (const double p : {1e-130, 1e-100, 1e-16, 0.5}) {
    const double exact = 3 * std::log(p) + 2 * std::log1p(-p);
    for (const CountTerm& term : {binomial_term(3, 5, p, 1 - p), binomial_term(2, 5, 1 - p, p)})
      error = worse(error, relative_error(term.value, exact));
    error = worse(error, relative_error(beta_binomial_term(3, 5, p, 1 - p, 0).value, exact));
  }
  // Under 1e-140 a probability counts as 0, and data that it rules out are impossible, not a number of some
  // size.
  if (binomial_term(3, 5, 1e-300, 1).value != -infinity)
    return {nan, "an answer of probability 1e-300 was given a likelihood"};
  for (const Sigmoid sigmoid : {Sigmoid::normal, Sigmoid::logistic, Sigmoid::gumbel})
    for (const double z : {-1e308, -1e4, -40.0, 0.0, 40.0, 1e4, 1e308}) {
      const study::SigmoidPoint point = study::sigmoid_point(sigmoid, z);
      error = worse(error, std::abs(point.below + point.above - 1));
      error = worse(error, std::isfinite(point.density) && std::isfinite(point.density_slope) ? 0 : nan);
    }
  return {error, fmt::format("largest deviation {:.2g}", error)};
}

StabilityCases interval_cases() {
  return {
      counted_case("statistics", "singular-information",
                   "a perfect step, whose likelihood has no curvature in the threshold",
                   "an interval over all of 256 to 512 px, and a variance that is not a number to trust",
                   [] { return try_singular_information(); }),
      counted_case("statistics", "maximum-at-bound",
                   "counts without lapses: the likelihood is highest at the bound 0 of the lapse rate",
                   "a finite interval that holds 500 px", [] { return try_maximum_at_bound(); }),
      counted_case("statistics", "degenerate-resamples",
                   "two answers a level, bootstrapped: steps and flat lines among the resamples",
                   "no replicate dropped, an end open where many have no threshold",
                   [] { return try_degenerate_resamples(); }),
      counted_case(
          "statistics", "steps-through-levels",
          "a step through 256 px, 60 answers a level, bootstrapped: most resamples are such steps",
          "an interval around the estimate that ends at no tested level, about as long as the profile's",
          [] { return try_steps_through_levels(); }),
      {.group = "statistics",
       .name = "extreme-probabilities",
       .tried =
           "log-likelihoods at p from 1e-130 to 0.5 and its complement, sigmoids at z from -1e308 to 1e308",
       .expected = "the exact values, and F + (1 - F) = 1",
       .unit = "relative",
       .tolerance = 1e-14,
       .reason = "a few roundings of double, 1.1e-16 each, in sums of logarithms",
       .run = [](const StabilityOptions&) { return try_extreme_probabilities(); }},
  };
}

}  // namespace seamline::stability
