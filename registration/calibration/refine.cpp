#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

#include "registration/calibration/estimate.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/numbers.h"

namespace seamline::registration {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Where the parameters of each part begin.
struct Layout {
  int second = 0, views = 0, count = 0;

  Layout(const Estimate& estimate, const Unknowns& unknowns) {
    second = unknowns.cameras ? camera_parameters * static_cast<int>(estimate.cameras.size()) : 0;
    views = second + (unknowns.second_from_first ? pose_parameters : 0);
    count = views + pose_parameters * static_cast<int>(estimate.first_from_view.size());
  }
};

struct Problem {
  const std::vector<SeenPoint>& seen;
  Unknowns unknowns;
  Layout layout;
};

/// J^T J, J^T r and the sum of squares.
struct NormalEquations {
  MatrixXd square;
  VectorXd gradient;
  double sum_of_squares = 0;
};

double sum_of_squares(const Problem& problem, const Estimate& estimate) {
  double sum = 0;
  for (const SeenPoint& seen : problem.seen) {
    const auto place = reproject(estimate, seen);
    if (!place) return infinity;
    sum += (place->position_px - seen.position_px).squaredNorm();
  }
  return std::isnan(sum) ? infinity : sum;
}

NormalEquations normal_equations(const Problem& problem, const Estimate& estimate) {
  const int count = problem.layout.count;
  NormalEquations normal{MatrixXd::Zero(count, count), VectorXd::Zero(count), 0};
  for (const SeenPoint& seen : problem.seen) {
    const auto place = reproject(estimate, seen);
    if (!place) {
      normal.sum_of_squares = infinity;
      return normal;
    }
    struct Part {
      int first = 0;
      Eigen::Matrix<double, 2, Eigen::Dynamic> by;
    };
    std::vector<Part> parts;
    if (problem.unknowns.cameras) parts.push_back({seen.camera * camera_parameters, place->by_camera});
    if (problem.unknowns.second_from_first && seen.camera == 1)
      parts.push_back({problem.layout.second, place->by_second});
    parts.push_back({problem.layout.views + seen.view * pose_parameters, place->by_view});
    const Eigen::Vector2d residual = place->position_px - seen.position_px;
    normal.sum_of_squares += residual.squaredNorm();
    for (const Part& a : parts) {
      normal.gradient.segment(a.first, a.by.cols()) += a.by.transpose() * residual;
      for (const Part& b : parts)
        normal.square.block(a.first, b.first, a.by.cols(), b.by.cols()) += a.by.transpose() * b.by;
    }
  }
  return normal;
}

Estimate stepped(const Problem& problem, const Estimate& estimate, const VectorXd& step) {
  Estimate next = estimate;
  if (problem.unknowns.cameras)
    for (std::size_t i = 0; i < next.cameras.size(); ++i)
      next.cameras[i] = changed(
          next.cameras[i], step.segment<camera_parameters>(static_cast<Eigen::Index>(i) * camera_parameters));
  if (problem.unknowns.second_from_first)
    next.second_from_first =
        changed(next.second_from_first, step.segment<pose_parameters>(problem.layout.second));
  for (std::size_t i = 0; i < next.first_from_view.size(); ++i)
    next.first_from_view[i] = changed(
        next.first_from_view[i],
        step.segment<pose_parameters>(problem.layout.views + static_cast<Eigen::Index>(i) * pose_parameters));
  return next;
}

/// (J^T J)^-1, computed in units in which its diagonal is 1. Nothing where a combination of parameters
/// changes no picture.
std::optional<MatrixXd> inverse_of(const MatrixXd& square) {
  constexpr double least_share = 1e-13;
  if (!(square.diagonal().minCoeff() > 0)) return std::nullopt;
  const VectorXd unit = square.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(unit.asDiagonal() * square * unit.asDiagonal());
  const VectorXd& values = eigen.eigenvalues();
  if (eigen.info() != Eigen::Success || !(values.minCoeff() > least_share * values.maxCoeff()))
    return std::nullopt;
  return MatrixXd(unit.asDiagonal() * eigen.eigenvectors() * values.cwiseInverse().asDiagonal() *
                  eigen.eigenvectors().transpose() * unit.asDiagonal());
}

InputError undetermined(const std::string& what) {
  return input_error({.field = what,
                      .wanted = "points that determine every parameter: boards in different tilts, distances "
                                "and places of the picture, or points in different directions",
                      .found = "some that leave parameters undetermined"});
}

}  // namespace

int Refined::first_of_second() const {
  return Layout(estimate, unknowns).second;
}

int Refined::first_of_view(int view) const {
  return Layout(estimate, unknowns).views + view * pose_parameters;
}

Refined refine(const Estimate& start, const std::vector<SeenPoint>& seen, const Unknowns& unknowns,
               const std::string& what) {
  constexpr int most_rounds = 300;
  const Problem problem{seen, unknowns, Layout(start, unknowns)};
  const int residuals = 2 * static_cast<int>(seen.size()), spare = residuals - problem.layout.count;
  if (spare < 1)
    throw input_error({.field = what,
                       .wanted = fmt::format("at least {} points for {} unknown numbers",
                                             problem.layout.count / 2 + 1, problem.layout.count),
                       .found = std::to_string(seen.size())});
  Estimate estimate = start;
  NormalEquations normal = normal_equations(problem, estimate);
  if (std::isinf(normal.sum_of_squares)) throw undetermined(what);
  double damping = 1e-3;
  bool ended = false;
  for (int round = 0; round < most_rounds && !ended; ++round) {
    stop_if_interrupted();
    MatrixXd damped = normal.square;
    damped.diagonal() *= 1 + damping;
    const VectorXd step = damped.ldlt().solve(-normal.gradient);
    const Estimate next = stepped(problem, estimate, step);
    const double sum = step.allFinite() ? sum_of_squares(problem, next) : infinity;
    if (sum <= normal.sum_of_squares) {
      // The sum that a full step could still take away, as a share of what is there.
      ended = -normal.gradient.dot(step) <= 1e-14 * normal.sum_of_squares + 1e-26;
      estimate = next;
      normal = normal_equations(problem, estimate);
      damping = std::max(damping / 10, 1e-15);
    } else {
      // Only rounding is left when even the smallest steps lead up.
      ended = damping > 1e12;
      damping *= 10;
    }
  }
  if (!ended) throw undetermined(what);
  const std::optional<MatrixXd> inverse = inverse_of(normal.square);
  if (!inverse) throw undetermined(what);

  Refined refined;
  refined.estimate = estimate;
  refined.unknowns = unknowns;
  refined.points = residuals / 2;
  refined.rms_px = std::sqrt(2 * normal.sum_of_squares / residuals);
  refined.sigma_px = std::sqrt(normal.sum_of_squares / spare);
  refined.covariance = refined.sigma_px * refined.sigma_px * *inverse;
  return refined;
}

}  // namespace seamline::registration
