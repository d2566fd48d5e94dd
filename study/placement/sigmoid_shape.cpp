#include "study/placement/sigmoid_shape.h"

#include <boost/math/special_functions/erf.hpp>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace seamline::study {
namespace {

using std::numbers::ln2;
using std::numbers::sqrt2;

SigmoidPoint normal_point(double z) {
  const double tail = 0.5 * std::erfc(std::abs(z) / sqrt2);
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
  return {.below = z < 0 ? tail : 1 - tail,
          .above = z < 0 ? 1 - tail : tail,
          .density = density,
          .density_slope = -z * density};
}

SigmoidPoint logistic_point(double z) {
  const double decay = std::exp(-std::abs(z));
  const double tail = decay / (1 + decay), body = 1 / (1 + decay);
  const double density = tail * body;
  const double below = z < 0 ? tail : body, above = z < 0 ? body : tail;
  return {.below = below, .above = above, .density = density, .density_slope = density * (above - below)};
}

SigmoidPoint gumbel_point(double z) {
  const double hazard = ln2 * std::exp(std::min(z, 700.0));
  const double above = std::exp(-hazard);
  const double density = above > 0 ? hazard * above : 0;
  return {.below = -std::expm1(-hazard),
          .above = above,
          .density = density,
          .density_slope = above > 0 ? density * (1 - hazard) : 0};
}

double normal_value(double z) {
  return 0.5 * std::erfc(-z / sqrt2);
}

double logistic_value(double z) {
  return 1 / (1 + std::exp(-z));
}

double gumbel_value(double z) {
  return -std::expm1(-ln2 * std::exp(z));
}

double normal_quantile(double share) {
  return -sqrt2 * boost::math::erfc_inv(2 * share);
}

double logistic_quantile(double share) {
  return std::log(share) - std::log1p(-share);
}

double gumbel_quantile(double share) {
  return std::log(-std::log1p(-share) / ln2);
}

/// All that is known of a sigmoid.
struct SigmoidShape {
  double (*value)(double z);
  SigmoidPoint (*point)(double z);
  double (*quantile)(double share);
};

SigmoidShape shape_of(Sigmoid sigmoid) {
  switch (sigmoid) {
    case Sigmoid::logistic:
      return {logistic_value, logistic_point, logistic_quantile};
    case Sigmoid::normal:
      return {normal_value, normal_point, normal_quantile};
    case Sigmoid::gumbel:
      return {gumbel_value, gumbel_point, gumbel_quantile};
  }
  throw std::logic_error("a sigmoid without a shape");
}

}  // namespace

double sigmoid_value(Sigmoid sigmoid, double z) {
  return shape_of(sigmoid).value(z);
}

SigmoidPoint sigmoid_point(Sigmoid sigmoid, double z) {
  return shape_of(sigmoid).point(z);
}

double sigmoid_quantile(Sigmoid sigmoid, double share) {
  assert(share > 0 && share < 1);
  return shape_of(sigmoid).quantile(share);
}

double scales_in_width(Sigmoid sigmoid) {
  return sigmoid_quantile(sigmoid, 0.95) - sigmoid_quantile(sigmoid, 0.05);
}

}  // namespace seamline::study
