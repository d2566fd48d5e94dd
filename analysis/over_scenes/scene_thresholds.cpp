#include "analysis/over_scenes/scene_thresholds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/joint/joint_people.h"

namespace seamline::analysis {

namespace {

/// As `level_pivot` has it: the logarithm of the scale counts as known with this standard error.
constexpr double scale_error = 0.05;

/// What the scenes' thresholds rest on.
struct SceneFit {
  const SceneCurves& curves;
  JointFit fit;
  JointJackknife left_out;
};

/// Levels tested and one gap beyond, as thresholds of the joint model may lie.
LevelInterval range_with_gap(const JointData& data) {
  LevelInterval range{.low_x = infinity, .high_x = -infinity};
  double gap = 0;
  for (int curve = 0; curve < std::ssize(data.curves); ++curve) {
    const std::vector<double> levels = levels_of_curve(data, curve);
    for (std::size_t l = 1; l < levels.size(); ++l) gap = std::max(gap, levels[l] - levels[l - 1]);
    if (levels.empty()) continue;
    range = {.low_x = std::min(range.low_x, levels.front()), .high_x = std::max(range.high_x, levels.back())};
  }
  return {.low_x = range.low_x - gap, .high_x = range.high_x + gap};
}

LevelInterval interval_about(double x, double half, const LevelInterval& range) {
  LevelInterval interval;
  if (x - half >= range.low_x) interval.low_x = x - half;
  if (x + half <= range.high_x) interval.high_x = x + half;
  return interval;
}

/// Which scenes have no threshold within the range; one reason for all where the level lies in the floor.
std::string reason_of_scenes(const std::vector<SceneThreshold>& scenes, const LevelInterval& range) {
  std::vector<std::string> without;
  for (const SceneThreshold& one : scenes) {
    if (one.here.reason == NoThreshold::guess_floor) return std::string(sentence(*one.here.reason));
    const bool near = !std::isnan(one.x) && one.x >= range.low_x && one.x <= range.high_x;
    if (!near) without.push_back(one.scene);
  }
  if (without.empty()) return "";
  return fmt::format("no threshold near the levels tested in {} of {} scenes ({})", without.size(),
                     scenes.size(), fmt::join(without, ", "));
}

ThresholdOverScenes over_scenes(const SceneFit& of, JointQuantity quantity) {
  const auto scenes = static_cast<Eigen::Index>(of.curves.scenes.size());
  ThresholdOverScenes found{.quantity = quantity,
                            .scenes = {},
                            .reason = {},
                            .spreads = {.mean_x = nan,
                                        .people_variance = nan,
                                        .scenes_variance = nan,
                                        .between_scenes = nan,
                                        .people_degrees = nan,
                                        .degrees = nan},
                            .these = {},
                            .like_these = {}};
  Eigen::VectorXd x = Eigen::VectorXd::Constant(scenes, nan);
  Eigen::MatrixXd gradients = Eigen::MatrixXd::Zero(of.fit.theta.size(), scenes);
  for (Eigen::Index s = 0; s < scenes; ++s) {
    const auto curve = static_cast<int>(s);
    const JointThreshold threshold = joint_threshold(of.fit, of.curves.data, of.left_out, curve, quantity);
    const bool known = of.fit.estimated(curve);
    const std::optional<JointPlace> place =
        known ? place_of(of.fit.model, of.fit.theta, curve, quantity) : std::nullopt;
    if (place) {
      x[s] = place->x;
      gradients.col(s) = place->gradient;
    }
    found.scenes.push_back({.scene = of.curves.scenes[s], .x = x[s], .here = threshold.here});
  }
  const LevelInterval range = range_with_gap(of.curves.data);
  found.reason = reason_of_scenes(found.scenes, range);
  if (!found.reason.empty()) return found;
  const double of_form = scale_error * gradients.row(of.fit.model.log_scale(0)).mean();
  found.spreads = two_spreads(x, gradients.transpose() * of.left_out.covariance * gradients, of.fit.people,
                              of_form * of_form);
  found.these = interval_about(found.spreads.mean_x, found.spreads.half_these(), range);
  found.like_these = interval_about(found.spreads.mean_x, found.spreads.half_like_these(), range);
  return found;
}

}  // namespace

CurveOverScenes threshold_over_scenes(const SceneCurves& curves, int threads) {
  CurveOverScenes over{.artifact = curves.artifact,
                       .condition = curves.condition,
                       .scenes = curves.scenes,
                       .people = static_cast<int>(curves.data.people.size()),
                       .between_people = nan,
                       .people_by_scenes = nan,
                       .thresholds = {}};
  SceneFit of{.curves = curves, .fit = fit_joint(curves.data), .left_out = {}};
  if (of.fit.estimated()) {
    of.left_out = leave_people_out(of.fit, curves.data, threads);
    const JointPeople people = joint_people(of.fit, curves.data);
    over.between_people = people.shift_sd;
    over.people_by_scenes = people.curve_sd;
  }
  for (const JointQuantity quantity : every_joint_quantity) {
    if (curves.data.ratings == 1 && quantity != JointQuantity::detection) continue;
    if (!of.fit.estimated()) {
      over.thresholds.push_back({.quantity = quantity,
                                 .scenes = {},
                                 .reason = of.fit.explanation,
                                 .spreads = {.mean_x = nan, .between_scenes = nan},
                                 .these = {},
                                 .like_these = {}});
      continue;
    }
    over.thresholds.push_back(over_scenes(of, quantity));
  }
  return over;
}

}  // namespace seamline::analysis
