#include "support/files/plot_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "support/files/gnuplot.h"

namespace seamline {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Adds room at both ends, as shares of the axis, which is logarithmic.
  [[nodiscard]] Range with_room(double share_low, double share_high) const {
    if (!(high > 0)) return {0.1, 10};
    const double axis = std::max(std::log(high / low), std::log(2.0)) / (1 - share_low - share_high);
    return {low * std::exp(-axis * share_low), high * std::exp(axis * share_high)};
  }
  [[nodiscard]] Range with_linear_room(double share) const {
    const double room = high > low ? share * (high - low) : 1;
    return high < low ? Range{0, 1} : Range{low - room, high + room};
  }
  [[nodiscard]] double decades() const { return std::log10(high / low); }
};

std::string range_text(char axis, const Range& range, bool falling) {
  return falling ? fmt::format("set {}range [{:.6g}:{:.6g}]\n", axis, range.high, range.low)
                 : fmt::format("set {}range [{:.6g}:{:.6g}]\n", axis, range.low, range.high);
}

/// The command that sets an axis' range, and ticks that are neither crowded nor alone.
std::string axis_text(char axis, const Range& range, bool falling) {
  std::string text = range_text(axis, range, falling);
  if (range.decades() > 2.7)
    return text + fmt::format("set {0}tics auto\nset format {0} '10^{{%T}}'\n", axis);
  std::string ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.low)));
  std::vector<double> digits = {1, 2, 5};
  if (range.decades() > 2.2) digits = {1};
  if (range.decades() < 0.5) digits = {1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9};
  for (int decade = first; decade <= first + 5; ++decade)
    for (const double digit : digits) {
      const double tick = digit * std::pow(10.0, decade);
      if (tick < range.low || tick > range.high) continue;
      ticks += fmt::format("{0}'{1:g}' {1:g}", ticks.empty() ? "" : ", ", tick);
    }
  return text + fmt::format("set {}tics ({})\n", axis, ticks);
}

bool has_place(const PlotPanel& panel, double x) {
  return std::isfinite(x) && (panel.linear_x || x > 0);
}

bool can_be_drawn(const PlotPanel& panel, const std::pair<double, double>& point) {
  return has_place(panel, point.first) && point.second > 0 && std::isfinite(point.second);
}

/// Of the panel's height.
double key_share(const PlotPanel& panel) {
  if (panel.key == PlotKey::none) return 0.07;
  const auto named = std::count_if(panel.lines.begin(), panel.lines.end(),
                                   [](const PlotLine& line) { return !line.title.empty(); });
  return 0.055 * (static_cast<double>(named) + static_cast<double>(panel.guides.size())) + 0.06;
}

struct Axes {
  Range x, y;
};

Axes axes_of(const PlotPanel& panel) {
  Axes axes;
  for (const PlotLine& line : panel.lines)
    for (const auto& point : line.points) {
      if (has_place(panel, point.first)) axes.x.include(point.first);
      if (can_be_drawn(panel, point)) axes.y.include(point.second);
    }
  for (const PlotMark& mark : panel.marks) (mark.vertical ? axes.x : axes.y).include(mark.at);
  if (panel.y_room)
    for (const double y : {panel.y_room->first, panel.y_room->second}) axes.y.include(y);
  // The key stands above the data.
  return {panel.linear_x ? axes.x.with_linear_room(0.06) : axes.x.with_room(0.06, 0.06),
          axes.y.with_room(0.07, key_share(panel))};
}

std::string ticks_text(const std::vector<PlotTick>& ticks) {
  std::string list;
  for (const PlotTick& tick : ticks)
    list += fmt::format("{}\"{}\" {:.8g}", list.empty() ? "" : ", ", gnuplot_text(tick.label), tick.at);
  return "set xtics (" + list + ")\n";
}

std::string axes_text(const PlotPanel& panel, const Axes& axes) {
  if (panel.linear_x || !panel.x_ticks.empty())
    return range_text('x', axes.x, panel.falling_x) +
           (panel.x_ticks.empty() ? "set xtics auto\n" : ticks_text(panel.x_ticks)) +
           axis_text('y', axes.y, false);
  const std::string text = axis_text('x', axes.x, panel.falling_x) + axis_text('y', axes.y, false);
  if (!panel.powers_of_two) return text;
  std::set<double> ticks;
  for (const PlotLine& line : panel.lines)
    for (const auto& point : line.points) ticks.insert(point.first);
  std::string list;
  for (const double tick : ticks) list += fmt::format("{}'{:g}' {:g}", list.empty() ? "" : ", ", tick, tick);
  return text + (list.empty() ? "" : "set xtics (" + list + ")\n");
}

bool is_zero(const PlotPanel& panel, const std::pair<double, double>& point) {
  return has_place(panel, point.first) && point.second == 0;
}

/// Data blocks of all lines; of their zeros, which lie at the lower end of the axis; and of the guides.
std::string blocks(const PlotPanel& panel, const Axes& axes, std::size_t panel_index) {
  std::string text;
  for (std::size_t i = 0; i < panel.lines.size(); ++i) {
    text += fmt::format("$p{}l{} << EOD\n", panel_index, i);
    for (const auto& point : panel.lines[i].points)
      if (can_be_drawn(panel, point)) text += fmt::format("{:.8g} {:.8g}\n", point.first, point.second);
    text += fmt::format("EOD\n$p{}z{} << EOD\n", panel_index, i);
    for (const auto& point : panel.lines[i].points)
      if (is_zero(panel, point)) text += fmt::format("{:.8g} {:.8g}\n", point.first, axes.y.low * 1.0001);
    text += "EOD\n";
  }
  for (std::size_t i = 0; i < panel.guides.size(); ++i) {
    const PlotGuide& guide = panel.guides[i];
    text += fmt::format("$p{}g{} << EOD\n", panel_index, i);
    for (const double x : {guide.x_from, guide.x_to})
      text += fmt::format("{:.8g} {:.8g}\n", x, guide.y * std::pow(x / guide.x, guide.slope));
    text += "EOD\n";
  }
  return text;
}

/// Labels of lines that may lie close together are put at the left and at the right in turn.
std::string marks(const PlotPanel& panel) {
  std::string text = "unset arrow\nunset label\n";
  bool at_left = !panel.key_left;
  for (const PlotMark& mark : panel.marks) {
    std::string from, to, place;
    if (mark.vertical) {
      from = fmt::format("first {:.8g}, graph 0", mark.at);
      to = fmt::format("first {:.8g}, graph {:.3f}", mark.at, 1 - key_share(panel));
      place = fmt::format("first {:.8g}, graph 0.03 left offset 0.5,0", mark.at);
    } else {
      from = fmt::format("graph 0, first {:.8g}", mark.at);
      to = fmt::format("graph 1, first {:.8g}", mark.at);
      place = fmt::format("graph {}, first {:.8g} {} offset 0,0.5", at_left ? 0.015 : 0.985, mark.at,
                          at_left ? "left" : "right");
      at_left = !at_left;
    }
    text += fmt::format("set arrow from {} to {} nohead lc rgb '{}' lw 1.2 dt '.'\n", from, to, plot_ink);
    text += fmt::format("set label \"{}\" at {} font ',11' textcolor rgb '{}'\n", gnuplot_text(mark.label),
                        place, plot_ink);
  }
  return text;
}

std::string plot(const PlotPanel& panel, std::size_t panel_index) {
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? "plot " : ", \\\n     ") + item; };
  for (std::size_t i = 0; i < panel.guides.size(); ++i)
    add(fmt::format("$p{}g{} using 1:2 with lines lc rgb '#9A9A9A' lw 1.4 dt (8,6) title \"{}\"", panel_index,
                    i, gnuplot_text(panel.guides[i].title)));
  for (std::size_t i = 0; i < panel.lines.size(); ++i) {
    const auto& points = panel.lines[i].points;
    const PlotStyle style = plot_style(panel.lines[i].style);
    const auto any = [&](const auto& is) {
      return std::any_of(points.begin(), points.end(), [&](const auto& point) { return is(panel, point); });
    };
    std::string title =
        panel.key == PlotKey::shown ? "title \"" + gnuplot_text(panel.lines[i].title) + "\"" : "notitle";
    if (any(can_be_drawn)) {
      add(fmt::format("$p{}l{} using 1:2 with linespoints lc rgb '{}' lw 2 pt {} ps 0.75 {}", panel_index, i,
                      style.colour, style.point, title));
      title = "notitle";
    }
    // The hollow twin of each point type comes before it.
    if (any(is_zero))
      add(fmt::format("$p{}z{} using 1:2 with points lc rgb '{}' lw 1.5 pt {} ps 0.75 {}", panel_index, i,
                      style.colour, style.point - 1, title));
  }
  return (text.empty() ? "plot NaN notitle" : text) + "\n";
}

}  // namespace

int panels_width_px(std::size_t panels) {
  return 560 * static_cast<int>(panels);
}

std::string panels_script(const std::string& heading, std::span<const PlotPanel> panels) {
  return panels_script(heading, panels,
                       {.columns = static_cast<int>(panels.size()),
                        .rows = 1,
                        .width_px = panels_width_px(panels.size()),
                        .height_px = panels_height_px});
}

std::string panels_script(const std::string& heading, std::span<const PlotPanel> panels,
                          const PlotGrid& grid) {
  const double width_px = grid.width_px, height_px = grid.height_px;
  // In several rows only the first column names its axis.
  const double between_columns_px = grid.rows > 1 ? 62 : 108, between_rows_px = grid.row_gap_px;
  std::string script = fmt::format(
      "set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.6 textcolor rgb '{0}'\n"
      "set logscale {9}\nset format '%g'\nset mxtics 10\nset mytics 10\nset grid ytics lc rgb '#C8C8C8' lw "
      "0.5 dt solid\n"
      "set key textcolor rgb '{0}' Left reverse samplen 2 font ',12'\n"
      "set multiplot layout {8},{1} title \"{2}\" font ',13' textcolor rgb '{0}' "
      "margins {3:.4f},{4:.4f},{5:.4f},{6:.4f} spacing {7:.4f},{10}\n",
      plot_ink, grid.columns, gnuplot_text(heading), 92 / width_px, 1 - 16 / width_px, 72 / height_px,
      1 - 74 / height_px, between_columns_px / width_px, grid.rows,
      panels.empty() || !panels.front().linear_x ? "xy" : "y",
      grid.rows > 1 ? fmt::format("{:.4f}", between_rows_px / height_px) : "0");
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const PlotPanel& panel = panels[i];
    const Axes axes = axes_of(panel);
    script += blocks(panel, axes, i) + axes_text(panel, axes) + marks(panel) +
              fmt::format(
                  "set key {} top\nset title \"{}\" font ',15' textcolor rgb '{}' offset 0,-0.4\n"
                  "set xlabel \"{}\" textcolor rgb '{}'\nset ylabel \"{}\" textcolor rgb '{}' "
                  "offset 0,0\n",
                  panel.key_left ? "left" : "right", gnuplot_text(panel.title), plot_ink,
                  gnuplot_text(panel.x_label), plot_ink, gnuplot_text(panel.y_label), plot_ink) +
              plot(panel, i);
  }
  return script + "unset multiplot\n";
}

}  // namespace seamline
