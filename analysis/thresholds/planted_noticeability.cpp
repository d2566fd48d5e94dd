#include "analysis/thresholds/planted_noticeability.h"

#include <cmath>

#include "study/observers/observer.h"

namespace seamline::analysis {

std::optional<double> planted_midpoint(const ObserverDefinition& observer, Artifact artifact,
                                       const std::string& condition) {
  const auto own = observer.condition_midpoint.find(condition);
  const std::map<Artifact, double>& midpoint =
      own == observer.condition_midpoint.end() ? observer.midpoint : own->second;
  const auto found = midpoint.find(artifact);
  return found == midpoint.end() ? std::nullopt : std::optional(found->second);
}

double planted_noticeability(const ObserverDefinition& observer, const LevelAxis& axis, double midpoint,
                             double level) {
  // Every axis is looked at as octaves of widths, which is what `expected_noticeability` knows: only the
  // distance from the midpoint in scales counts.
  constexpr Artifact any = Artifact::receiver;
  ObserverDefinition as_widths = observer;
  as_widths.direction = Direction::decreasing;
  if (of_depth_widths(axis) && axis.noticeability == Direction::decreasing) {
    as_widths.midpoint[any] = midpoint;
    return study::expected_noticeability(as_widths, any, level);
  }
  const double past = x_of(axis, level) - x_of(axis, midpoint);
  as_widths.midpoint[any] = 1;
  if (is_linear(axis)) {
    as_widths.scale_octaves = observer.scale_linear / axis.unit;
    as_widths.people_sd_octaves = observer.people_sd_linear / axis.unit;
  }
  return study::expected_noticeability(as_widths, any, std::exp2(past));
}

double falling_crossing(const std::function<double(double x)>& falling, double value, double low_x,
                        double high_x) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle_x = low_x + (high_x - low_x) / 2;
    (falling(middle_x) > value ? low_x : high_x) = middle_x;
  }
  return low_x + (high_x - low_x) / 2;
}

PlantedThresholds planted_thresholds(const ObserverDefinition& observer, const LevelAxis& axis,
                                     double midpoint, const std::vector<double>& levels) {
  const bool linear = is_linear(axis);
  const double scale_x = linear ? observer.scale_linear / axis.unit : observer.scale_octaves;
  const double people_x = linear ? observer.people_sd_linear / axis.unit : observer.people_sd_octaves;
  const double reach_x = 40 * scale_x + 10 * people_x, middle_x = x_of(axis, midpoint);
  const auto mean_at = [&](double x) {
    return planted_noticeability(observer, axis, midpoint, level_at(axis, x));
  };
  const auto crossing = [&](double level) {
    return falling_crossing(mean_at, level, middle_x - reach_x, middle_x + reach_x);
  };
  PlantedThresholds planted{.perceptual_x = crossing(perceptual_level),
                            .slightly_noticeable_x = crossing(slight_level),
                            .inflection_x = 0,
                            .limit = {}};
  // Before the steepest place the curve bends down, behind it up.
  const double step_x = 0.02 * (scale_x + people_x);
  const auto bend_at = [&](double x) { return 2 * mean_at(x) - mean_at(x - step_x) - mean_at(x + step_x); };
  planted.inflection_x = falling_crossing(bend_at, 0, crossing(3.5), crossing(0.5));
  std::vector<double> level_x, expected;
  for (const double level : levels) {
    level_x.push_back(x_of(axis, level));
    expected.push_back(planted_noticeability(observer, axis, midpoint, level));
  }
  planted.limit = thresholds_of_means(level_x, expected, axis);
  return planted;
}

}  // namespace seamline::analysis
