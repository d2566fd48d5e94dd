#include "sets/pages/errors_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "support/files/gnuplot.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

constexpr int width_px = 900, height_px = 520;

/// Point types of gnuplot: circle, square, triangle, diamond, each hollow and filled.
struct PointType {
  int hollow, filled;
};
constexpr std::array<PointType, 4> point_types = {{{6, 7}, {4, 5}, {8, 9}, {12, 13}}};

std::string block_name(Artifact artifact, const char* what) {
  return fmt::format("${}_{}", word(artifact), what);
}

/// A data block of one artifact; empty when there is nothing in it.
template <class Error>
std::string block(const SetErrors& errors, Artifact artifact, const char* what, const Error& error) {
  std::string lines;
  for (const StimulusErrorRow& row : errors.rows) {
    const std::optional<double> value = error(row);
    if (row.artifact != artifact || !row.seconds || !value || !(*value > 0) || !(*row.seconds > 0)) continue;
    lines += fmt::format("{:.6g} {:.6g}\n", *row.seconds, *value);
  }
  return lines.empty() ? "" : fmt::format("{} << EOD\n{}EOD\n", block_name(artifact, what), lines);
}

/// Smallest and largest of what is drawn, a third beyond both.
struct Range {
  double from = 1.0 / 255, to = 1.0 / 255;
  void add(double value) {
    if (!(value > 0)) return;
    from = std::min(from, value / 1.33);
    to = std::max(to, value * 1.33);
  }
};

/// Labels that a narrow range of a logarithmic axis still has some of.
std::string ticks() {
  std::string list;
  for (const char* decade : {"1e-4", "1e-3", "1e-2", "1e-1", "1", "10", "100", "1000"})
    for (const char* step : {"1", "2", "3", "5"})
      list += fmt::format("{}{}*{}", list.empty() ? "" : ", ", step, decade);
  return "(" + list + ")";
}

/// Both axes: seconds and errors of every stimulus.
std::string axes(const SetErrors& errors) {
  Range seconds{1e30, 0}, error;
  error.add(1.0 / 255);
  for (const StimulusErrorRow& row : errors.rows) {
    seconds.add(row.seconds.value_or(0));
    error.add(row.estimated.value_or(0));
    if (row.measured) error.add(row.measured->rmse);
  }
  return fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset xtics {}\nset ytics {}\n", seconds.from,
                     seconds.to, error.from, error.to, ticks(), ticks());
}

std::string script(const SetErrors& errors) {
  std::string data, plots;
  std::size_t index = 0;
  for (const Artifact artifact : every_artifact) {
    const std::string estimated =
        block(errors, artifact, "estimated", [](const StimulusErrorRow& row) { return row.estimated; });
    const std::string measured =
        block(errors, artifact, "true", [](const StimulusErrorRow& row) -> std::optional<double> {
          return row.measured ? std::optional(row.measured->rmse) : std::nullopt;
        });
    if (estimated.empty() && measured.empty()) continue;
    const PointType type = point_types[index % point_types.size()];
    const auto plot = [&](const char* what, int point) {
      plots += fmt::format("{} with points pointtype {} pointsize 0.9 linecolor '{}' title '{}, {}', \\\n",
                           block_name(artifact, what), point, plot_style(index).colour, word(artifact), what);
    };
    if (!estimated.empty()) plot("estimated", type.hollow);
    if (!measured.empty()) plot("true", type.filled);
    data += estimated + measured;
    ++index;
  }
  if (plots.empty()) return "";
  return fmt::format(
      "{}set logscale xy\nset border 3 linecolor '{}'\nset tics nomirror textcolor '{}'\nset grid linecolor "
      "'#dddddd' linetype 1 linewidth 0.5\nset key outside right top\nset xlabel 'seconds of the stimulus'\n"
      "set ylabel 'RMSE (display units)'\nset format y '%g'\nset format x '%g'\n{}plot {}1.0/255 with lines "
      "dashtype 3 linecolor '{}' title 'one 8-bit "
      "step'\n",
      data, plot_ink, plot_ink, axes(errors), plots, plot_ink);
}

}  // namespace

std::optional<std::string> errors_figure(const SetErrors& errors) {
  const std::string text = script(errors);
  if (text.empty()) return std::nullopt;
  try {
    require_gnuplot();
  } catch (const InputError&) {
    return std::nullopt;
  }
  const std::string svg = drawn_svg(width_px, height_px, text);
  return svg.substr(std::min(svg.find("<svg"), svg.size()));
}

}  // namespace seamline::renderer
