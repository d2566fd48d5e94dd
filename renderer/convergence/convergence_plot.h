#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace seamline::renderer {

/// One line of a panel.
struct PlotLine {
  std::string title;
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

/// A log-log panel of a figure. Zeros, which have no logarithm, are hollow points on the lower axis.
struct PlotPanel {
  std::string title, x_label, y_label;
  std::vector<PlotLine> lines = {};
  std::vector<PlotGuide> guides = {};
  std::vector<PlotMark> marks = {};
  bool powers_of_two = false;  ///< ticks of x at the points' own values
  bool falling_x = false;      ///< large values of x to the left
  bool key_left = false;
};

/// The gnuplot script of panels side by side under one heading, for `draw_svg` with `panels_width_px` and
/// `panels_height_px`.
[[nodiscard]] std::string panels_script(const std::string& heading, std::span<const PlotPanel> panels);
[[nodiscard]] int panels_width_px(std::size_t panels);
inline constexpr int panels_height_px = 470;

}  // namespace seamline::renderer
