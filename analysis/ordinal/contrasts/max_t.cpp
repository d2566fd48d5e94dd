#include "analysis/ordinal/contrasts/max_t.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/sort/spreadsort/float_sort.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "analysis/statistics/distributions.h"

namespace seamline::analysis {

namespace {

constexpr int lattice_points = 16384;
constexpr int points_at_once = 256;
constexpr int shares = 256;  ///< of the sphere, that one tail is computed for

/// The prime numbers in order.
int next_prime(int after) {
  for (int candidate = after + 1;; ++candidate) {
    bool prime = true;
    for (int divisor = 2; divisor * divisor <= candidate; ++divisor) prime &= candidate % divisor != 0;
    if (prime) return candidate;
  }
}

/// Normal quantiles of a lattice that fills the cube evenly (Richtmyer): multiples of the fractional part of
/// the root of a prime number, one an axis. They are the same for all correlations, and computed once.
const Eigen::VectorXd& lattice_axis(Eigen::Index axis) {
  static std::mutex one_at_a_time;
  static std::deque<Eigen::VectorXd> axes;  // whose elements stay where they are
  static int prime = 1;
  const std::scoped_lock lock(one_at_a_time);
  while (static_cast<Eigen::Index>(axes.size()) <= axis) {
    prime = next_prime(prime);
    const double generator = std::sqrt(prime) - std::floor(std::sqrt(prime));
    Eigen::VectorXd& along = axes.emplace_back(lattice_points);
    for (int point = 0; point < lattice_points; ++point) {
      const double turn = (point + 0.5) * generator + 0.5, place = turn - std::floor(turn);
      along[point] = normal_quantile(std::clamp(place, 1e-12, 1 - 1e-12));
    }
  }
  return axes[axis];
}

/// L with L L' = correlation, without the directions in which nothing varies.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& correlation) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
  const Eigen::VectorXd& values = solver.eigenvalues();
  Eigen::Index first = 0;
  while (first + 1 < values.size() && values[first] < 1e-9 * values[values.size() - 1]) ++first;
  const Eigen::Index kept = values.size() - first;
  Eigen::MatrixXd root = solver.eigenvectors().rightCols(kept) * values.tail(kept).cwiseSqrt().asDiagonal();
  root.rowwise().normalize();
  return root;
}

}  // namespace

MaxAbsT::MaxAbsT(const Eigen::MatrixXd& correlation, double degrees_of_freedom)
    : degrees_of_freedom_(degrees_of_freedom), count_(correlation.rows()) {
  assert(correlation.rows() > 0 && correlation.rows() == correlation.cols());
  const Eigen::MatrixXd root = root_of(correlation);
  dimension_ = root.cols();
  std::vector<double> all(lattice_points);
  Eigen::MatrixXd directions(points_at_once, dimension_), contrasts(points_at_once, count_);
  for (int first = 0; first < lattice_points; first += points_at_once) {
    for (Eigen::Index d = 0; d < dimension_; ++d)
      directions.col(d) = lattice_axis(d).segment(first, points_at_once);
    contrasts.noalias() = directions * root.transpose();
    Eigen::Map<Eigen::ArrayXd> greatest(all.data() + first, points_at_once);
    greatest = contrasts.col(0).array().abs();
    for (Eigen::Index j = 1; j < count_; ++j) greatest = greatest.max(contrasts.col(j).array().abs());
    const Eigen::ArrayXd length = directions.rowwise().norm();
    greatest = (length > 0).select(greatest / length, 0);
  }
  boost::sort::spreadsort::float_sort(all.begin(), all.end());
  constexpr int per_share = lattice_points / shares;
  for (int share = 0; share < shares; ++share) {
    double sum = 0;
    for (int i = 0; i < per_share; ++i) sum += all[static_cast<std::size_t>(share * per_share + i)];
    reach_.push_back(sum / per_share);
  }
}

double MaxAbsT::tail(double t) const {
  if (std::isnan(t)) return t;
  if (!(t > 0)) return 1;
  const double dimension = dimension_;
  double sum = 0;
  for (const double reach : reach_) {
    const double squared = (t / reach) * (t / reach);
    if (!std::isfinite(squared)) continue;
    sum += std::isinf(degrees_of_freedom_)
               ? chi_squared_above(dimension, squared)
               : fisher_above(dimension, degrees_of_freedom_, squared / dimension);
  }
  const double one = two_sided_tail(t, degrees_of_freedom_);
  return std::clamp(sum / shares, one, std::min(1.0, one * static_cast<double>(count_)));
}

double MaxAbsT::critical(double probability) const {
  const double low = two_sided_critical(probability, degrees_of_freedom_);
  const double high = two_sided_critical(probability / count_, degrees_of_freedom_);
  const auto excess = [&](double t) { return tail(t) - probability; };
  if (dimension_ == 1 || !(excess(low) > 0)) return low;  // all contrasts are one and the same
  if (!(excess(high) < 0)) return high;
  std::uintmax_t most_evaluations = 60;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, low, high, boost::math::tools::eps_tolerance<double>(30), most_evaluations);
  return (below + above) / 2;
}

double two_sided_tail(double t, double degrees_of_freedom) {
  if (std::isnan(t)) return t;
  const double size = std::abs(t);
  return 2 * (std::isinf(degrees_of_freedom) ? normal_above(size) : student_above(degrees_of_freedom, size));
}

double two_sided_critical(double probability, double degrees_of_freedom) {
  return std::isinf(degrees_of_freedom) ? normal_with_above(probability / 2)
                                        : student_with_above(degrees_of_freedom, probability / 2);
}

}  // namespace seamline::analysis
