#include "analysis/statistics/logistic4.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/statistics/levenberg_marquardt.h"

namespace seamline::analysis {

namespace {

constexpr int scale_count = 16;
constexpr double centre_step_octaves = 0.125;
constexpr double margin_octaves = 2;  ///< how far outside the tested widths centres are tried
constexpr double edge_share = 1.02;   ///< a scale within 2 % of its bound lies at the bound
constexpr double flat_norm =
    1e-6;  ///< a logistic that varies less than this over the widths explains nothing
constexpr std::size_t polished_starts = 3;

/// A logistic of given centre and scale with its likeliest asymptotes, and what the next step needs of it.
struct Projection {
  Logistic4 curve;
  double residual_sum_of_squares = 0;
  std::vector<double> fallen;  ///< 1 at the upper asymptote, 0 at the lower, one a width
};

/// Linear least squares for the two asymptotes. Fills `into`, so that its memory is used again.
void project(double centre_x, double scale_x, std::span<const double> level_x, const Eigen::VectorXd& means,
             Projection& into) {
  into.fallen.resize(level_x.size());
  double sum_f = 0;
  for (std::size_t i = 0; i < level_x.size(); ++i)
    sum_f += into.fallen[i] = falling_logistic((level_x[i] - centre_x) / scale_x);
  const double mean_f = sum_f / level_x.size(), mean_y = means.mean();
  double product = 0, square = 0;
  for (std::size_t i = 0; i < level_x.size(); ++i) {
    const double centred = into.fallen[i] - mean_f;
    product += centred * means[static_cast<Eigen::Index>(i)];
    square += centred * centred;
  }
  const double fall = product / square, lower = mean_y - fall * mean_f;
  into.curve = {.upper = lower + fall, .lower = lower, .centre_x = centre_x, .scale_x = scale_x};
  into.residual_sum_of_squares = 0;
  for (std::size_t i = 0; i < level_x.size(); ++i) {
    const double residual = means[static_cast<Eigen::Index>(i)] - (lower + fall * into.fallen[i]);
    into.residual_sum_of_squares += residual * residual;
  }
}

/// Normal equations of the four parameters (upper, lower, centre, log scale) at a projection.
void accumulate(const Projection& at, std::span<const double> level_x, const Eigen::VectorXd& means,
                Eigen::Matrix4d& curvature, Eigen::Vector4d& gradient) {
  curvature.setZero();
  gradient.setZero();
  const double fall = at.curve.upper - at.curve.lower;
  for (std::size_t i = 0; i < level_x.size(); ++i) {
    const double z = (level_x[i] - at.curve.centre_x) / at.curve.scale_x;
    const double f = at.fallen[i];
    const double slope = f * (1 - f) * fall;  // d y / d(-z)
    const Eigen::Vector4d jacobian{f, 1 - f, slope / at.curve.scale_x, slope * z};
    const double residual = means[static_cast<Eigen::Index>(i)] - (at.curve.lower + fall * f);
    curvature.noalias() += jacobian * jacobian.transpose();
    gradient.noalias() += jacobian * residual;
  }
}

/// The four parameters over fixed widths, within the bounds of the grid.
struct FourParameters {
  static constexpr int parameters = 4;
  using Place = Projection;

  std::span<const double> level_x;
  const Eigen::VectorXd& means;
  const LogisticBox& box;

  void normal_equations(const Projection& at, Eigen::Matrix4d& curvature, Eigen::Vector4d& gradient) const {
    accumulate(at, level_x, means, curvature, gradient);
  }
  void step(const Projection& from, const Eigen::Vector4d& move, Projection& to) const {
    project(std::clamp(from.curve.centre_x + move[2], box.lowest_centre, box.highest_centre),
            std::clamp(from.curve.scale_x * std::exp(std::clamp(move[3], -1.0, 1.0)), box.smallest_scale,
                       box.largest_scale),
            level_x, means, to);
  }
  static double distance(const Projection& from, const Projection& to) {
    return std::abs(to.curve.centre_x - from.curve.centre_x) +
           std::abs(std::log(to.curve.scale_x / from.curve.scale_x));
  }
};

}  // namespace

double value_at(const Logistic4& curve, double level_x) {
  return curve.lower +
         (curve.upper - curve.lower) * falling_logistic((level_x - curve.centre_x) / curve.scale_x);
}

LogisticBox logistic_box(std::span<const double> level_x) {
  const double range = level_x.back() - level_x.front();
  double spacing = range;
  for (std::size_t i = 1; i < level_x.size(); ++i) spacing = std::min(spacing, level_x[i] - level_x[i - 1]);
  assert(spacing > 0);
  return {.lowest_centre = level_x.front() - margin_octaves,
          .highest_centre = level_x.back() + margin_octaves,
          .smallest_scale = 0.1 * spacing,
          .largest_scale = range};
}

Logistic4Fitter::Logistic4Fitter(std::vector<double> level_x) : level_x_(std::move(level_x)) {
  if (level_x_.size() < 4) return;
  const LogisticBox box = logistic_box(level_x_);
  for (int s = 0; s < scale_count; ++s)
    scales_.push_back(box.smallest_scale *
                      std::pow(box.largest_scale / box.smallest_scale, s / (scale_count - 1.0)));
  for (double c = box.lowest_centre; c <= box.highest_centre; c += centre_step_octaves) centres_.push_back(c);

  const auto widths = static_cast<Eigen::Index>(level_x_.size());
  basis_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(centres_.size() * scales_.size()), widths);
  Eigen::Index row = 0;
  for (double centre : centres_)
    for (double scale : scales_) {
      Eigen::RowVectorXd f(widths);
      for (Eigen::Index i = 0; i < widths; ++i) f[i] = falling_logistic((level_x_[i] - centre) / scale);
      f.array() -= f.mean();
      if (const double norm = f.norm(); norm > flat_norm) basis_.row(row) = f / norm;
      ++row;
    }
}

/// The best local optima of the grid, best first. Only falling curves (positive projections) count.
std::vector<Logistic4Start> Logistic4Fitter::starts(const Eigen::VectorXd& means) const {
  const Eigen::VectorXd projection = basis_ * means;
  const auto columns = static_cast<Eigen::Index>(scales_.size());
  const auto rows = static_cast<Eigen::Index>(centres_.size());
  std::vector<Eigen::Index> optima;
  for (Eigen::Index r = 0; r < rows; ++r)
    for (Eigen::Index c = 0; c < columns; ++c) {
      const double here = projection[r * columns + c];
      if (here <= flat_norm) continue;
      const bool beaten = (r > 0 && projection[(r - 1) * columns + c] > here) ||
                          (r + 1 < rows && projection[(r + 1) * columns + c] > here) ||
                          (c > 0 && projection[r * columns + c - 1] > here) ||
                          (c + 1 < columns && projection[r * columns + c + 1] > here);
      if (!beaten) optima.push_back(r * columns + c);
    }
  std::stable_sort(optima.begin(), optima.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return projection[a] > projection[b]; });
  if (optima.size() > polished_starts) optima.resize(polished_starts);

  std::vector<Logistic4Start> starts;
  for (Eigen::Index at : optima)
    starts.push_back({.centre_x = centres_[at / columns], .scale_x = scales_[at % columns]});
  return starts;
}

/// Descends within the bounds of the grid. Returns the residual sum of squares.
double Logistic4Fitter::polish(const Logistic4Start& start, const Eigen::VectorXd& means,
                               Logistic4& curve) const {
  Projection best, tried;
  project(start.centre_x, start.scale_x, level_x_, means, best);
  const LogisticBox grid{.lowest_centre = centres_.front(),
                         .highest_centre = centres_.back(),
                         .smallest_scale = scales_.front(),
                         .largest_scale = scales_.back()};
  levenberg_marquardt(FourParameters{.level_x = level_x_, .means = means, .box = grid}, best, tried);
  curve = best.curve;
  return best.residual_sum_of_squares;
}

Logistic4Fit Logistic4Fitter::judge(const Logistic4& curve, double residual) const {
  Logistic4Fit fit{
      .curve = curve, .residual_sum_of_squares = residual, .verdict = Centre::identified, .centre_range = {}};
  const double centre = curve.centre_x;
  fit.centre_range = {.low_x = centre, .high_x = centre};
  if (centre < level_x_.front() || centre > level_x_.back()) {
    const bool below = centre < level_x_.front();
    fit.verdict = below ? Centre::below_range : Centre::above_range;
    const double end = below ? below_every_level : above_every_level;
    fit.centre_range = {.low_x = end, .high_x = end};
  } else if (curve.scale_x >= scales_.back() / edge_share) {
    fit.verdict = Centre::straight;
    fit.centre_range = {};
  } else if (curve.scale_x <= scales_.front() * edge_share) {
    fit.verdict = Centre::step;
    const auto right = std::lower_bound(level_x_.begin() + 1, level_x_.end() - 1, centre);
    fit.centre_range = {.low_x = *(right - 1), .high_x = *right};
  }
  return fit;
}

Logistic4Fit Logistic4Fitter::fit(std::span<const double> means) const {
  if (level_x_.size() < 4) {
    Logistic4Fit none;
    none.verdict = Centre::too_few_levels;
    return none;
  }
  assert(means.size() == level_x_.size());
  const Eigen::VectorXd y =
      Eigen::Map<const Eigen::VectorXd>(means.data(), static_cast<Eigen::Index>(means.size()));
  Logistic4Fit best;
  bool found = false;
  for (const Logistic4Start& start : starts(y)) {
    Logistic4 curve;
    const double residual = polish(start, y, curve);
    if (found && residual >= best.residual_sum_of_squares) continue;
    best = judge(curve, residual);
    found = true;
  }
  if (!found) best.curve = {.upper = y.mean(), .lower = y.mean(), .centre_x = level_x_.front(), .scale_x = 1};
  return best;
}

}  // namespace seamline::analysis
