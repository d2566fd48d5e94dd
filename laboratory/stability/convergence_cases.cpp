#include "laboratory/stability/convergence_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "laboratory/convergence/convergence_slope.h"
#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

using Points = std::vector<std::pair<double, double>>;

double observed_order(const Points& points) {
  std::vector<double> effort, error;
  for (const auto& [x, y] : points) {
    effort.push_back(x);
    error.push_back(y);
  }
  return log_log_slope(effort, error).value_or(nan);
}

/// Dashed, from the line's first point, with the expected slope.
PlotGuide guide_of(const OrderSeries& series, const Points& points) {
  const auto [least, most] = std::minmax_element(points.begin(), points.end());
  return {.title = fmt::format("slope {:g}", series.expected),
          .slope = series.expected,
          .x = points.front().first,
          .y = points.front().second,
          .x_from = least->first,
          .x_to = most->first};
}

StabilityCase case_of(const OrderSeries& series) {
  return {.group = "convergence",
          .name = series.name,
          .tried = series.tried,
          .expected = fmt::format("order {:g}", series.expected),
          .unit = "order",
          .tolerance = series.tolerance,
          .reason = series.reason,
          .run = [series](const StabilityOptions&) { return try_order(series); }};
}

}  // namespace

Finding try_order(const OrderSeries& series) {
  const Points points = series.measure();
  const double order = observed_order(points);
  return {std::abs(order - series.expected),
          fmt::format("order {:.3f}: {:.2g} at {:g}, {:.2g} at {:g}", order, points.front().second,
                      points.front().first, points.back().second, points.back().first)};
}

void draw_orders(const std::vector<OrderSeries>& series, const std::filesystem::path& svg) {
  std::vector<PlotPanel> panels;
  for (const OrderPanel& panel : order_panels())
    panels.push_back({.title = panel.title, .x_label = panel.x_label, .y_label = panel.y_label});
  for (const OrderSeries& one : series) {
    PlotPanel& panel = panels[one.panel];
    const Points points = one.measure();
    panel.lines.push_back({.title = fmt::format("{} ({:.2f})", one.line, observed_order(points)),
                           .points = points,
                           .style = panel.lines.size()});
    panel.guides.push_back(guide_of(one, points));
  }
  panels.back().key_left = true;
  draw_svg(svg, panels_width_px(panels.size()), panels_height_px,
           panels_script("observed orders of convergence", panels));
}

StabilityCases convergence_cases() {
  StabilityCases cases;
  for (const OrderSeries& series : order_series()) cases.push_back(case_of(series));
  return cases;
}

}  // namespace seamline::stability
