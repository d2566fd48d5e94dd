#include "analysis/statistics/logistic_through_level.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/levenberg_marquardt.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double grid_step_octaves = 0.5;
constexpr double grid_step_log_scale = 0.5;

/// Where the curve goes: through the level at a width.
struct Constraint {
  double level = 0, at_x = 0;
};

/// Centre and ln scale; the fall follows by linear least squares.
struct Shape {
  double centre = 0, log_scale = 0;
};

/// A shape with its likeliest fall.
struct Tried {
  Shape shape;
  double fall = 0, residual_sum_of_squares = infinity;
};

/// Centre, ln scale and fall of the curves through the level at the width, within the box.
struct CurvesThrough {
  static constexpr int parameters = 3;
  using Place = Tried;

  Constraint through;
  const std::vector<double>& level_x;
  const Eigen::VectorXd& means;
  const LogisticBox& box;

  [[nodiscard]] Tried at(const Shape& shape) const {
    const double scale = std::exp(shape.log_scale);
    const double at = falling_logistic((through.at_x - shape.centre) / scale);
    double product = 0, square = 0, total = 0;
    for (std::size_t i = 0; i < level_x.size(); ++i) {
      const double base = falling_logistic((level_x[i] - shape.centre) / scale) - at;
      const double above = means[static_cast<Eigen::Index>(i)] - through.level;
      product += base * above;
      square += base * base;
      total += above * above;
    }
    const double fall = square > 0 ? std::max(0.0, product / square) : 0;
    return {.shape = shape,
            .fall = fall,
            .residual_sum_of_squares = total - fall * (2 * product - fall * square)};
  }

  void normal_equations(const Tried& from, Eigen::Matrix3d& curvature, Eigen::Vector3d& gradient) const {
    const Shape& shape = from.shape;
    const double fall = from.fall, scale = std::exp(shape.log_scale);
    const double z_at = (through.at_x - shape.centre) / scale, at = falling_logistic(z_at);
    const double slope_at = at * (1 - at);
    curvature.setZero();
    gradient.setZero();
    for (std::size_t i = 0; i < level_x.size(); ++i) {
      const double z = (level_x[i] - shape.centre) / scale, f = falling_logistic(z), slope = f * (1 - f);
      const Eigen::Vector3d by{f - at, fall * (slope - slope_at) / scale,
                               fall * (slope * z - slope_at * z_at)};
      const double residual = means[static_cast<Eigen::Index>(i)] - through.level - fall * (f - at);
      curvature += by * by.transpose();
      gradient += by * residual;
    }
  }

  void step(const Tried& from, const Eigen::Vector3d& move, Tried& to) const {
    to = at({.centre = std::clamp(from.shape.centre + move[1], box.lowest_centre, box.highest_centre),
             .log_scale = std::clamp(from.shape.log_scale + std::clamp(move[2], -1.0, 1.0),
                                     std::log(box.smallest_scale), std::log(box.largest_scale))});
  }

  static double distance(const Tried& from, const Tried& to) {
    return std::abs(to.shape.centre - from.shape.centre) +
           std::abs(to.shape.log_scale - from.shape.log_scale);
  }
};

Tried polish(const CurvesThrough& curves, const Shape& start) {
  Tried best = curves.at(start), next;
  levenberg_marquardt(curves, best, next);
  return best;
}

Shape best_of_grid(const CurvesThrough& curves) {
  const LogisticBox& box = curves.box;
  Shape best{.centre = box.lowest_centre, .log_scale = std::log(box.smallest_scale)};
  double residual = infinity;
  for (double centre = box.lowest_centre; centre <= box.highest_centre; centre += grid_step_octaves)
    for (double log_scale = std::log(box.smallest_scale); log_scale <= std::log(box.largest_scale);
         log_scale += grid_step_log_scale) {
      const Tried tried = curves.at({.centre = centre, .log_scale = log_scale});
      if (!(tried.residual_sum_of_squares < residual)) continue;
      best = tried.shape;
      residual = tried.residual_sum_of_squares;
    }
  return best;
}

}  // namespace

LogisticThroughLevel fit_through_level(double level, double at_x, const std::vector<double>& level_x,
                                       const Eigen::VectorXd& means, const LogisticBox& box,
                                       const Logistic4* start) {
  const CurvesThrough curves{
      .through = {.level = level, .at_x = at_x}, .level_x = level_x, .means = means, .box = box};
  Tried best = polish(curves, best_of_grid(curves));
  if (start != nullptr) {
    const Tried other = polish(curves, {.centre = start->centre_x, .log_scale = std::log(start->scale_x)});
    if (other.residual_sum_of_squares < best.residual_sum_of_squares) best = other;
  }
  const Shape& shape = best.shape;
  const double scale = std::exp(shape.log_scale);
  const double lower = level - best.fall * falling_logistic((at_x - shape.centre) / scale);
  return {.curve = {.upper = lower + best.fall, .lower = lower, .centre_x = shape.centre, .scale_x = scale},
          .residual_sum_of_squares = std::max(0.0, best.residual_sum_of_squares)};
}

}  // namespace seamline::analysis
