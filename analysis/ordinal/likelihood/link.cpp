#include "analysis/ordinal/likelihood/link.h"

#include <cmath>
#include <numbers>

#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double half_log_two_pi = 0.91893853320467274178;

/// F, log F and the derivatives of F at x for the standard logistic distribution.
struct LogisticAt {
  double f = 0;          ///< F(x)
  double f_minus = 0;    ///< F(-x)
  double density = 0;    ///< F'
  double slope = 0;      ///< F''
  double log_f = 0;      ///< log F(x)
  double log_minus = 0;  ///< log F(-x)
  explicit LogisticAt(double x) {
    const double small = std::exp(-std::abs(x));
    const double large = 1 / (1 + small);
    f = x >= 0 ? large : small * large;
    f_minus = x >= 0 ? small * large : large;
    density = f * f_minus;
    slope = density * (f_minus - f);
    const double log_large = -std::log1p(small);
    log_f = std::min(x, 0.0) + log_large;
    log_minus = std::min(-x, 0.0) + log_large;
  }
};

/// P = F(upper) F(-lower) (1 - exp(lower - upper)), which holds for the logistic distribution only: nothing
/// is subtracted, and a shift leaves the last factor alone.
IntervalTerms logit_terms(double upper, double lower) {
  const LogisticAt a(upper);
  const LogisticAt b(lower);
  const double width = upper - lower;
  IntervalTerms terms;
  double gap = 0, curvature = 0;
  if (std::isfinite(width)) {
    const double grown = std::expm1(width);
    gap = 1 / grown;
    curvature = gap * (1 + gap);
    terms.log_p = std::log(-std::expm1(-width));
  }
  terms.log_p += (upper == infinity ? 0 : a.log_f) + (lower == -infinity ? 0 : b.log_minus);
  terms.u = a.f_minus + gap;
  terms.l = -b.f - gap;
  terms.uu = -a.density - curvature;
  terms.ul = curvature;
  terms.ll = -b.density - curvature;
  terms.ssu = -a.slope;
  terms.ssl = -b.slope;
  return terms;
}

/// log Phi(x) for any x.
double log_normal_cdf(double x) {
  if (x > -37)
    return x > 5 ? std::log1p(-0.5 * std::erfc(x / std::numbers::sqrt2))
                 : std::log(0.5 * std::erfc(-x / std::numbers::sqrt2));
  const double r = 1 / (x * x);  // asymptotic series; its next term is under 1e-10 of the sum here
  return -0.5 * x * x - std::log(-x) - half_log_two_pi + std::log1p(-r * (1 - 3 * r * (1 - 5 * r)));
}

/// log(Phi(upper) - Phi(lower)), read in the tail where both are small.
double log_normal_difference(double upper, double lower) {
  if (lower > 0 || (upper > 0 && -lower < upper)) {
    const double swap = upper;
    upper = -lower;
    lower = -swap;
  }
  const double log_upper = log_normal_cdf(upper);
  if (lower == -infinity) return log_upper;
  return log_upper + std::log(-std::expm1(log_normal_cdf(lower) - log_upper));
}

IntervalTerms probit_terms(double upper, double lower) {
  IntervalTerms terms;
  terms.log_p = log_normal_difference(upper, lower);
  const double a = upper == infinity ? 0 : upper;  // an infinite end has density 0, so its place is free
  const double b = lower == -infinity ? 0 : lower;
  const double ga = upper == infinity ? 0 : std::exp(-0.5 * upper * upper - half_log_two_pi - terms.log_p);
  const double gb = lower == -infinity ? 0 : std::exp(-0.5 * lower * lower - half_log_two_pi - terms.log_p);
  const double d = ga - gb;
  terms.u = ga;
  terms.l = -gb;
  terms.uu = -ga * (a + ga);
  terms.ul = ga * gb;
  terms.ll = gb * (b - gb);
  terms.ssu = ga * (a * a - 1 + a * ga - b * gb + 2 * d * (a + d));
  terms.ssl = gb * (1 - b * b + b * gb - a * ga - 2 * d * (b + d));
  return terms;
}

}  // namespace

std::string_view word(Link link) {
  switch (link) {
    case Link::logit:
      return "logit";
    case Link::probit:
      return "probit";
  }
  return {};
}

double cumulative(Link link, double x) {
  switch (link) {
    case Link::logit:
      return LogisticAt(x).f;
    case Link::probit:
      return 0.5 * std::erfc(-x / std::numbers::sqrt2);
  }
  return 0;
}

IntervalTerms interval_terms(Link link, double upper, double lower) {
  if (!(upper > lower)) {
    IntervalTerms none;
    none.log_p = -infinity;
    return none;
  }
  switch (link) {
    case Link::logit:
      return logit_terms(upper, lower);
    case Link::probit:
      return probit_terms(upper, lower);
  }
  return {};
}

}  // namespace seamline::analysis
