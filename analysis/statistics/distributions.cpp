#include "analysis/statistics/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/logistic.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace seamline::analysis {

using boost::math::complement;

namespace {

/// Boost computes in long double and rounds, unless it is told not to. In double the tails of F differ by
/// some 1e-14 of themselves, and take a fifth of the time.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace

double normal_quantile(double probability) {
  return quantile(boost::math::normal(), probability);
}

double logistic_quantile(double probability) {
  return quantile(boost::math::logistic(), probability);
}

double student_quantile(double degrees_of_freedom, double probability) {
  return quantile(boost::math::students_t(degrees_of_freedom), probability);
}

double normal_below(double z) {
  return cdf(boost::math::normal(), z);
}

double normal_above(double z) {
  return cdf(complement(boost::math::normal(), z));
}

double student_above(double degrees_of_freedom, double t) {
  return cdf(complement(boost::math::students_t(degrees_of_freedom), t));
}

double chi_squared_above(double degrees_of_freedom, double value) {
  return cdf(complement(boost::math::chi_squared(degrees_of_freedom), value));
}

double fisher_above(double numerator_degrees_of_freedom, double denominator_degrees_of_freedom,
                    double value) {
  const boost::math::fisher_f_distribution<double, InDouble> fisher(numerator_degrees_of_freedom,
                                                                    denominator_degrees_of_freedom);
  return cdf(complement(fisher, value));
}

double normal_with_above(double probability) {
  return quantile(complement(boost::math::normal(), probability));
}

double student_with_above(double degrees_of_freedom, double probability) {
  return quantile(complement(boost::math::students_t(degrees_of_freedom), probability));
}

}  // namespace seamline::analysis
