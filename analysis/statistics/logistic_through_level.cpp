#include "analysis/statistics/logistic_through_level.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "analysis/statistics/logistic_polish.h"
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

struct Tried {
  double fall = 0, residual = infinity;
};

Tried try_shape(const Shape& shape, const Constraint& through, const std::vector<double>& level_x,
                const Eigen::VectorXd& means) {
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
  return {.fall = fall, .residual = total - fall * (2 * product - fall * square)};
}

/// Gauss-Newton step of centre and ln scale, the fall free.
Eigen::Vector3d damped_step(const Shape& shape, double fall, const Constraint& through,
                            const std::vector<double>& level_x, const Eigen::VectorXd& means,
                            double damping) {
  const double scale = std::exp(shape.log_scale);
  const double z_at = (through.at_x - shape.centre) / scale, at = falling_logistic(z_at);
  const double slope_at = at * (1 - at);
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < level_x.size(); ++i) {
    const double z = (level_x[i] - shape.centre) / scale, f = falling_logistic(z), slope = f * (1 - f);
    const Eigen::Vector3d by{f - at, fall * (slope - slope_at) / scale, fall * (slope * z - slope_at * z_at)};
    const double residual = means[static_cast<Eigen::Index>(i)] - through.level - fall * (f - at);
    curvature += by * by.transpose();
    gradient += by * residual;
  }
  curvature.diagonal() += damping * (curvature.diagonal().array() + 1e-9).matrix();
  return curvature.inverse() * gradient;
}

/// Levenberg-Marquardt from `shape` within the box.
Tried polish(Shape& shape, const Constraint& through, const std::vector<double>& level_x,
             const Eigen::VectorXd& means, const LogisticBox& box) {
  Tried best = try_shape(shape, through, level_x, means);
  double damping = 1e-3;
  for (int step = 0; step < LogisticPolish::most_steps && damping < 1e8; ++step) {
    const Eigen::Vector3d move = damped_step(shape, best.fall, through, level_x, means, damping);
    const Shape moved{.centre = std::clamp(shape.centre + move[1], box.lowest_centre, box.highest_centre),
                      .log_scale = std::clamp(shape.log_scale + std::clamp(move[2], -1.0, 1.0),
                                              std::log(box.smallest_scale), std::log(box.largest_scale))};
    const Tried tried = try_shape(moved, through, level_x, means);
    if (!(tried.residual < best.residual)) {
      damping *= 8;
      continue;
    }
    const double distance =
        std::abs(moved.centre - shape.centre) + std::abs(moved.log_scale - shape.log_scale);
    shape = moved;
    best = tried;
    damping = std::max(damping / 8, 1e-12);
    if (distance < LogisticPolish::smallest_move) break;
  }
  return best;
}

Shape best_of_grid(const Constraint& through, const std::vector<double>& level_x,
                   const Eigen::VectorXd& means, const LogisticBox& box) {
  Shape best{.centre = box.lowest_centre, .log_scale = std::log(box.smallest_scale)};
  double residual = infinity;
  for (double centre = box.lowest_centre; centre <= box.highest_centre; centre += grid_step_octaves)
    for (double log_scale = std::log(box.smallest_scale); log_scale <= std::log(box.largest_scale);
         log_scale += grid_step_log_scale) {
      const Shape shape{.centre = centre, .log_scale = log_scale};
      const Tried tried = try_shape(shape, through, level_x, means);
      if (!(tried.residual < residual)) continue;
      best = shape;
      residual = tried.residual;
    }
  return best;
}

}  // namespace

LogisticThroughLevel fit_through_level(double level, double at_x, const std::vector<double>& level_x,
                                       const Eigen::VectorXd& means, const LogisticBox& box,
                                       const Logistic4* start) {
  const Constraint through{.level = level, .at_x = at_x};
  Shape shape = best_of_grid(through, level_x, means, box);
  Tried best = polish(shape, through, level_x, means, box);
  if (start != nullptr) {
    Shape other{.centre = start->centre_x, .log_scale = std::log(start->scale_octaves)};
    if (const Tried tried = polish(other, through, level_x, means, box); tried.residual < best.residual) {
      shape = other;
      best = tried;
    }
  }
  const double scale = std::exp(shape.log_scale);
  const double lower = level - best.fall * falling_logistic((at_x - shape.centre) / scale);
  return {
      .curve = {.upper = lower + best.fall, .lower = lower, .centre_x = shape.centre, .scale_octaves = scale},
      .residual_sum_of_squares = std::max(0.0, best.residual)};
}

}  // namespace seamline::analysis
