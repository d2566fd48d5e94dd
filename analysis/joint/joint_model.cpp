#include "analysis/joint/joint_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::analysis {

namespace {

/// Coordinates of a block for all curves: one set where it is shared.
int sets(const JointModel& model, bool shared) {
  return shared ? 1 : model.curves;
}

int which(bool shared, int curve) {
  return shared ? 0 : curve;
}

double logistic_of_lapse(double l) {
  return l >= 0 ? 1 / (1 + std::exp(-l)) : std::exp(l) / (1 + std::exp(l));
}

double normal_of_z(double z) {
  return std::erfc(-z / std::numbers::sqrt2) / 2;
}

}  // namespace

Eigen::Index JointModel::log_scale(int curve) const {
  return curves + which(sharing.scale, curve);
}

Eigen::Index JointModel::lapse(int curve) const {
  return curves + sets(*this, sharing.scale) + which(sharing.lapse, curve);
}

Eigen::Index JointModel::first_cut(int curve) const {
  return curves + sets(*this, sharing.scale) + sets(*this, sharing.lapse) +
         (ratings > 1 ? ratings * which(sharing.criteria, curve) : 0);
}

Eigen::Index JointModel::log_spread(int curve) const {
  return first_cut(curve) + ratings - 1;
}

Eigen::Index JointModel::first_guess(int curve) const {
  const int before = ratings > 1 ? ratings * sets(*this, sharing.criteria) : 0;
  return curves + sets(*this, sharing.scale) + sets(*this, sharing.lapse) + before +
         (ratings - 1) * which(sharing.guess_ratings, curve);
}

Eigen::Index JointModel::parameters() const {
  return first_guess(0) + (ratings - 1) * sets(*this, sharing.guess_ratings) + (between_people ? 1 : 0);
}

JointModel joint_model(const JointData& data, const JointSharing& sharing) {
  JointModel model{.curves = static_cast<int>(data.curves.size()),
                   .ratings = data.ratings,
                   .sharing = sharing,
                   .between_people = false,
                   .cells = data.cells};
  std::vector<double> levels;
  for (const JointCell& cell : data.cells)
    if (std::isfinite(cell.x)) levels.push_back(cell.x);
  if (levels.empty()) return model;
  const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
  model.centre_x = (*least + *most) / 2;
  if (*most > *least) model.range_x = *most - *least;
  return model;
}

std::vector<std::string> parameter_names(const JointModel& model, const std::vector<std::string>& curves) {
  std::vector<std::string> names(model.parameters());
  const auto name = [&](Eigen::Index at, const std::string& text, bool shared, int curve) {
    names[at] = shared ? text : text + " " + curves[curve];
  };
  for (int c = 0; c < model.curves; ++c) {
    name(model.threshold(c), "m", false, c);
    name(model.log_scale(c), "log s", model.sharing.scale, c);
    name(model.lapse(c), "l", model.sharing.lapse, c);
    if (model.ratings == 1) continue;
    name(model.first_cut(c), "t_2", model.sharing.criteria, c);
    for (int k = 3; k <= model.ratings; ++k)
      name(model.first_cut(c) + k - 2, fmt::format("log(t_{} - t_{})", k, k - 1), model.sharing.criteria, c);
    name(model.log_spread(c), "log rho", model.sharing.criteria, c);
    for (int r = 2; r <= model.ratings; ++r)
      name(model.first_guess(c) + r - 2, fmt::format("h_{}", r), model.sharing.guess_ratings, c);
  }
  if (model.between_people) name(model.log_between(), "log sd of thresholds", true, 0);
  return names;
}

JointCurve curve_at(const JointModel& model, const Eigen::VectorXd& theta, int curve) {
  JointCurve at;
  at.m = theta[model.threshold(curve)];
  at.s = std::exp(theta[model.log_scale(curve)]);
  at.lapse = most_lapse * logistic_of_lapse(theta[model.lapse(curve)]);
  at.ratings = model.ratings;
  if (model.ratings == 1) return at;
  const Eigen::Index cut = model.first_cut(curve);
  at.rho = std::exp(theta[model.log_spread(curve)]);
  double t = theta[cut];
  for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(model.ratings); ++k) {
    if (k > 0) t += std::exp(theta[cut + static_cast<Eigen::Index>(k)]);
    at.t[k] = t;
  }
  const auto h = theta.segment(model.first_guess(curve), model.ratings - 1);
  const double highest = std::max(0.0, h.maxCoeff());
  double sum = std::exp(-highest);
  for (Eigen::Index r = 0; r < h.size(); ++r) sum += std::exp(h[r] - highest);
  at.g[0] = std::exp(-highest) / sum;
  for (Eigen::Index r = 0; r < h.size(); ++r) at.g[r + 1] = std::exp(h[r] - highest) / sum;
  return at;
}

Eigen::VectorXd outcome_probabilities(const JointCurve& curve, double x, double chance) {
  const double z = (curve.m - x) / curve.s;
  const double seen = (1 - curve.lapse) * normal_of_z(z),
               unseen = curve.lapse + (1 - curve.lapse) * normal_of_z(-z);
  Eigen::VectorXd p(2 * curve.ratings);
  double above = 1;  // P(R >= r | seen)
  for (int r = 0; r < curve.ratings; ++r) {
    const bool last = r + 1 == curve.ratings;
    const double next = last ? 0 : normal_of_z((z - curve.t[r]) / curve.rho);
    const double guess = unseen * curve.g[r];
    p[r] = seen * std::max(0.0, above - next) + chance * guess;
    p[curve.ratings + r] = (1 - chance) * guess;
    above = next;
  }
  return p;
}

}  // namespace seamline::analysis
