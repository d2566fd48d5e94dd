#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace seamline {

/// One line of a panel.
struct PlotLine {
  std::string title = {};  ///< empty: not in the key
  std::vector<std::pair<double, double>> points = {};
  std::size_t style = 0;  ///< index of colour and point type
};

/// A dashed grey line of a known slope through a point, from x_from to x_to.
struct PlotGuide {
  std::string title;
  double slope = 0, x = 1, y = 1, x_from = 1, x_to = 10;
};

/// A dotted line across the panel where x or y has a value, with a word beside it.
struct PlotMark {
  bool vertical = false;
  double at = 1;
  std::string label;
};

/// A tick and its label, which may be empty.
struct PlotTick {
  double at = 0;
  std::string label;
};

/// Whether the names of lines stand above the data; `room`: there is room for them only, so that the axis is
/// that of a panel that shows them.
enum class PlotKey { shown, room, none };

/// A log-log panel of a figure; an empty title or label takes its place all the same. Zeros of y, which have
/// no logarithm, are hollow points on the lower axis.
struct PlotPanel {
  std::string title = {}, x_label = {}, y_label = {};
  std::vector<PlotLine> lines = {};
  std::vector<PlotGuide> guides = {};
  std::vector<PlotMark> marks = {};
  bool powers_of_two = false;  ///< ticks of x at the points' own values
  bool falling_x = false;      ///< large values of x to the left
  bool key_left = false;
  PlotKey key = PlotKey::shown;
  bool linear_x = false;               ///< all panels of a figure alike
  std::vector<PlotTick> x_ticks = {};  ///< instead of those that the axis chooses
  /// Values of y beside the panel's own that its axis has room for, so that panels can have one axis.
  std::optional<std::pair<double, double>> y_room = {};
};

/// The gnuplot script of panels side by side under one heading, for `draw_svg` with `panels_width_px` and
/// `panels_height_px`.
[[nodiscard]] std::string panels_script(const std::string& heading, std::span<const PlotPanel> panels);
[[nodiscard]] int panels_width_px(std::size_t panels);
inline constexpr int panels_height_px = 470;

/// How panels lie in a figure, row after row from the top.
struct PlotGrid {
  int columns = 1, rows = 1;
  int width_px = 0, height_px = 0;  ///< of the whole figure
  int row_gap_px = 58;              ///< for labels of ticks; titles of the next row need more
};

/// The same for rows of panels, of which those below and beside others need no labels of their own.
[[nodiscard]] std::string panels_script(const std::string& heading, std::span<const PlotPanel> panels,
                                        const PlotGrid& grid);

}  // namespace seamline
