#include "laboratory/convergence/convergence_estimate_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"

namespace seamline::renderer {
namespace {

/// The names of the lines, in order.
std::vector<std::string> series_names(const EstimateResult& result) {
  std::vector<std::string> names;
  for (const EstimateRow& row : result.rows)
    if (std::find(names.begin(), names.end(), row.series) == names.end()) names.push_back(row.series);
  return names;
}

/// What a figure says of its two axes.
enum class Against { amount, seconds };

PlotPanel estimate_panel(const EstimateResult& result, const FigureText& text, Against against) {
  const bool seconds = against == Against::seconds;
  PlotPanel panel{.title = seconds ? "against processor time" : "against " + result.amount,
                  .x_label = seconds ? "processor time of one estimate (s)" : result.amount,
                  .y_label = "root mean square error (" + result.unit + ")"};
  for (const std::string& name : series_names(result)) {
    PlotLine line{.title = name, .points = {}, .style = panel.lines.size()};
    const std::string of = seconds ? "error in seconds" : "error in " + result.amount;
    for (const SlopeRow& slope : text.slopes)
      if (slope.series == name && slope.of == of && slope.found)
        line.title = fmt::format("{} (slope {:.2f})", name, *slope.found);
    for (const EstimateRow& row : result.rows)
      if (row.series == name) line.points.emplace_back(seconds ? row.seconds : row.amount, row.error);
    panel.lines.push_back(std::move(line));
  }
  if (seconds) {
    panel.marks.push_back({.vertical = true, .at = result.limit.seconds_each, .label = result.limit.what});
    return panel;
  }
  const std::vector<std::pair<double, double>>& points = panel.lines.front().points;
  if (points.size() > 1)
    panel.guides.push_back({.title = fmt::format("slope {:g}", result.expected),
                            .slope = result.expected,
                            .x = points.front().first,
                            .y = points.front().second,
                            .x_from = points.front().first,
                            .x_to = points.back().first});
  return panel;
}

}  // namespace

PartTables tables_of(const EstimateResult& result) {
  PartTables out{.table = {.name = result.part,
                           .columns = {{"series", "", "what estimates"},
                                       {result.amount, "", "that one estimate has to work with"},
                                       {"seconds", "s", "processor time of one estimate"},
                                       {"error", result.unit, "root mean square against the truth"}},
                           .rows = {}},
                 .slopes = {},
                 .remarks = {}};
  for (const EstimateRow& row : result.rows)
    out.table.rows.push_back({row.series, row.amount, row.seconds, row.error});
  for (const std::string& name : series_names(result)) {
    std::vector<double> amounts, seconds, errors;
    for (const EstimateRow& row : result.rows)
      if (row.series == name && row.error > 0) {
        amounts.push_back(row.amount);
        seconds.push_back(row.seconds);
        errors.push_back(row.error);
      }
    if (amounts.size() < 3) continue;
    out.slopes.push_back({result.part, name, "error in " + result.amount, log_log_slope(amounts, errors),
                          result.expected, result.why});
    // Where more to work with costs no more, seconds decide nothing.
    const auto [quickest, longest] = std::minmax_element(seconds.begin(), seconds.end());
    if (*longest > 2 * *quickest)
      out.slopes.push_back(
          {result.part, name, "error in seconds", log_log_slope(seconds, errors), result.expected, ""});
  }
  out.remarks.push_back(fmt::format("The truth is {}. The machine's limit: {}, {:.2g} s.", result.truth,
                                    result.limit.what, result.limit.seconds_each));
  return out;
}

void draw_figure(const EstimateResult& result, const FigureText& text) {
  const std::vector<PlotPanel> panels = {estimate_panel(result, text, Against::amount),
                                         estimate_panel(result, text, Against::seconds)};
  draw_svg(text.svg, panels_width_px(panels.size()), panels_height_px,
           panels_script(text.subject + "; the truth is " + result.truth, panels));
}

}  // namespace seamline::renderer
