#include "analysis/joint/joint_quantities.h"

#include <algorithm>
#include <cmath>

#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

namespace {

constexpr double farthest_z = 38;
constexpr int bisections = 70;
constexpr double detected_share = 0.5;

/// Adds a curve's derivatives by its shape, times a factor.
void add_shape(const JointModel& model, int curve, const MeanAtZ::ByShape& shape, double factor,
               Eigen::VectorXd& gradient) {
  gradient[model.lapse(curve)] += factor * shape.lapse;
  if (model.ratings == 1) return;
  gradient[model.log_spread(curve)] += factor * shape.spread;
  for (Eigen::Index k = 0; k < model.ratings - 1; ++k) {
    gradient[model.first_cut(curve) + k] += factor * shape.cut[k];
    gradient[model.first_guess(curve) + k] += factor * shape.guess[k];
  }
}

/// z where a function that is positive at `high` and not at `low` changes its sign.
template <class Function>
double sign_change(double low, double high, const Function& function) {
  for (int i = 0; i < bisections; ++i) {
    const double middle = (low + high) / 2;
    (function(middle) > 0 ? high : low) = middle;
  }
  return (low + high) / 2;
}

/// x = m - s z with z's derivative by the shape: -by / slope.
JointPlace place_from(const JointModel& model, const JointCurve& at, int curve, double z,
                      const MeanAtZ::ByShape& by, double slope) {
  JointPlace place{.x = at.m - at.s * z, .gradient = Eigen::VectorXd::Zero(model.parameters())};
  place.gradient[model.threshold(curve)] = 1;
  place.gradient[model.log_scale(curve)] = -at.s * z;
  add_shape(model, curve, by, at.s / slope, place.gradient);
  return place;
}

std::optional<JointPlace> place_of_mean(const JointModel& model, const JointCurve& at, int curve,
                                        const SoughtMean& sought) {
  const double chance = chance_of_curve(model, curve);
  const auto above = [&](double z) { return mean_at_z(at, sought.mean, chance, z).z[0] - sought.level; };
  if (floor_of_mean(at, sought.mean, chance) >= sought.level || above(farthest_z) <= 0) return std::nullopt;
  const double z = sign_change(-farthest_z, farthest_z, above);
  const MeanAtZ there = mean_at_z(at, sought.mean, chance, z);
  if (!(there.z[1] > 0)) return std::nullopt;
  return place_from(model, at, curve, z, there.value, there.z[1]);
}

/// The steepest place: the greatest E' of a grid, then E'' = 0 beside it.
std::optional<JointPlace> place_of_inflection(const JointModel& model, const JointCurve& at, int curve) {
  const double chance = chance_of_curve(model, curve);
  constexpr int places = 81;
  const double least = std::min(-4.0, at.t[0] - 4 * at.rho),
               most = std::max(4.0, at.t[model.ratings - 2] + 4 * at.rho);
  const auto z_at = [&](int i) { return least + (most - least) * i / (places - 1); };
  int steepest = 0;
  double slope = 0;
  for (int i = 0; i < places; ++i)
    if (const double here = mean_at_z(at, JointMean::as_counted, chance, z_at(i)).z[1]; here > slope) {
      slope = here;
      steepest = i;
    }
  if (steepest == 0 || steepest + 1 == places) return std::nullopt;
  const double z = sign_change(z_at(steepest - 1), z_at(steepest + 1), [&](double tried) {
    return -mean_at_z(at, JointMean::as_counted, chance, tried).z[2];
  });
  const MeanAtZ there = mean_at_z(at, JointMean::as_counted, chance, z);
  if (!(there.z[3] < 0)) return std::nullopt;
  return place_from(model, at, curve, z, there.second, there.z[3]);
}

/// A mean of one curve at x.
MeanAtX mean_of_curve(const JointModel& model, const JointCurve& at, int curve, JointMean mean, double x,
                      double chance) {
  const double z = (at.m - x) / at.s;
  const MeanAtZ there = mean_at_z(at, mean, chance, z);
  MeanAtX found{.value = there.z[0],
                .slope = -there.z[1] / at.s,
                .gradient = Eigen::VectorXd::Zero(model.parameters())};
  found.gradient[model.threshold(curve)] = there.z[1] / at.s;
  found.gradient[model.log_scale(curve)] = -z * there.z[1];
  add_shape(model, curve, there.value, 1, found.gradient);
  return found;
}

double between_of(const JointModel& model, const Eigen::VectorXd& theta) {
  return model.between_people ? std::exp(theta[model.log_between()]) : 0;
}

/// The mean over people of the mean at x.
MeanAtX mean_of_people(const JointModel& model, const Eigen::VectorXd& theta, int curve, JointMean mean,
                       double x) {
  JointCurve at = curve_at(model, theta, curve);
  const double middle = at.m, between = between_of(model, theta), chance = chance_of_curve(model, curve);
  MeanAtX sum{.value = 0, .slope = 0, .gradient = Eigen::VectorXd::Zero(model.parameters())};
  for (const PeopleNode& node : people_nodes()) {
    const double shift = between * node.shift;
    at.m = middle + shift;
    const MeanAtX one = mean_of_curve(model, at, curve, mean, x, chance);
    sum.value += node.share * one.value;
    sum.slope += node.share * one.slope;
    sum.gradient += node.share * one.gradient;
    sum.gradient[model.log_between()] += node.share * one.gradient[model.threshold(curve)] * shift;
  }
  return sum;
}

/// Where the mean over people, which falls with x, reaches a level.
std::optional<JointPlace> place_of_people(const JointModel& model, const Eigen::VectorXd& theta, int curve,
                                          const SoughtMean& sought) {
  const JointCurve at = curve_at(model, theta, curve);
  const double reach = farthest_z * (at.s + between_of(model, theta));
  const auto above = [&](double x) {
    return mean_at_x(model, theta, curve, sought.mean, x).value - sought.level;
  };
  if (above(at.m + reach) >= 0 || above(at.m - reach) <= 0) return std::nullopt;
  const double x = sign_change(at.m + reach, at.m - reach, above);
  const MeanAtX there = mean_at_x(model, theta, curve, sought.mean, x);
  if (!(there.slope < 0)) return std::nullopt;
  return JointPlace{.x = x, .gradient = -there.gradient / there.slope};
}

std::vector<PeopleNode> make_people_nodes() {
  constexpr int steps = 20;  // each way, of a quarter of a standard deviation
  std::vector<PeopleNode> nodes;
  double sum = 0;
  for (int i = -steps; i <= steps; ++i) {
    const double z = i / 4.0;
    nodes.push_back({.shift = z, .share = std::exp(-z * z / 2)});
    sum += nodes.back().share;
  }
  for (PeopleNode& node : nodes) node.share /= sum;
  return nodes;
}

}  // namespace

const std::vector<PeopleNode>& people_nodes() {
  static const std::vector<PeopleNode> nodes = make_people_nodes();
  return nodes;
}

std::string_view word(JointQuantity quantity) {
  switch (quantity) {
    case JointQuantity::perceptual:
      return "PT";
    case JointQuantity::slightly_noticeable:
      return "SN";
    case JointQuantity::perceptual_corrected:
      return "PT corrected";
    case JointQuantity::slightly_noticeable_corrected:
      return "SN corrected";
    case JointQuantity::inflection:
      return "IP";
    case JointQuantity::detection:
      return "detection";
  }
  return "";
}

std::optional<SoughtMean> sought_mean(JointQuantity quantity) {
  switch (quantity) {
    case JointQuantity::perceptual:
      return SoughtMean{.mean = JointMean::as_counted, .level = perceptual_level};
    case JointQuantity::slightly_noticeable:
      return SoughtMean{.mean = JointMean::as_counted, .level = slight_level};
    case JointQuantity::perceptual_corrected:
      return SoughtMean{.mean = JointMean::seen, .level = perceptual_level};
    case JointQuantity::slightly_noticeable_corrected:
      return SoughtMean{.mean = JointMean::seen, .level = slight_level};
    case JointQuantity::detection:
      return SoughtMean{.mean = JointMean::detected, .level = detected_share};
    case JointQuantity::inflection:
      return std::nullopt;
  }
  return std::nullopt;
}

double chance_of_curve(const JointModel& model, int curve) {
  double sum = 0;
  int cells = 0;
  for (const JointCell& cell : model.cells)
    if (cell.curve == curve) {
      sum += cell.chance;
      ++cells;
    }
  return sum / cells;
}

std::optional<JointPlace> place_of(const JointModel& model, const Eigen::VectorXd& theta, int curve,
                                   JointQuantity quantity) {
  const JointCurve at = curve_at(model, theta, curve);
  if (model.ratings == 1 && quantity != JointQuantity::detection) return std::nullopt;
  const std::optional<SoughtMean> sought = sought_mean(quantity);
  if (model.between_people) return sought ? place_of_people(model, theta, curve, *sought) : std::nullopt;
  if (sought) return place_of_mean(model, at, curve, *sought);
  return place_of_inflection(model, at, curve);
}

MeanAtX mean_at_x(const JointModel& model, const Eigen::VectorXd& theta, int curve, JointMean mean,
                  double x) {
  if (model.between_people) return mean_of_people(model, theta, curve, mean, x);
  return mean_of_curve(model, curve_at(model, theta, curve), curve, mean, x, chance_of_curve(model, curve));
}

MeanAtX floor_at(const JointModel& model, const Eigen::VectorXd& theta, int curve, JointMean mean) {
  const double beyond = farthest_z * (std::exp(theta[model.log_scale(curve)]) + between_of(model, theta));
  return mean_at_x(model, theta, curve, mean, theta[model.threshold(curve)] + beyond);
}

}  // namespace seamline::analysis
