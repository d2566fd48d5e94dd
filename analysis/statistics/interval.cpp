#include "analysis/statistics/interval.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/distributions.h"

namespace seamline::analysis {

namespace {

constexpr int isotonic_steps_per_gap = 128;

/// By how much the curve at one width is above (`over`) or below (`under`) the level, beyond what the test
/// allows. Positive: excluded.
struct Excess {
  double level_x = 0, over = 0, under = 0;
};

/// The isotonic curve a share `t` (0 to 1) of the way from width `left` to the next.
CurveAtX isotonic_at(double level, std::size_t left, double t, const IsotonicFit& fit,
                     const MeanVector& means, const VarianceFunction& variance_of) {
  const std::size_t right = std::min(left + 1, fit.value.size() - 1);
  const double g = (1 - t) * fit.value[left] + t * fit.value[right];
  const double to_null = level - g;  // moves the curve so that its value at w is the level
  const auto a = static_cast<Eigen::Index>(left), b = static_cast<Eigen::Index>(right);
  const double variance_a = means.covariance(a, a), variance_b = means.covariance(b, b);
  const double product = std::sqrt(variance_a * variance_b);
  const double correlation = product > 0 ? means.covariance(a, b) / product : 0;
  const double null_a = variance_of.at(fit.value[left] + to_null),
               null_b = variance_of.at(fit.value[right] + to_null);
  const double variance = (1 - t) * (1 - t) * null_a +
                          2 * t * (1 - t) * correlation * std::sqrt(null_a * null_b) + t * t * null_b;
  return {.value = g, .standard_error = std::sqrt(std::max(0.0, variance))};
}

/// Where a line through two points is zero.
double zero_between(double x0, double y0, double x1, double y1) {
  return y0 == y1 ? x0 : x0 + (x1 - x0) * y0 / (y0 - y1);
}

/// The curve does not rise with width: where it is above the level at some width, so it is at all coarser
/// ones.
double lower_bound_of(const std::vector<Excess>& tests) {
  const auto last =
      std::find_if(tests.rbegin(), tests.rend(), [](const Excess& test) { return test.over > 0; });
  if (last == tests.rend()) return below_every_level;
  if (last == tests.rbegin()) return above_every_level;
  return zero_between(last->level_x, last->over, (last - 1)->level_x, (last - 1)->over);
}

/// And where it is below the level, so it is at all finer ones.
double upper_bound_of(const std::vector<Excess>& tests) {
  const auto first =
      std::find_if(tests.begin(), tests.end(), [](const Excess& test) { return test.under > 0; });
  if (first == tests.end()) return above_every_level;
  if (first == tests.begin()) return below_every_level;
  return zero_between((first - 1)->level_x, (first - 1)->under, first->level_x, first->under);
}

}  // namespace

VarianceFunction::VarianceFunction(const IsotonicFit& fit, const MeanVector& means) {
  for (std::size_t begin = 0; begin < fit.value.size(); begin = fit.block_end[begin]) {
    const auto count = static_cast<Eigen::Index>(fit.block_end[begin] - begin);
    mean_.push_back(fit.value[begin]);
    variance_.push_back(means.covariance.diagonal().segment(static_cast<Eigen::Index>(begin), count).mean());
  }
}

double VarianceFunction::at(double mean) const {
  if (mean >= mean_.front()) return variance_.front();
  for (std::size_t right = 1; right < mean_.size(); ++right) {
    if (mean < mean_[right]) continue;
    const double t = (mean_[right - 1] - mean) / (mean_[right - 1] - mean_[right]);
    return (1 - t) * variance_[right - 1] + t * variance_[right];
  }
  return variance_.back();
}

LevelInterval level_interval(double level, const std::vector<double>& level_x, const MeanVector& means,
                             int people) {
  const IsotonicFit fit =
      fit_non_increasing({means.mean.data(), static_cast<std::size_t>(means.mean.size())});
  const VarianceFunction variance_of(fit, means);
  const LevelInterval interval = invert_level_test(
      level, level_x, people, isotonic_steps_per_gap,
      [&](std::size_t left, double t) { return isotonic_at(level, left, t, fit, means, variance_of); });
  const double estimate = largest_x_at(level, level_x, fit.value);
  return {.low_x = std::min(interval.low_x, estimate), .high_x = std::max(interval.high_x, estimate)};
}

LevelInterval invert_level_test(double level, const std::vector<double>& level_x, int people,
                                int steps_per_gap,
                                const std::function<CurveAtX(std::size_t, double)>& curve_at) {
  assert(people >= 2 && !level_x.empty());
  const double critical = student_quantile(people - 1, (1 + confidence) / 2);
  std::vector<Excess> tests;
  for (std::size_t left = 0; left < level_x.size(); ++left) {
    const int steps = left + 1 < level_x.size() ? steps_per_gap : 1;
    for (int step = 0; step < steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      const double w = step == 0 ? level_x[left] : (1 - t) * level_x[left] + t * level_x[left + 1];
      const CurveAtX curve = curve_at(left, t);
      const double allowed = critical * curve.standard_error;
      tests.push_back(
          {.level_x = w, .over = curve.value - level - allowed, .under = level - curve.value - allowed});
    }
  }
  return {.low_x = lower_bound_of(tests), .high_x = upper_bound_of(tests)};
}

double distance_between(double end_x, double other_end_x) {
  if (std::isinf(end_x) && end_x == other_end_x)
    throw std::logic_error("the distance of two ends that are open on the same side");
  return end_x - other_end_x;
}

std::optional<double> length_x(const LevelInterval& interval) {
  if (!std::isfinite(interval.low_x) || !std::isfinite(interval.high_x)) return std::nullopt;
  return distance_between(interval.high_x, interval.low_x);
}

TailLevels expanded_levels(int people) {
  if (people < 2) return {.low = 0, .high = 1};
  const double n = people;
  const double low =
      normal_below(-std::sqrt(n / (n - 1)) * student_quantile(people - 1, (1 + confidence) / 2));
  return {.low = low, .high = 1 - low};
}

LevelInterval percentile_interval(const std::vector<LevelInterval>& replicates, const TailLevels& levels) {
  std::vector<double> lows, highs;
  for (const LevelInterval& replicate : replicates) {
    lows.push_back(replicate.low_x);
    highs.push_back(replicate.high_x);
  }
  return {.low_x = quantile(lows, levels.low), .high_x = quantile(highs, levels.high)};
}

void require_ordered(std::span<const double> values) {
  if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
    throw std::logic_error("a NaN among values that are put in order");
}

double quantile(std::vector<double>& values, double probability) {
  assert(!values.empty());
  require_ordered(values);
  const double place = probability * static_cast<double>(values.size() - 1);
  const double share = place - std::floor(place);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), middle, values.end());
  if (share == 0 || middle + 1 == values.end()) return *middle;
  const double next = *std::min_element(middle + 1, values.end());
  if (std::isfinite(*middle) && std::isfinite(next)) return *middle + share * (next - *middle);
  return share < 0.5 ? *middle : next;
}

}  // namespace seamline::analysis
