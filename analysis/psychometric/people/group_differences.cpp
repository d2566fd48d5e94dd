#include "analysis/psychometric/people/group_differences.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/ordinal/contrasts/contrasts.h"
#include "analysis/statistics/distributions.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double z_of_95 = 1.959963984540054;

/// An estimate and its interval on the scale on which groups are compared.
struct ComparedValue {
  std::optional<double> estimate;
  Interval ci95;
};

ComparedValue compared_threshold(const JudgedFit& fit) {
  const auto on_axis = [&](double level) {
    return std::isfinite(level) ? axis_value(fit.fit.options.axis, level) : level;
  };
  ComparedValue value{
      .estimate = {},
      .ci95 = {.low = on_axis(fit.threshold_ci95.low), .high = on_axis(fit.threshold_ci95.high)}};
  if (fit.threshold) value.estimate = on_axis(*fit.threshold);
  return value;
}

ComparedValue compared_width(const JudgedFit& fit) {
  if (!fit.threshold || fit.fit.is_step || !std::isfinite(fit.width_ci95.high)) return {};
  return {.estimate = std::log2(fit.fit.width),
          .ci95 = {.low = std::log2(fit.width_ci95.low), .high = std::log2(fit.width_ci95.high)}};
}

GroupDifference difference_of_profiles(const ComparedValue& first, const ComparedValue& second) {
  GroupDifference difference{.estimate = {}, .ci95 = {}, .p = nan, .adjusted_p = nan};
  if (!first.estimate || !second.estimate) return difference;
  const double d = *second.estimate - *first.estimate;
  difference.estimate = d;
  difference.ci95 = {
      .low = d - std::hypot(*second.estimate - second.ci95.low, first.ci95.high - *first.estimate),
      .high = d + std::hypot(second.ci95.high - *second.estimate, *first.estimate - first.ci95.low)};
  const double towards_zero = d > 0 ? d - difference.ci95.low : difference.ci95.high - d;
  if (std::isfinite(towards_zero) && towards_zero > 0)
    difference.p = std::min(1.0, 2 * normal_above(z_of_95 * std::abs(d) / towards_zero));
  return difference;
}

/// Variance and degrees of freedom of a difference.
struct DifferenceScatter {
  double variance = 0, degrees_of_freedom = 0;
};

double jackknife_variance_of(const Eigen::VectorXd& moves) {
  const double n = moves.size();
  return (n - 1) / n * (moves.array() - moves.mean()).square().sum();
}

DifferenceScatter scatter_of(const FittedGroup& first, const FittedGroup& second, int column) {
  std::map<std::size_t, double> moves;  // of everybody in either group
  std::size_t in_both = 0;
  for (std::size_t p = 0; p < first.people.size(); ++p)
    moves[first.people[p]] = -first.mixed->left_out(static_cast<Eigen::Index>(p), column);
  for (std::size_t p = 0; p < second.people.size(); ++p) {
    const auto [at, is_new] = moves.emplace(second.people[p], 0);
    in_both += is_new ? 0 : 1;
    at->second += second.mixed->left_out(static_cast<Eigen::Index>(p), column);
  }
  const auto n1 = static_cast<double>(first.people.size()), n2 = static_cast<double>(second.people.size());
  if (in_both == 0) {
    const double v1 = jackknife_variance_of(first.mixed->left_out.col(column)),
                 v2 = jackknife_variance_of(second.mixed->left_out.col(column));
    const double sum = v1 + v2;
    return {.variance = sum, .degrees_of_freedom = sum * sum / (v1 * v1 / (n1 - 1) + v2 * v2 / (n2 - 1))};
  }
  Eigen::VectorXd all(static_cast<Eigen::Index>(moves.size()));
  Eigen::Index at = 0;
  for (const auto& [person, move] : moves) all[at++] = move;
  return {.variance = jackknife_variance_of(all), .degrees_of_freedom = std::min(n1, n2) - 1};
}

GroupDifference difference_over_people(const FittedGroup& first, const FittedGroup& second, int column) {
  GroupDifference difference{.estimate = {}, .ci95 = {}, .p = nan, .adjusted_p = nan};
  const PeopleFit &a = *first.mixed, &b = *second.mixed;
  if (!a.identified || !b.identified) return difference;
  const study::Axis axis = first.sums.fit.options.axis;
  const double d = column == 0 ? axis_value(axis, b.threshold) - axis_value(axis, a.threshold)
                               : std::log2(b.width / a.width);
  DifferenceScatter scatter = scatter_of(first, second, column);
  scatter.variance = std::max(scatter.variance, a.noise[column] + b.noise[column]);
  const double se = std::sqrt(scatter.variance);
  difference.estimate = d;
  if (!(se > 0) || !std::isfinite(scatter.degrees_of_freedom)) return difference;
  const double t = student_quantile(scatter.degrees_of_freedom, 0.975);
  difference.ci95 = {.low = d - t * se, .high = d + t * se};
  difference.p = std::min(1.0, 2 * student_above(scatter.degrees_of_freedom, std::abs(d) / se));
  return difference;
}

/// Of the pairs that were tested, all together.
void adjust(std::vector<GroupPair>& pairs, GroupDifference GroupPair::*quantity) {
  std::vector<double> p;
  for (const GroupPair& pair : pairs) p.push_back((pair.*quantity).p);
  const std::vector<double> adjusted = holm_adjusted(p);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (!std::isnan(p[i])) (pairs[i].*quantity).adjusted_p = adjusted[i];
}

}  // namespace

std::vector<GroupPair> group_pairs(const std::vector<FittedGroup>& groups) {
  std::vector<GroupPair> pairs;
  for (std::size_t second = 1; second < groups.size(); ++second)
    for (std::size_t first = 0; first < second; ++first) {
      const FittedGroup &a = groups[first], &b = groups[second];
      GroupPair pair{.first = first, .second = second, .threshold = {}, .log2_width = {}};
      if (a.mixed && b.mixed) {
        pair.threshold = difference_over_people(a, b, 0);
        pair.log2_width = difference_over_people(a, b, 1);
      } else {
        pair.threshold = difference_of_profiles(compared_threshold(a.sums), compared_threshold(b.sums));
        pair.log2_width = difference_of_profiles(compared_width(a.sums), compared_width(b.sums));
      }
      pairs.push_back(pair);
    }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const GroupPair& a, const GroupPair& b) { return a.first < b.first; });
  adjust(pairs, &GroupPair::threshold);
  adjust(pairs, &GroupPair::log2_width);
  return pairs;
}

}  // namespace seamline::analysis
