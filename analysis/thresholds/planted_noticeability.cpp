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

}  // namespace seamline::analysis
