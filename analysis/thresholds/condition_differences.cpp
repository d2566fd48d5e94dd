#include "analysis/thresholds/condition_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/isotonic.h"
#include "analysis/thresholds/closed_estimates.h"

namespace seamline::analysis {

namespace {

constexpr std::array<const char*, 3> threshold_names = {"PT", "SN", "IP"};
using Ranges = std::array<LevelInterval, threshold_names.size()>;

/// One condition of an artifact, of the people on the curves of all its conditions.
struct ConditionCurve {
  const ArtifactScores* scores = nullptr;
  std::vector<double> level_x;
  Eigen::Index first_column = 0;  ///< in the scores of all conditions side by side
};

/// Where a threshold may lie: a value, or beyond an end of what was tested.
LevelInterval within(LevelInterval range, const std::vector<double>& level_x) {
  if (range.low_x == above_every_level) range.low_x = level_x.back();
  if (range.high_x == below_every_level) range.high_x = level_x.front();
  return range;
}

Ranges ranges_of(const Logistic4Fitter& fitter, std::span<const double> means) {
  const std::vector<double>& level_x = fitter.level_x();
  const IsotonicFit fit = fit_non_increasing(means);
  const auto crossing = [&](double level) {
    const double x = largest_x_at(level, level_x, fit.value);
    return within({.low_x = x, .high_x = x}, level_x);
  };
  return {crossing(perceptual_level), crossing(slight_level),
          within(fitter.fit(means).centre_range, level_x)};
}

/// What a is more than b, when each lies anywhere in its range. No end is infinite less infinite: a low end
/// is never above every level, a high end never below.
LevelInterval difference(const LevelInterval& a, const LevelInterval& b) {
  return {.low_x = distance_between(a.low_x, b.high_x), .high_x = distance_between(a.high_x, b.low_x)};
}

/// A range of differences of x as one of levels.
LevelRange turned_back(const LevelAxis& axis, const LevelInterval& range) {
  const auto end = [&](double x) {
    if (std::isfinite(x)) return difference_at(axis, x);
    return axis.noticeability == Direction::increasing ? -x : x;
  };
  LevelRange levels{.low = end(range.low_x), .high = end(range.high_x)};
  if (axis.noticeability == Direction::increasing) std::swap(levels.low, levels.high);
  return levels;
}

std::string hundredths_text(double value) {
  const std::string text = fmt::format("{:.2f}", value);
  if (text == "-0.00") return "0.00";
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::string text_of(const ThresholdDifference& found) {
  const LevelRange &ci95 = found.ci95, &bounds = found.bounds;
  const bool low = std::isfinite(ci95.low), high = std::isfinite(ci95.high);
  if (!low && !high) return "not determined";
  if (!high) return "above " + hundredths_text(ci95.low);
  if (!low) return "below " + hundredths_text(ci95.high);
  const std::string text =
      bounds.low == bounds.high
          ? hundredths_text(*found.estimate)
          : fmt::format("between {} and {}", hundredths_text(bounds.low), hundredths_text(bounds.high));
  return fmt::format("{} ({} to {})", text, hundredths_text(ci95.low), hundredths_text(ci95.high));
}

/// The scores of those people of the first curve who are on all of them, conditions side by side.
Eigen::MatrixXd joint_scores(std::vector<ConditionCurve>& curves) {
  std::vector<std::vector<Eigen::Index>> rows;  // a person, the row in each curve
  const std::vector<std::string>& people = curves.front().scores->people;
  for (std::size_t p = 0; p < people.size(); ++p) {
    std::vector<Eigen::Index> own;
    for (const ConditionCurve& curve : curves) {
      const auto found = std::find(curve.scores->people.begin(), curve.scores->people.end(), people[p]);
      if (found != curve.scores->people.end()) own.push_back(found - curve.scores->people.begin());
    }
    if (own.size() == curves.size()) rows.push_back(own);
  }
  Eigen::Index columns = 0;
  for (ConditionCurve& curve : curves) {
    curve.first_column = columns;
    columns += static_cast<Eigen::Index>(curve.level_x.size());
  }
  Eigen::MatrixXd joint(static_cast<Eigen::Index>(rows.size()), columns);
  for (std::size_t p = 0; p < rows.size(); ++p)
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto width = static_cast<Eigen::Index>(curves[c].level_x.size());
      joint.row(static_cast<Eigen::Index>(p)).segment(curves[c].first_column, width) =
          curves[c].scores->noticeability.row(rows[p][c]).head(width);
    }
  return joint;
}

void add_differences(std::vector<ConditionCurve>& curves, const ResamplingRequest& request,
                     std::vector<ThresholdDifference>& differences) {
  const LevelAxis& axis = curves.front().scores->axis;
  const Eigen::MatrixXd joint = joint_scores(curves);
  const int people = joint.rows() > 0 ? mean_and_covariance(joint).fewest : 0;
  const std::size_t others = curves.size() - 1;
  std::vector<Logistic4Fitter> fitters;
  for (const ConditionCurve& curve : curves) fitters.emplace_back(curve.level_x);
  const auto differences_of = [&](const Eigen::VectorXd& mean) {
    std::vector<Ranges> ranges;
    for (std::size_t c = 0; c < curves.size(); ++c)
      ranges.push_back(
          ranges_of(fitters[c], {mean.data() + curves[c].first_column, curves[c].level_x.size()}));
    std::vector<Ranges> found(others);
    for (std::size_t c = 0; c < others; ++c)
      for (std::size_t q = 0; q < threshold_names.size(); ++q)
        found[c][q] = difference(ranges[c + 1][q], ranges[0][q]);
    return found;
  };
  std::vector<Ranges> estimates(others);  // open, when nobody is on all curves
  if (people > 0) estimates = differences_of(mean_and_covariance(joint).mean);
  std::vector<std::vector<Ranges>> replicates;
  if (people >= 2 && request.replicates > 0) {
    replicates.resize(request.replicates);
    for_each_replicate(joint, request, [&](int replicate, const Eigen::VectorXd& mean) {
      replicates[replicate] = differences_of(mean);
    });
  }
  for (std::size_t c = 0; c < others; ++c)
    for (std::size_t q = 0; q < threshold_names.size(); ++q) {
      const LevelInterval& range = estimates[c][q];
      ThresholdDifference found{.artifact = curves.front().scores->artifact,
                                .quantity = threshold_names[q],
                                .condition = curves[c + 1].scores->condition,
                                .to = curves.front().scores->condition,
                                .participants = static_cast<int>(joint.rows()),
                                .estimate = {},
                                .bounds = turned_back(axis, range),
                                .ci95 = {},
                                .text = {}};
      std::vector<LevelInterval> drawn;
      for (const std::vector<Ranges>& replicate : replicates) drawn.push_back(replicate[c][q]);
      ThresholdEstimate estimate;  // in differences of x
      if (!drawn.empty()) estimate.ci95 = percentile_interval(drawn, expanded_levels(people));
      keep_closed(estimate, range, axis);
      found.ci95 = turned_back(axis, estimate.ci95);
      if (estimate.level_x) found.estimate = difference_at(axis, *estimate.level_x);
      found.text = text_of(found);
      differences.push_back(found);
    }
}

}  // namespace

std::vector<ThresholdDifference> threshold_differences(const NoticeabilityData& data,
                                                       const ResamplingRequest& request) {
  std::vector<ThresholdDifference> differences;
  for (std::size_t first = 0; first < data.artifacts.size();) {
    std::vector<ConditionCurve> curves;
    std::size_t next = first;
    for (; next < data.artifacts.size() && data.artifacts[next].artifact == data.artifacts[first].artifact;
         ++next) {
      ConditionCurve curve{.scores = &data.artifacts[next], .level_x = levels_on_axis(data.artifacts[next])};
      if (!curve.level_x.empty()) curves.push_back(std::move(curve));
    }
    if (curves.size() > 1 && curves.front().scores->condition == data.conditions.front())
      add_differences(curves, request, differences);
    first = next;
  }
  return differences;
}

}  // namespace seamline::analysis
