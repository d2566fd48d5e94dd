#include "analysis/report/page/thresholds_section.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/text/threshold_text.h"
#include "analysis/thresholds/angular_resolution.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

std::string planted_text(const ThresholdRow& row) {
  if (!row.planted) return "";
  return size_text(*row.planted, row.tested.axis);
}

std::string texels_text(const ThresholdEstimate& estimate) {
  return estimate.level_x ? fmt::format("{:.3g}", texels_per_degree(std::exp2(*estimate.level_x))) : "–";
}

std::string threshold_line(const ThresholdRow& row, bool planted, bool beside) {
  const std::string paper = row.paper_px ? fmt::format("{} × {}", *row.paper_px, *row.paper_px / 2) : "–";
  std::string line =
      fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td>{}</td>",
                  row.quantity == "PT" ? " class=\"group\"" : "",
                  row.quantity == "PT" ? html_escape(artifact_title(row.artifact, row.condition)) : "",
                  row.quantity, html_escape(size_text(row.here, row.tested.axis)),
                  html_escape(interval_text(row.here.ci95, row.tested)));
  if (of_depth_widths(row.tested.axis))
    line += fmt::format("<td class=\"number\">{}</td>", texels_text(row.here));
  if (beside) line += fmt::format("<td class=\"number\">{}</td>", paper);
  if (planted) line += fmt::format("<td class=\"number\">{}</td>", html_escape(planted_text(row)));
  return line + "</tr>\n";
}

}  // namespace

std::string threshold_table_html(const Analysis& analysis) {
  const bool planted = !analysis.planted.empty(), beside = beside_the_paper(analysis);
  const bool widths = of_depth_widths(analysis.data.axis);
  std::string table = fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th>artifact</th><th></th><th "
      "class=\"number\">{}</th><th>95 % interval{}</th>{}{}{}</tr></thead>\n<tbody>\n",
      html_escape(analysis.counts.simulated > 0 ? "simulated observers" : "this study"),
      widths ? " of W" : "", widths ? "<th class=\"number\">texels per degree</th>" : "",
      beside ? "<th class=\"number\">paper,<br>Table 1</th>" : "",
      planted ? "<th class=\"number\">planted</th>" : "");
  for (const ThresholdRow& row : threshold_rows(analysis)) table += threshold_line(row, planted, beside);
  return table + "</tbody></table></div>\n";
}

}  // namespace seamline::analysis
