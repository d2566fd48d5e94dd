#pragma once
#include <string>
#include <vector>

#include "analysis/statistics/estimate.h"
#include "stimuli/definition/quantity.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// Where the levels of a log lie. Everything is computed on a coordinate x on which noticeability falls:
///
///     x = a(level) where noticeability falls with the level, x = -a(level) where it rises,
///     a(level) = log2 level, or level / unit on linear axes
///
/// and turned back for results. A level that stands apart ("none": 0 on a log2 axis) has no x.
struct LevelAxis {
  Quantity quantity = Quantity::depth_width_px;
  Direction noticeability = Direction::decreasing;
  /// On linear axes: a sixth of the range tested, so that searches made for about six octaves of widths fit.
  double unit = 1;

  auto operator<=>(const LevelAxis&) const = default;
};

/// The axis of a log's answers.
[[nodiscard]] LevelAxis level_axis(const study::LogContents& log);

[[nodiscard]] bool is_linear(const LevelAxis& axis);
[[nodiscard]] bool stands_apart(const LevelAxis& axis, double level);
[[nodiscard]] bool of_depth_widths(const LevelAxis& axis);

/// `level` must not stand apart.
[[nodiscard]] double x_of(const LevelAxis& axis, double level);
[[nodiscard]] double level_at(const LevelAxis& axis, double level_x);

/// Whether `a` comes before `b` along a curve: by x, what stands apart last.
[[nodiscard]] bool comes_before(const LevelAxis& axis, double a, double b);

/// x of those levels that do not stand apart. `levels` are in the order of `comes_before`.
[[nodiscard]] std::vector<double> x_of_levels(const LevelAxis& axis, const std::vector<double>& levels);

/// A difference of two x as one of levels: in octaves (positive: the larger level), or in the quantity's
/// unit.
[[nodiscard]] double difference_at(const LevelAxis& axis, double difference_x);

/// A range of levels; an infinite end is open, also at the lower end of a log2 axis.
struct LevelRange {
  double low = -infinity, high = infinity;
};
[[nodiscard]] LevelRange range_at(const LevelAxis& axis, const LevelInterval& interval);

// Names. Those of widths are as the files of earlier versions have them.

/// "width", or "level" of other quantities.
[[nodiscard]] std::string level_word(const LevelAxis& axis);
/// Of a column or field that holds levels: "width_px", or the quantity's key.
[[nodiscard]] std::string level_key(const LevelAxis& axis);
/// At the end of names of estimates: "_px"; empty for ratios.
[[nodiscard]] std::string unit_suffix(const LevelAxis& axis);
/// Of lengths along the axis: "octaves", or the unit's key ("deg").
[[nodiscard]] std::string length_key(const LevelAxis& axis);
/// The same for people: "octaves", "degrees".
[[nodiscard]] std::string length_unit(const LevelAxis& axis);
/// "depth map width W (px)", "mesh tolerance", "angular radius of the sun (degrees)".
[[nodiscard]] std::string axis_title(const LevelAxis& axis);
/// A tested level: "512", "0.0001", "none".
[[nodiscard]] std::string tested_text(const LevelAxis& axis, double level);
/// An estimated level, with as many digits as it deserves: "426", "0.000123".
[[nodiscard]] std::string estimated_text(const LevelAxis& axis, double level);

}  // namespace seamline::analysis
