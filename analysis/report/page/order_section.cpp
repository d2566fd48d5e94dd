#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {

namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string value_with_interval(double value, const Interval& ci95) {
  if (!std::isfinite(ci95.low) || !std::isfinite(ci95.high)) return decimal_text(value, 2) + " (no interval)";
  return fmt::format("{} ({} to {})", decimal_text(value, 2), decimal_text(ci95.low, 2),
                     decimal_text(ci95.high, 2));
}

std::string parts_html(const SessionOrder& order) {
  constexpr const char* names[] = {"first third", "second third", "last third"};
  Lines lines;
  for (std::size_t i = 0; i < order.thirds.size(); ++i)
    lines.push_back({names[i], std::to_string(order.thirds[i].answers),
                     value_with_interval(order.thirds[i].mean, order.thirds[i].ci95)});
  lines.push_back({"last third − first third", "",
                   value_with_interval(order.last_less_first, order.last_less_first_ci95)});
  lines.push_back({"last trial − first trial, by a straight line", "",
                   value_with_interval(order.trend, order.trend_ci95)});
  return html_table({{"part of the session"}, {"answers", true}, {"mean noticeability, 95 %", true}}, lines);
}

std::string halves_html(const SessionHalves& halves, const LevelAxis& axis) {
  std::string html = halves.missing.empty() ? contrast_table_html(halves.shifts, length_unit(axis))
                                            : html_paragraph(halves.missing);
  for (const std::string& note : halves.notes) html += html_paragraph(note);
  return html;
}

/// Those whose interval excludes 0; there may be some by chance.
std::string apart_html(const SessionOrder& order) {
  Lines lines;
  const auto add = [&](const MeanResidual& residual, const std::string& what, const std::string& name) {
    if (residual.ci95.low > 0 || residual.ci95.high < 0)
      lines.push_back(
          {what, name, std::to_string(residual.answers), value_with_interval(residual.mean, residual.ci95)});
  };
  for (const MeanResidual& residual : order.people_residuals) add(residual, "participant", residual.name);
  for (const MeanResidual& residual : order.object_residuals)
    add(residual, "object",
        fmt::format("{} {}, {}, {}", residual.object_index, residual.name, residual.scene,
                    artifact_title(residual.artifact, residual.condition)));
  const std::size_t all = order.people_residuals.size() + order.object_residuals.size();
  if (all == 0) return "";
  if (lines.empty())
    return html_paragraph(fmt::format(
        "No participant and no object lies apart: all {} intervals of mean residuals hold 0.", all));
  return html_paragraph(fmt::format(
             "Participants and objects whose mean residual has a 95 % interval without 0: {} of {}, of which "
             "one in twenty is expected where nobody and nothing differs.",
             lines.size(), all)) +
         html_table({{"what"}, {"name"}, {"answers", true}, {"mean residual, 95 %", true}}, lines) +
         "<p class=\"soft\">A participant’s residuals are scores less the mean over participants at the same "
         "stimuli; an object’s are less the mean over the artifact’s objects at the same levels. All are in "
         "<code>residuals.csv</code>.</p>\n";
}

}  // namespace

std::string order_html(const ReportNumbers& numbers, const std::vector<Figure>& figures) {
  const SessionOrder& order = numbers.order;
  std::string html = "<h2 id=\"order\">Order and residuals</h2>\n" + html_paragraph(trend_sentence(order));
  if (!order.thirds.empty()) html += figure_html(figures, "order") + parts_html(order);
  return html + halves_html(numbers.halves, numbers.axis) + apart_html(order);
}

}  // namespace seamline::analysis
