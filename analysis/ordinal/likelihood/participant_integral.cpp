#include "analysis/ordinal/likelihood/participant_integral.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace seamline::analysis {

namespace {

constexpr int most_mode_steps = 200;
constexpr double mode_tolerance = 1e-13;

}  // namespace

struct ParticipantIntegral::AtEffect {
  std::vector<IntervalTerms> rows;
  double log_p = 0, s = 0, ss = 0, sss = 0;  ///< sums over the rows
};

struct ParticipantIntegral::Nodes {
  std::vector<double> v;
  std::vector<AtEffect> terms;
  Eigen::VectorXd weight;  ///< posterior, sums to 1
  double log_sum = 0;      ///< log sum_q w_q exp(z_q^2 + h(v_q))
};

ParticipantIntegral::ParticipantIntegral(const OrdinalProblem& problem, Link link,
                                         const Eigen::VectorXd& parameters, const Eigen::VectorXd& x_beta,
                                         RowRange rows)
    : problem_(problem),
      link_(link),
      rows_(rows),
      sd_(parameters[parameters.size() - 1]),
      size_(parameters.size()) {
  for (Eigen::Index row = rows.begin; row < rows.end; ++row) {
    ends_.push_back(row_ends(problem, parameters, x_beta, row));
    if (!(ends_.back().upper > ends_.back().lower)) valid_ = false;
  }
  if (valid_) find_mode();
}

ParticipantIntegral::AtEffect ParticipantIntegral::at(double v) const {
  AtEffect sums;
  sums.rows.reserve(ends_.size());
  for (const RowEnds& ends : ends_) {
    const IntervalTerms& terms =
        sums.rows.emplace_back(interval_terms(link_, ends.upper - sd_ * v, ends.lower - sd_ * v));
    sums.log_p += terms.log_p;
    sums.s += terms.s();
    sums.ss += terms.ss();
    sums.sss += terms.sss();
  }
  return sums;
}

/// Newton on h, which is concave with h'' <= -1, halving steps that lower it.
void ParticipantIntegral::find_mode() {
  AtEffect here = at(0);
  double h = here.log_p;
  for (int step = 0; step < most_mode_steps; ++step) {
    const double slope = sd_ * here.s - mode_;
    const double curvature = sd_ * sd_ * here.ss - 1;
    double move = -slope / curvature;
    const bool last = std::abs(move) < mode_tolerance * (1 + std::abs(mode_));
    const bool rounding = std::abs(slope * move) < 1e-12 * (1 + std::abs(h));
    AtEffect tried = at(mode_ + move);
    double tried_h = tried.log_p - 0.5 * (mode_ + move) * (mode_ + move);
    while (!rounding && !(tried_h > h) && std::abs(move) > mode_tolerance * (1 + std::abs(mode_))) {
      move /= 2;
      tried = at(mode_ + move);
      tried_h = tried.log_p - 0.5 * (mode_ + move) * (mode_ + move);
    }
    mode_ += move;
    h = tried_h;
    here = std::move(tried);
    if (last || (rounding && std::abs(move) < 1e-9)) break;
  }
  tau_ = 1 / std::sqrt(1 - sd_ * sd_ * here.ss);
  valid_ = std::isfinite(h) && std::isfinite(tau_);
}

ParticipantIntegral::Nodes ParticipantIntegral::nodes(const GaussHermite& rule) const {
  const Eigen::Index count = rule.node.size();
  Nodes all;
  all.weight.resize(count);
  for (Eigen::Index q = 0; q < count; ++q) {
    const double z = rule.node[q];
    const double v = mode_ + std::numbers::sqrt2 * tau_ * z;
    all.v.push_back(v);
    all.terms.push_back(at(v));
    all.weight[q] = std::log(rule.weight[q]) + z * z + all.terms.back().log_p - 0.5 * v * v;
  }
  const double largest = all.weight.maxCoeff();
  all.weight = (all.weight.array() - largest).exp();
  const double sum = all.weight.sum();
  all.weight /= sum;
  all.log_sum = largest + std::log(sum);
  return all;
}

Eigen::VectorXd ParticipantIntegral::score(const AtEffect& terms, double v) const {
  RowSlopes slopes{.u = Eigen::ArrayXd(rows_.size()), .l = Eigen::ArrayXd(rows_.size())};
  for (Eigen::Index i = 0; i < rows_.size(); ++i) {
    slopes.u[i] = terms.rows[i].u;
    slopes.l[i] = terms.rows[i].l;
  }
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size_);
  add_gradient(problem_, rows_, slopes, gradient);
  gradient[size_ - 1] = v * terms.s;
  return gradient;
}

double ParticipantIntegral::value_and_gradient(const GaussHermite& rule, Eigen::VectorXd& gradient) const {
  const Nodes all = nodes(rule);
  const AtEffect peak = at(mode_);
  // Derivatives of h' and h'' at the mode with respect to the parameters, v held.
  RowSlopes of_slope{.u = Eigen::ArrayXd(rows_.size()), .l = Eigen::ArrayXd(rows_.size())};
  RowSlopes of_curvature = of_slope;
  for (Eigen::Index i = 0; i < rows_.size(); ++i) {
    const IntervalTerms& terms = peak.rows[i];
    of_slope.u[i] = sd_ * terms.su();
    of_slope.l[i] = sd_ * terms.sl();
    of_curvature.u[i] = sd_ * sd_ * terms.ssu;
    of_curvature.l[i] = sd_ * sd_ * terms.ssl;
  }
  Eigen::VectorXd slope_by = Eigen::VectorXd::Zero(size_);
  Eigen::VectorXd curvature_by = Eigen::VectorXd::Zero(size_);
  add_gradient(problem_, rows_, of_slope, slope_by);
  add_gradient(problem_, rows_, of_curvature, curvature_by);
  slope_by[size_ - 1] = peak.s + mode_ * sd_ * peak.ss;
  curvature_by[size_ - 1] = 2 * sd_ * peak.ss + sd_ * sd_ * mode_ * peak.sss;
  const Eigen::VectorXd mode_by = slope_by * (tau_ * tau_);
  const Eigen::VectorXd tau_by =
      (0.5 * tau_ * tau_ * tau_) * (curvature_by + sd_ * sd_ * sd_ * peak.sss * mode_by);

  gradient = tau_by / tau_;
  for (Eigen::Index q = 0; q < rule.node.size(); ++q) {
    const double v = all.v[q];
    const AtEffect& terms = all.terms[q];
    const double slope = sd_ * terms.s - v;
    gradient +=
        all.weight[q] * (score(terms, v) + slope * (mode_by + std::numbers::sqrt2 * rule.node[q] * tau_by));
  }
  return std::log(tau_) - 0.5 * std::log(std::numbers::pi) + all.log_sum;
}

Eigen::MatrixXd ParticipantIntegral::hessian(const GaussHermite& rule) const {
  const Nodes all = nodes(rule);
  const Eigen::Index last = size_ - 1;
  const Eigen::ArrayXd zero = Eigen::ArrayXd::Zero(rows_.size());
  RowCurvatures mean{.uu = zero, .ul = zero, .ll = zero};
  RowSlopes with_sd{.u = zero, .l = zero};  // v d2 log P / ds d end
  double sd_sd = 0;
  Eigen::MatrixXd scores(size_, rule.node.size());
  for (Eigen::Index q = 0; q < rule.node.size(); ++q) {
    const double v = all.v[q];
    const double weight = all.weight[q];
    const AtEffect& terms = all.terms[q];
    for (Eigen::Index i = 0; i < rows_.size(); ++i) {
      const IntervalTerms& row = terms.rows[i];
      mean.uu[i] += weight * row.uu;
      mean.ul[i] += weight * row.ul;
      mean.ll[i] += weight * row.ll;
      with_sd.u[i] += weight * v * row.su();
      with_sd.l[i] += weight * v * row.sl();
    }
    sd_sd += weight * v * v * terms.ss;
    scores.col(q) = score(terms, v);
  }
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size_, size_);
  add_hessian(problem_, rows_, mean, hessian);
  Eigen::VectorXd sd_column = Eigen::VectorXd::Zero(size_);
  add_gradient(problem_, rows_, with_sd, sd_column);
  sd_column[last] = sd_sd;
  hessian.col(last) += sd_column;
  hessian.row(last).head(last) += sd_column.head(last).transpose();
  const Eigen::VectorXd mean_score = scores * all.weight;
  const Eigen::MatrixXd centred = scores.colwise() - mean_score;
  hessian += centred * all.weight.asDiagonal() * centred.transpose();
  return hessian;
}

}  // namespace seamline::analysis
